/** What is selected after a click or a window. */

import { inside, meets, type Rect } from "./geometry";

/** What a pick does with what was selected before. */
export type Picking = "replace" | "add" | "remove";

export interface Keys {
  shift: boolean;
  ctrl: boolean;
  alt: boolean;
}

export const NO_KEYS: Keys = { shift: false, ctrl: false, alt: false };

/** Shift adds, Ctrl takes away. */
export function picking(keys: Keys): Picking {
  return keys.ctrl ? "remove" : keys.shift ? "add" : "replace";
}

export function picked(before: ReadonlySet<string>, ids: Iterable<string>, how: Picking): Set<string> {
  const after = new Set(how === "replace" ? [] : before);
  for (const id of ids) {
    if (how === "remove") after.delete(id);
    else after.add(id);
  }
  return after;
}

/** The objects that a window takes: drawn to the right those inside it, drawn to the left all that it touches. */
export function windowed(window: Rect, crossing: boolean, rects: Iterable<readonly [string, Rect]>): string[] {
  const taken: string[] = [];
  for (const [id, rect] of rects) if (crossing ? meets(rect, window) : inside(rect, window)) taken.push(id);
  return taken;
}

/** The selection grown along wires: to what it reads, or to what reads it. */
export function grownAlong(
  selection: ReadonlySet<string>,
  wires: Iterable<{ from: string; to: string }>,
  direction: "up" | "down",
): Set<string> {
  const after = new Set(selection);
  for (const { from, to } of wires) {
    if (direction === "up" && selection.has(to)) after.add(from);
    if (direction === "down" && selection.has(from)) after.add(to);
  }
  return after;
}
