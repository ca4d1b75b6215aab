/** The handles about a selection that line it up or spread it: where each stands around the selection's rectangle. */

import type { Point, Rect } from "./geometry";
import type { Alignment } from "./protocol/Alignment";

export interface AlignHandle {
  how: Alignment;
  /** The middle of the handle, in the coordinates of the rectangle. */
  at: Point;
}

/** From the frame to the middles of handles, and between handles beside each other, in pixels. */
const AWAY = 20;
const APART = 26;

/**
 * Above the rectangle the handles for edges and middles across, each where it lines things up; at its left those for
 * edges and middles down; below and at its right those that spread. A small rectangle has them side by side, so that
 * they never cover each other.
 */
export function alignHandles(rect: Rect): AlignHandle[] {
  const [x, y, w, h] = atLeast(rect, 2 * APART + 4);
  const across = places(x, w);
  const down = places(y, h);
  return [
    { how: "left", at: [across[0], y - AWAY] },
    { how: "centre", at: [across[1], y - AWAY] },
    { how: "right", at: [across[2], y - AWAY] },
    { how: "top", at: [x - AWAY, down[0]] },
    { how: "middle", at: [x - AWAY, down[1]] },
    { how: "bottom", at: [x - AWAY, down[2]] },
    { how: "spreadAcross", at: [x + w / 2, y + h + AWAY] },
    { how: "spreadDown", at: [x + w + AWAY, y + h / 2] },
  ];
}

/** The rectangle, grown about its middle to so much on each side. */
function atLeast([x, y, w, h]: Rect, least: number): Rect {
  const [width, height] = [Math.max(w, least), Math.max(h, least)];
  return [x + (w - width) / 2, y + (h - height) / 2, width, height];
}

function places(low: number, size: number): [number, number, number] {
  const middle = low + size / 2;
  const half = Math.max(size / 2 - APART / 2, APART);
  return [middle - half, middle, middle + half];
}

/** The part of a rectangle that is in the window, so that handles of a selection larger than the window can be reached. */
export function within([x, y, w, h]: Rect, [width, height]: Point, margin: number): Rect | undefined {
  const [left, top] = [Math.max(x, margin), Math.max(y, margin)];
  const [right, bottom] = [Math.min(x + w, width - margin), Math.min(y + h, height - margin)];
  return right > left && bottom > top ? [left, top, right - left, bottom - top] : undefined;
}
