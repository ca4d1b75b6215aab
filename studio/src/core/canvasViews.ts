/** Places of the canvas that were given a name: what they hold, and the list of them. Nothing here knows a browser. */

import { clamp, FARTHEST, NEAREST, toCanvas, type Lens, type Point } from "./geometry";

export interface CanvasView {
  name: string;
  /** What stands in the middle of the window. */
  centre: Point;
  zoom: number;
  /** The clusters that lead to where it is, from the outermost. */
  within: readonly string[];
}

/** The most that a document has: what is kept in a browser must stay small. */
const MOST = 100;

/** What a window shows, as a view. */
export function viewOf(name: string, lens: Lens, [width, height]: Point, within: readonly string[]): CanvasView {
  return { name, centre: toCanvas(lens, [width / 2, height / 2]), zoom: lens.zoom, within: [...within] };
}

/** The lens that shows a view in a window of another size. */
export function lensOf({ centre, zoom }: CanvasView, [width, height]: Point): Lens {
  return { x: width / 2 - centre[0] * zoom, y: height / 2 - centre[1] * zoom, zoom };
}

/** The list with a view more; one of the same name is replaced. */
export function withView(views: readonly CanvasView[], view: CanvasView): CanvasView[] {
  const at = views.findIndex(({ name }) => name === view.name);
  if (at >= 0) return views.map((old, k) => (k === at ? view : old));
  return [...views, view].slice(-MOST);
}

/** The list with a view under another name; a name that another has, and an empty one, changes nothing. */
export function renamed(views: readonly CanvasView[], from: string, to: string): CanvasView[] {
  const name = to.trim();
  if (name === "" || views.some((view) => view.name === name)) return [...views];
  return views.map((view) => (view.name === from ? { ...view, name } : view));
}

export function without(views: readonly CanvasView[], name: string): CanvasView[] {
  return views.filter((view) => view.name !== name);
}

/** The first `View n` that is not there yet. */
export function freshName(views: readonly CanvasView[], numbered: (number: number) => string): string {
  for (let number = 1; ; number++) {
    const name = numbered(number);
    if (!views.some((view) => view.name === name)) return name;
  }
}

/** The view after or before another in the list; the first or the last where that is not in it. */
export function beside(views: readonly CanvasView[], name: string | undefined, by: 1 | -1): CanvasView | undefined {
  const at = views.findIndex((view) => view.name === name);
  if (at < 0) return by > 0 ? views[0] : views.at(-1);
  return views[(at + by + views.length) % views.length];
}

/** The views in a text that was kept; what makes no sense in it is left out. */
export function readViews(text: string | null): CanvasView[] {
  let found: unknown;
  try {
    found = JSON.parse(text ?? "[]");
  } catch {
    return [];
  }
  return Array.isArray(found) ? found.flatMap((one: unknown) => readView(one) ?? []).slice(0, MOST) : [];
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
