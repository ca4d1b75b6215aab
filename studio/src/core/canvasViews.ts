/** Places of the canvas that were given a name: what they hold, and the list of them. Nothing here knows a browser. */

import { clamp, FARTHEST, NEAREST, toCanvas, type Lens, type Point } from "./geometry";
import { readNamed } from "./named";

export interface CanvasView {
  name: string;
  /** What stands in the middle of the window. */
  centre: Point;
  zoom: number;
  /** The clusters that lead to where it is, from the outermost. */
  within: readonly string[];
}

/** What a window shows, as a view. */
export function viewOf(name: string, lens: Lens, [width, height]: Point, within: readonly string[]): CanvasView {
  return { name, centre: toCanvas(lens, [width / 2, height / 2]), zoom: lens.zoom, within: [...within] };
}

/** The lens that shows a view in a window of another size. */
export function lensOf({ centre, zoom }: CanvasView, [width, height]: Point): Lens {
  return { x: width / 2 - centre[0] * zoom, y: height / 2 - centre[1] * zoom, zoom };
}

/** The view after or before another in the list; the first or the last where that is not in it. */
export function beside(views: readonly CanvasView[], name: string | undefined, by: 1 | -1): CanvasView | undefined {
  const at = views.findIndex((view) => view.name === name);
  if (at < 0) return by > 0 ? views[0] : views.at(-1);
  return views[(at + by + views.length) % views.length];
}

/** The views in a text that was kept; what makes no sense in it is left out. */
export function readViews(text: string | null): CanvasView[] {
  return readNamed(text, readView);
}

function readView(value: unknown): CanvasView | undefined {
  if (typeof value !== "object" || value === null) return undefined;
  const { name, centre, zoom, within } = value as Record<string, unknown>;
  if (typeof name !== "string" || name === "" || typeof zoom !== "number" || !Number.isFinite(zoom)) return undefined;
  const [x, y] = Array.isArray(centre) ? (centre as unknown[]) : [];
  if (typeof x !== "number" || typeof y !== "number" || !Number.isFinite(x) || !Number.isFinite(y)) return undefined;
  const ids: unknown[] = Array.isArray(within) ? within : [];
  return {
    name: name.slice(0, 200),
    centre: [x, y],
    zoom: clamp(zoom, FARTHEST, NEAREST),
    within: ids.filter((id) => typeof id === "string"),
  };
}
