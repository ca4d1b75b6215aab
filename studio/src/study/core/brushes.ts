/** Brushes: the part of an axis that rows must lie in to be selected. */

import type { Axis } from "./axes";

export type Range = readonly [number, number];
/** By the keys of the axes. */
export type Brushes = ReadonlyMap<string, Range>;

/** For each row 1 where all brushes take it, else 0. Who has no value on a brushed axis is not taken. */
export function selectedBy(axes: readonly Axis[], brushes: Brushes, count: number): Uint8Array {
  const taken = new Uint8Array(count).fill(1);
  for (const { key, values } of axes) {
    const range = brushes.get(key);
    if (!range) continue;
    const [low, high] = range;
    for (let row = 0; row < count; row += 1) {
      const x = values[row] ?? NaN;
      if (!(x >= low && x <= high)) taken[row] = 0;
    }
  }
  return taken;
}

/** The brushes with one more, or without one that holds the whole axis. */
export function withBrush(brushes: Brushes, axis: Axis, range: Range | undefined): Brushes {
  const next = new Map(brushes);
  const fitted = range && fittedTo(axis, range);
  const isWhole = !fitted || (fitted[0] <= axis.domain[0] && fitted[1] >= axis.domain[1]);
  if (isWhole) next.delete(axis.key);
  else next.set(axis.key, fitted);
  return next;
}

/** A range with its ends in order and on the axis; for words, around whole ones. */
export function fittedTo({ domain: [least, most], words }: Axis, [a, b]: Range): Range {
  const clamp = (x: number) => Math.min(most, Math.max(least, x));
  const [low, high] = [clamp(Math.min(a, b)), clamp(Math.max(a, b))];
  if (!words) return [low, high];
  const first = Math.min(words.length - 1, Math.ceil(low));
  const last = Math.max(first, Math.floor(high));
  return [first - 0.5, last + 0.5];
}

/** How far a key moves an end of a brush. */
export function stepOf({ domain: [least, most], words }: Axis, isLarge: boolean): number {
  if (words) return 1;
  return (most - least) * (isLarge ? 0.1 : 0.01);
}

/** The brush after one of its ends was moved by a key: the ends do not go past each other. */
export function moved(axis: Axis, range: Range, end: "low" | "high", to: number): Range {
  const [low, high] = range;
  const [least, most] = axis.domain;
  const x = Math.min(most, Math.max(least, to));
  if (axis.words) return end === "low" ? [Math.min(x, high - 1), high] : [low, Math.max(x, low + 1)];
  return end === "low" ? [Math.min(x, high), high] : [low, Math.max(x, low)];
}
