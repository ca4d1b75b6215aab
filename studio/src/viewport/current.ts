/** The viewport that is on the page, for actions; and a window for tests to look at it. */

import type { Bounds, Rgba } from "../core/preview";
import type { Drawer } from "./tools/drawer";
import type { Viewport } from "./Viewport";

let viewport: Viewport | undefined;
let drawer: Drawer | undefined;

/** What picks and draws in the viewport that is on the page. */
export function currentDrawer(): Drawer | undefined {
  return drawer;
}

export function currentViewport(): Viewport | undefined {
  return viewport;
}

export interface ViewportStats {
  objects: number;
  parts: number;
  triangles: number;
  segments: number;
  drawables: number;
  bounds: Bounds | null;
  /** How many pictures were drawn so far. */
  frames: number;
  geometries: number;
  textures: number;
  isSoftware: boolean;
  isLost: boolean;
}

export interface ViewportHook {
  stats(): ViewportStats | undefined;
  /** The colour of a pixel as it would be drawn now. */
  pixel(x: number, y: number): Rgba | undefined;
  /** Draws at once, a quick picture where it is not to be fine; gives how many milliseconds it took until it was there. */
  draw(isFine?: boolean): number | undefined;
  /** Where a point of the model is in the active pane, in pixels. */
  place(point: readonly [number, number, number]): [number, number] | undefined;
}

declare global {
  interface Window {
    __studio?: { viewport?: ViewportHook };
  }
}

export function setCurrentViewport(next: Viewport | undefined, drawing?: Drawer): void {
  viewport = next;
  drawer = drawing;
  window.__studio = { ...window.__studio, viewport: hook };
}

const hook: ViewportHook = {
  stats() {
    if (!viewport) return undefined;
    const { model, frames, isSoftware } = viewport;
    return { objects: model.objects.size, bounds: model.bounds, frames, isSoftware, ...model.counts(), ...viewport.memory() };
  },
  pixel: (x, y) => viewport?.pixel(x, y),
  draw(isFine = true) {
    const start = performance.now();
    viewport?.draw(isFine);
    return viewport?.read(0, 0) && performance.now() - start;
  },
  place: (point) => viewport?.placeOf(point),
};
