/** Numbers as colours: the map, the range that shows something, and the ticks of the legend. */

import type { Rgba } from "./preview";

/** From the least to the greatest: blue, cyan, green, yellow, red, as Rhino's curvature analysis. */
const STOPS: readonly Rgba[] = [
  [38, 70, 196, 255],
  [40, 174, 214, 255],
  [86, 184, 88, 255],
  [240, 212, 62, 255],
  [206, 54, 46, 255],
];

/** The colour at a place from 0 to 1. */
export function colourAt(place: number): Rgba {
  const along = Math.min(Math.max(place, 0), 1) * (STOPS.length - 1);
  const stop = Math.min(Math.floor(along), STOPS.length - 2);
  const [from, to] = [STOPS[stop] as Rgba, STOPS[stop + 1] as Rgba];
  const mix = (channel: 0 | 1 | 2) => Math.round(from[channel] + (to[channel] - from[channel]) * (along - stop));
  return [mix(0), mix(1), mix(2), 255];
}

/** The map as pixels, from the least to the greatest. */
export function colourRamp(size: number): Uint8Array {
  const pixels = new Uint8Array(size * 4);
  for (let at = 0; at < size; at++) pixels.set(colourAt(at / (size - 1)), at * 4);
  return pixels;
}

const SAMPLES = 20_000;

/**
 * The range from the 2nd to the 98th hundredth of all numbers: single vertices at a pole or a crease would else take
 * all colours for themselves. About 20 000 numbers at equal steps stand for more.
 */
export function usefulRange(all: readonly Float32Array[]): [number, number] | undefined {
  const total = all.reduce((sum, numbers) => sum + numbers.length, 0);
  if (total === 0) return undefined;
  const step = Math.max(1, Math.floor(total / SAMPLES));
  const samples: number[] = [];
  let skip = 0;
  for (const numbers of all) {
    let at = skip;
    for (; at < numbers.length; at += step) {
      const number = numbers[at] ?? NaN;
      if (Number.isFinite(number)) samples.push(number);
    }
    skip = at - numbers.length;
  }
  if (samples.length === 0) return undefined;
  samples.sort((a, b) => a - b);
  const low = samples[Math.floor((samples.length - 1) * 0.02)] ?? 0;
  const high = samples[Math.ceil((samples.length - 1) * 0.98)] ?? 0;
  // All the same but for rounding: the middle of the map, not noise in all colours.
  const least = Math.max(Math.abs(low), Math.abs(high), 1e-9) * 1e-3;
  if (high - low >= least) return [low, high];
  const middle = (low + high) / 2;
  const half = Math.max(Math.abs(middle), 1e-9) * 0.5;
  return [middle - half, middle + half];
}

/** A number in few digits, as a legend shows it. */
export function shortNumber(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}
