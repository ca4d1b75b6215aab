/** How far apart the lines of a grid are, for a view of some height. */

export interface GridSteps {
  /** Between thin lines, in model units: a power of ten. */
  minor: number;
  /** Between thick lines: ten times that. */
  major: number;
  /** How strongly thin lines show, from 0 (too close together) to 1. */
  strength: number;
}

/** Thin lines are never nearer to each other than this many pixels. */
const NEAREST = 7;

/** The steps where a pixel is `pixel` model units wide. */
export function gridSteps(pixel: number): GridSteps {
  const least = Math.max(pixel, 1e-12) * NEAREST;
  const exponent = Math.ceil(Math.log10(least));
  const minor = 10 ** exponent;
  // From the nearest distance to ten times that: faint at first, soon as strong as it gets.
  const strength = Math.min(1, Math.log10(minor / least) * 1.6 + 0.15);
  return { minor, major: minor * 10, strength };
}

/** The nearest point of a grid. */
export function snap(value: number, step: number): number {
  // Multiplied by whole numbers and divided again, so that 0.1 × 3 is 0.3.
  return step >= 1 ? Math.round(value / step) * step : Math.round(value / step) / Math.round(1 / step);
}
