/** The colours of points by the values of a column. */

import { interpolateViridis, schemeTableau10 } from "d3-scale-chromatic";

import type { Axis } from "./axes";

/** Numbers are put into so many colours, so that lines of a colour are drawn together. */
export const STEPS = 24;

/** The ends of the scale that are used: its darkest is not seen on dark, its brightest not on white. */
const ENDS = { light: [0, 0.82], dark: [0.28, 1] } as const;

export type Theme = keyof typeof ENDS;

/** The colour of a step. */
export function ramp(step: number, theme: Theme): string {
  const [low, high] = ENDS[theme];
  return interpolateViridis(low + ((high - low) * step) / (STEPS - 1));
}

/** All colours of an axis, from its lowest value to its highest. */
export function palette(axis: Axis | undefined, theme: Theme): string[] {
  if (!axis) return [theme === "dark" ? "#6fd49a" : "#0b6b3a"];
  if (axis.words && axis.words.length <= schemeTableau10.length) return schemeTableau10.slice(0, axis.words.length);
  return Array.from({ length: STEPS }, (_, step) => ramp(step, theme));
}

/** Which colour of the palette each row has; the last one after all others stands for no value. */
export function colourSteps(axis: Axis | undefined, count: number): Uint8Array {
  const steps = new Uint8Array(count);
  if (!axis) return steps;
  const [low, high] = axis.domain;
  const isFew = axis.words !== undefined && axis.words.length <= schemeTableau10.length;
  const colours = isFew ? (axis.words?.length ?? 1) : STEPS;
  axis.values.forEach((x, row) => {
    if (Number.isNaN(x)) steps[row] = colours;
    else if (isFew) steps[row] = x;
    else steps[row] = Math.min(STEPS - 1, Math.max(0, Math.floor(((x - low) / (high - low)) * STEPS)));
  });
  return steps;
}
