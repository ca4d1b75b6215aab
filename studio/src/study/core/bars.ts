/** The bars of a histogram. */

import { ticks } from "d3-array";

import type { Axis } from "./axes";

export interface Bar {
  low: number;
  high: number;
  all: number;
  selected: number;
}

/** About how many bars there are: twice the cube root of the number of points (Rice's rule), at most so many. */
const MOST = 40;

/** Bars between round numbers; one for each word. */
export function barsOf({ values, domain, words }: Axis, selected: Uint8Array): Bar[] {
  const [low, high] = domain;
  const edges = words ? Array.from({ length: words.length + 1 }, (_, k) => k - 0.5) : edgesOf(low, high, values.length);
  const bars = edges.slice(1).map((edge, k) => ({ low: edges[k] ?? edge, high: edge, all: 0, selected: 0 }));
  const first = edges[0] ?? low;
  const width = ((edges[edges.length - 1] ?? high) - first) / bars.length;
  values.forEach((x, row) => {
    if (Number.isNaN(x)) return;
    let at = Math.min(bars.length - 1, Math.max(0, Math.floor((x - first) / width)));
    // Rounding may put a number that is an edge on the wrong side of it.
    while (at > 0 && x < (bars[at]?.low ?? x)) at -= 1;
    while (at < bars.length - 1 && x >= (bars[at]?.high ?? Infinity)) at += 1;
    const bar = bars[at];
    if (!bar) return;
    bar.all += 1;
    bar.selected += selected[row] ?? 0;
  });
  return bars;
}

function edgesOf(low: number, high: number, count: number): number[] {
  const wanted = Math.min(MOST, Math.max(5, Math.ceil(2 * Math.cbrt(count))));
  const inner = ticks(low, high, wanted);
  const step = (inner[1] ?? high) - (inner[0] ?? low);
  if (inner.length < 2 || !(step > 0)) return [low, high];
  const [first, last] = [inner[0] ?? low, inner[inner.length - 1] ?? high];
  return [...(first > low ? [first - step] : []), ...inner, ...(last < high ? [last + step] : [])];
}
