/** How an object stands, for its colour and its sign. */

import type { ObjectView } from "./protocol/ObjectView";
import type { OutputView } from "./protocol/OutputView";
import type { PortView } from "./protocol/PortView";
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

/**
 * Whether an input is wired and nothing comes over its wires. An optional input lets its object run without data, but who
 * drew a wire meant something to come.
 */
export function isStarved(object: ObjectView, outputs: Outputs): boolean {
  return object.inputs.some((port) => isDry(port, outputs));
}

/** The inputs that an object waits for: wired ones that nothing comes to, and those that it cannot do without. */
export function emptyInputs(object: ObjectView, outputs: Outputs): PortView[] {
  const isOpen = ({ sources, optional, kept }: PortView) => sources.length === 0 && !optional && kept === 0;
  return object.inputs.filter((port) => isDry(port, outputs) || isOpen(port));
}

type Outputs = ReadonlyMap<string, OutputView>;

function isDry({ sources }: PortView, outputs: Outputs): boolean {
  return sources.length > 0 && sources.every((source) => outputs.get(source)?.structure === "empty");
}

/** An error counts more than a warning, and either more than that the preview is off. */
export function lookOf(object: ObjectView, result: ResultView | undefined, starved = false): Look {
  if (object.disabled) return "disabled";
  if (object.support.is === "no" || result?.status === "unsupported") return "unsupported";
  if (result?.status === "error") return "error";
  if (result?.status === "warning") return "warning";
  if (result?.status === "disabled") return "disabled";
  if (result && (result.status === "no-data" || starved)) return "empty";
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
