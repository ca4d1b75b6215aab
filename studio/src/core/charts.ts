/** Charts of data: bars, the parts of a whole, a line. All measures are in pixels from the top left. */

import type { Point } from "./geometry";
import type { Row } from "./protocol/Row";
import { polar } from "./radial";

/** More parts than this become one for all the rest. */
const MOST_PARTS = 24;
/** So many solutions are kept of a value. */
const MOST_KEPT = 200;
/** So many values are told in words. */
const MOST_TOLD = 20;
/** About the width of a digit of a label. */
const DIGIT = 5.5;
/** The height of a label. */
const LABEL = 10;

/** The items of each branch, as texts. */
export function branchesOf(rows: readonly Row[]): string[][] {
  const branches: string[][] = [];
  for (const row of rows) {
    if (row.is === "path") branches.push([]);
    else if (branches.length > 0) branches.at(-1)?.push(row.text);
    // The first rows may begin inside a branch.
    else branches.push([row.text]);
  }
  return branches;
}

/** The finite number that a text is; nothing for all else. */
export function numberOf(text: string): number | undefined {
  const value = text.trim() === "" ? NaN : Number(text);
  return Number.isFinite(value) ? value : undefined;
}

/** The finite numbers among texts. */
export function numbersOf(texts: readonly string[]): number[] {
  return texts.map(numberOf).filter((value) => value !== undefined);
}

export interface Bar {
  x: number;
  y: number;
  width: number;
  height: number;
  value: number;
  /** The branch it is from: each has a colour. */
  branch: number;
}

export interface BarChart {
  bars: Bar[];
  /** The height of the line of zero. */
  zero: number;
  /** Whether there is room for the values above the bars. */
  labels: boolean;
}

/** A bar for each number, from zero up or down. */
export function barChart(branches: readonly (readonly number[])[], [width, height]: Point): BarChart {
  const all = branches.flat();
  const step = width / Math.max(all.length, 1);
  const labels = all.length > 0 && step > DIGIT * Math.max(...all.map((value) => shortNumber(value).length));
  const room = labels ? LABEL : 0;
  const low = Math.min(0, ...all);
  const high = Math.max(0, ...all);
  // Room for the values of the highest bars, and of those that go down.
  const top = high > 0 ? room : 0;
  const bottom = height - (low < 0 ? room : 0);
  const range = high > low ? high - low : 1;
  const level = (value: number) => top + ((bottom - top) * (high - value)) / range;
  const gap = step > 3 ? 1 : 0;
  let k = 0;
  const bars = branches.flatMap((values, branch) =>
    values.map((value): Bar => {
      const y = level(Math.max(value, 0));
      return { x: step * k++ + gap / 2, y, width: step - gap, height: level(Math.min(value, 0)) - y, value, branch };
    }),
  );
  return { bars, zero: level(0), labels };
}

export interface Part {
  name: string;
  size: number;
}

/** The parts of a whole: numbers by their size, whatever their sign; all else by how often each is there. */
export function partsOf(texts: readonly string[]): Part[] {
  const numbers = texts.map(numberOf);
  const sizes = numbers.filter((value) => value !== undefined);
  let parts: Part[];
  if (sizes.length === texts.length) {
    parts = sizes.filter((value) => value !== 0).map((value) => ({ name: shortNumber(value), size: Math.abs(value) }));
  } else {
    const counts = new Map<string, number>();
    for (const text of texts) counts.set(text, (counts.get(text) ?? 0) + 1);
    parts = [...counts].map(([name, size]) => ({ name, size }));
  }
  if (parts.length <= MOST_PARTS) return parts;
  const rest = parts.splice(MOST_PARTS - 1);
  return [...parts, { name: "…", size: rest.reduce((sum, part) => sum + part.size, 0) }];
}

export interface Slice extends Part {
  /** Its part of the whole, 0 to 1. */
  share: number;
  /** Its outline about the origin. */
  path: string;
  /** Where its name stands; nothing where there is no room. */
  label: Point | undefined;
}

/** Slices of a circle about the origin, from the top the way of clocks. None without a size. */
export function slicesOf(parts: readonly Part[], radius: number): Slice[] {
  const whole = parts.reduce((sum, part) => sum + part.size, 0);
  if (!(whole > 0 && Number.isFinite(whole))) return [];
  const turn = 2 * Math.PI;
  let from = 0;
  return parts.map((part) => {
    const share = part.size / whole;
    const [a, b] = [from, from + share];
    from = b;
    const [ax, ay] = polar(turn * a, radius).map(hundredths);
    const [bx, by] = polar(turn * b, radius).map(hundredths);
    const [mx, my] = polar(turn * (a + share / 2), radius).map(hundredths);
    const arc = (x: number | undefined, y: number | undefined, long: number) => `A${radius},${radius} 0 ${long} 1 ${x},${y}`;
    // A whole circle has no corner to end at.
    const path =
      parts.length === 1 ? `M${ax},${ay}${arc(mx, my, 0)}${arc(bx, by, 0)}Z` : `M0,0L${ax},${ay}${arc(bx, by, share > 0.5 ? 1 : 0)}Z`;
    const room = share > 0.04 && turn * share * 0.65 * radius > DIGIT * Math.min(part.name.length, 6);
    return { ...part, share, path, label: room ? polar(turn * (a + share / 2), parts.length === 1 ? 0 : 0.65 * radius) : undefined };
  });
}

/** What values were from solution to solution: a list for each place, as many as are kept, the newest last. */
export type History = readonly (readonly number[])[];

/** A history with the values of one more solution. A place that has no value any more stays as it was. */
export function remember(history: History, values: readonly number[]): History {
  const places = Array.from({ length: Math.max(history.length, values.length) }, (_, place) => place);
  return places.map((place) => {
    const value = values[place];
    const known = history[place] ?? [];
    return value === undefined ? known : [...known, value].slice(-MOST_KEPT);
  });
}

/** A line through numbers one after the other, as the points of a polyline; from the lowest to the highest of `all`. */
export function lineOf(values: readonly number[], [width, height]: Point, all = values): Point[] {
  const low = Math.min(...all);
  const range = Math.max(...all) - low || 1;
  const last = Math.max(values.length - 1, 1);
  return values.map((value, k): Point => [(width * k) / last, height * (1 - (value - low) / range)]);
}

/** Values in words: the first of them, and how many there are when those are not all. */
export function told(texts: readonly string[]): string {
  const first = texts.slice(0, MOST_TOLD).join(", ");
  return texts.length > MOST_TOLD ? `${first}, … (${texts.length})` : first;
}

/** A number with three decimals at most. */
export function shortNumber(value: number): string {
  const rounded = Math.round(value * 1000) / 1000;
  return Math.abs(rounded) >= 1e7 ? value.toExponential(2) : String(rounded);
}

function hundredths(x: number): number {
  // Without a minus at zero.
  return Math.round(x * 100) / 100 + 0;
}
