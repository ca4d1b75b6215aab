/** Components' pictures on a sheet of pixels: each is painted once for its size and colours, and then copied. */

import { pictureOf, type Place } from "./index";
import type { Piece, Tone } from "./piece";

export interface Inks {
  ink: string;
  accent: string;
}

const HOT = new Set<Tone>(["hot", "hotFill", "tint"]);
const OPACITY: Partial<Record<Tone, number>> = { faint: 0.5, shade: 0.16, tint: 0.35 };
const FILLED = new Set<Tone>(["shade", "tint", "fill", "hotFill"]);
/** Sizes in pixels go up in steps, so that zooming does not paint every picture at every size. */
const STEP = 4;
/** So many are kept of one theme; then all are painted anew. */
const MOST = 1000;

/** By colours, size and component: while the canvas is panned a picture is found without a word being put together. */
const sprites = new WeakMap<Inks, { count: number; sizes: Map<number, Map<string, HTMLCanvasElement>> }>();

/** The picture of a component, about so many pixels wide. */
export function sprite(id: string, name: string, place: Place | undefined, pixels: number, inks: Inks): HTMLCanvasElement {
  const size = Math.max(Math.ceil(pixels / STEP) * STEP, STEP);
  let kept = sprites.get(inks);
  if (!kept || kept.count >= MOST) sprites.set(inks, (kept = { count: 0, sizes: new Map() }));
  let ofSize = kept.sizes.get(size);
  if (!ofSize) kept.sizes.set(size, (ofSize = new Map()));
  const key = place ? id : name;
  const known = ofSize.get(key);
  if (known) return known;
  const canvas = painted(pictureOf(id, name, place), size, inks);
  ofSize.set(key, canvas);
  kept.count += 1;
  return canvas;
}

function painted(picture: readonly Piece[], size: number, { ink, accent }: Inks): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = size;
  canvas.height = size;
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  context.setTransform(size / 24, 0, 0, size / 24, -size / 96, -size / 96);
  context.lineCap = "round";
  context.lineJoin = "round";
  // From afar lines are a little wider than they are drawn: they would fade into the ground.
  context.lineWidth = Math.max(1.5, 24 / size);
  for (const [tone, path] of picture) {
    const colour = HOT.has(tone) ? accent : ink;
    context.globalAlpha = OPACITY[tone] ?? 1;
    context.setLineDash(tone === "dash" ? [1.5, 2.5] : []);
    if (FILLED.has(tone)) {
      context.fillStyle = colour;
      context.fill(new Path2D(path));
    } else {
      context.strokeStyle = colour;
      context.stroke(new Path2D(path));
    }
  }
  return canvas;
}
