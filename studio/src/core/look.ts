/** How an object stands, for its colour and its sign. */

import type { ObjectView } from "./protocol/ObjectView";
import type { ResultView } from "./protocol/ResultView";

export type Look = "plain" | "hidden" | "disabled" | "unsupported" | "empty" | "warning" | "error";

/** Signs beside the colours: who does not see the colour sees these. Plain objects have none. */
export const SIGNS: Record<Look, string> = {
  plain: "",
  hidden: "",
  disabled: "–",
  unsupported: "?",
  empty: "∅",
  warning: "!",
  error: "×",
};

/** An error counts more than a warning, and either more than that the preview is off. */
export function lookOf(object: ObjectView, result: ResultView | undefined): Look {
  if (object.disabled) return "disabled";
  if (object.support.is === "no" || result?.status === "unsupported") return "unsupported";
  if (result?.status === "error") return "error";
  if (result?.status === "warning") return "warning";
  if (result?.status === "no-data") return "empty";
  if (result?.status === "disabled") return "disabled";
  return object.hidden && object.previews ? "hidden" : "plain";
}

/** The worst that an object tells; remarks count least. */
export function balloon(result: ResultView | undefined): "remark" | "warning" | "error" | undefined {
  const levels = new Set(result?.messages.map((message) => message.level));
  return levels.has("error")
    ? "error"
    : levels.has("warning")
      ? "warning"
      : levels.has("remark")
        ? "remark"
        : undefined;
}
