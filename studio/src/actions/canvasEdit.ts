/** Undo, the clipboard and deleting, on the canvas. */

import { pointerAt } from "../canvas/gestures/bind";
import { duplicate, remove, selection } from "../canvas/edits";
import { say } from "../canvas/store";
import { canvasPoint, paneSize } from "../canvas/view";
import { readClipboard, writeClipboard } from "../core/clipboard";
import { holds, type Point } from "../core/geometry";
import { grownAlong } from "../core/selection";
import { wiresOf } from "../core/places";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { ask, edit } from "../state/session";
import { select, uiStore } from "../state/ui";
import { register } from "./registry";

const some = () => selection().length > 0;

/** Goes a step back or forth, and says which it was. */
async function stepped(way: "undo" | "redo"): Promise<void> {
  const step = documentStore.getState().document?.[way] ?? "";
  try {
    await ask({ ask: way });
    say(t(way === "undo" ? "canvas.undone" : "canvas.redone", { step }));
  } catch {
    // What was refused stands in the line below.
  }
}

async function copy(): Promise<number> {
  const objects = selection();
  if (objects.length === 0) return 0;
  try {
    const answer = await ask({ ask: "copy", objects, within: documentStore.getState().within });
    if (answer.event !== "copied") return 0;
    await writeClipboard(answer.text);
    say(t("canvas.copied", { count: objects.length }));
    return objects.length;
  } catch {
    return 0;
  }
}

/** Where pasted things go: to the pointer when it is over the canvas, else to the middle of what is seen. */
function pastePlace(): Point {
  const [w, h] = paneSize();
  const [a, b] = [canvasPoint([0, 0]), canvasPoint([w, h])];
  const at = pointerAt();
  return holds([a[0], a[1], b[0] - a[0], b[1] - a[1]], at) ? at : [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/** Pastes what Grasshopper or Katydid copied. */
export async function paste(told?: string): Promise<void> {
  const at = pastePlace();
  const text = await readClipboard(told);
  if (text.trim() === "") return;
  const done = await edit({ do: "paste", text, at: [...at], seed: crypto.randomUUID() });
  if (done?.event !== "done" || done.made.length === 0) return;
  select(done.made);
  say(t("canvas.pasted", { count: done.made.length }));
}

function grow(direction: "up" | "down"): void {
  const { objects, outputs } = documentStore.getState();
  const wires = [...wiresOf(objects, outputs)].map(({ source, target }) => ({ from: source, to: target }));
  select(grownAlong(uiStore.getState().selection, wires, direction));
}

register(
  {
    id: "edit.undo",
    label: "canvas.action.undo",
    keys: ["Mod+Z"],
    group: "edit",
    isEnabled: () => Boolean(documentStore.getState().document?.undo),
    run: () => stepped("undo"),
  },
  {
    id: "edit.redo",
    label: "canvas.action.redo",
    keys: ["Mod+Y", "Mod+Shift+Z"],
    group: "edit",
    isEnabled: () => Boolean(documentStore.getState().document?.redo),
    run: () => stepped("redo"),
  },
  {
    id: "edit.cut",
    label: "canvas.action.cut",
    keys: ["Mod+X"],
    group: "edit",
    scope: "canvas",
    isEnabled: some,
    async run() {
      const objects = selection();
      if ((await copy()) > 0) await remove(objects);
    },
  },
  {
    id: "edit.copy",
    label: "canvas.action.copy",
    keys: ["Mod+C"],
    group: "edit",
    scope: "canvas",
    isEnabled: some,
    run: () => void copy(),
  },
  {
    id: "edit.paste",
    label: "canvas.action.paste",
    keys: ["Mod+V"],
    group: "edit",
    scope: "canvas",
    run: () => paste(),
  },
  {
    id: "edit.duplicate",
    label: "canvas.action.duplicate",
    keys: ["Mod+D"],
    group: "edit",
    scope: "canvas",
    isEnabled: some,
    run: () => duplicate(selection(), [20, 20]),
  },
  {
    id: "edit.delete",
    label: "canvas.action.delete",
    keys: ["Delete", "Backspace"],
    group: "edit",
    scope: "canvas",
    isEnabled: some,
    run: () => remove(selection()),
  },
  {
    id: "edit.selectAll",
    label: "canvas.action.selectAll",
    keys: ["Mod+A"],
    group: "edit",
    scope: "canvas",
    run: () => select(documentStore.getState().order),
  },
  { id: "edit.selectNone", label: "canvas.action.selectNone", group: "edit", isEnabled: some, run: () => select([]) },
  {
    id: "edit.invert",
    label: "canvas.action.invert",
    group: "edit",
    run() {
      const chosen = uiStore.getState().selection;
      select(documentStore.getState().order.filter((id) => !chosen.has(id)));
    },
  },
  { id: "edit.growUp", label: "canvas.action.growUp", group: "edit", isEnabled: some, run: () => grow("up") },
  { id: "edit.growDown", label: "canvas.action.growDown", group: "edit", isEnabled: some, run: () => grow("down") },
);
