/** Gradients by their grips: colours between them, grips added and taken away, and some to begin with. */

import type { Colour } from "./colours";
import { clamp } from "./geometry";
import type { GripView } from "./protocol/GripView";

export function sorted(grips: readonly GripView[]): GripView[] {
  return [...grips].sort((a, b) => a.at - b.at);
}

/** The colour at a place, as a gradient that is even between its grips has it. */
export function colourAt(grips: readonly GripView[], at: number): GripView["left"] {
  const order = sorted(grips);
  const after = order.findIndex((grip) => grip.at >= at);
  const right = order[after];
  const left = after < 0 ? order.at(-1) : order[after - 1];
  if (!left) return right ? [...right.left] : [128, 128, 128, 255];
  if (!right) return [...left.right];
  const along = right.at > left.at ? (at - left.at) / (right.at - left.at) : 0;
  const mix = (k: 0 | 1 | 2 | 3) => Math.round(left.right[k] + along * (right.left[k] - left.right[k]));
  return [mix(0), mix(1), mix(2), mix(3)];
}

/** The grips with one more at a place, in the colour that is there: the picture stays as it is. */
export function withGrip(grips: readonly GripView[], at: number): GripView[] {
  const place = clamp(at, 0, 1);
  const colour = colourAt(grips, place);
  return [...grips, { at: place, left: colour, right: [...colour] }];
}

/** The grips without one of them; the last one stays. */
export function withoutGrip(grips: readonly GripView[], index: number): GripView[] {
  return grips.length < 2 ? [...grips] : grips.filter((_, k) => k !== index);
}

export function mirrored(grips: readonly GripView[]): GripView[] {
  return sorted(grips.map(({ at, left, right }) => ({ at: 1 - at, left: right, right: left })));
}

export const PRESETS = ["greys", "spectrum", "traffic", "heat", "ice", "earth", "diverging", "stripes"] as const;
export type Preset = (typeof PRESETS)[number];

type Stop = readonly [at: number, r: number, g: number, b: number];

const STOPS: Record<Exclude<Preset, "stripes">, readonly Stop[]> = {
  greys: [[0, 0, 0, 0], [1, 255, 255, 255]],
  spectrum: [[0, 255, 0, 0], [0.2, 255, 255, 0], [0.4, 0, 200, 0], [0.6, 0, 220, 220], [0.8, 0, 60, 255], [1, 200, 0, 220]],
  traffic: [[0, 30, 160, 50], [0.5, 250, 220, 40], [1, 210, 30, 30]],
  heat: [[0, 0, 0, 0], [0.35, 170, 10, 10], [0.7, 255, 160, 20], [1, 255, 255, 220]],
  ice: [[0, 5, 20, 70], [0.5, 30, 130, 200], [1, 235, 250, 255]],
  earth: [[0, 20, 70, 130], [0.3, 110, 170, 110], [0.6, 200, 180, 110], [1, 250, 250, 245]],
  diverging: [[0, 40, 80, 180], [0.5, 245, 245, 245], [1, 190, 40, 40]],
};

/** The grips of a gradient to begin with. */
export function preset(name: Preset): GripView[] {
  if (name === "stripes") return stripes(8);
  return STOPS[name].map(([at, r, g, b]) => both(at, [r, g, b, 255]));
}

/** Black and white in turn, without anything between. */
function stripes(count: number): GripView[] {
  const grey = (k: number): GripView["left"] => (k % 2 === 0 ? [0, 0, 0, 255] : [255, 255, 255, 255]);
  return Array.from({ length: count - 1 }, (_, k) => ({ at: (k + 1) / count, left: grey(k), right: grey(k + 1) }));
}

function both(at: number, [r, g, b, a]: Colour): GripView {
  return { at, left: [r, g, b, a], right: [r, g, b, a] };
}
