/** The lines of parallel coordinates on a canvas. */

import type { Axis } from "./core/axes";

export interface Lines {
  axes: readonly Axis[];
  /** Where each axis stands, in pixels. */
  xs: readonly number[];
  top: number;
  bottom: number;
  /** Where what has no value goes, below the axes. */
  gap: number;
}

/** The place of a value on an axis, in pixels. */
export function heightOf({ domain: [low, high] }: Axis, x: number, { top, bottom, gap }: Pick<Lines, "top" | "bottom" | "gap">): number {
  return Number.isNaN(x) ? gap : bottom - ((x - low) / (high - low)) * (bottom - top);
}

function add(context: CanvasRenderingContext2D, lines: Lines, row: number): void {
  const { axes, xs } = lines;
  for (let k = 0; k < axes.length; k += 1) {
    const axis = axes[k];
    if (!axis) continue;
    const [x, y] = [xs[k] ?? 0, heightOf(axis, axis.values[row] ?? NaN, lines)];
    if (k === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
}

/** Lines in one path are drawn faster, until the path is so long that they are drawn slower. */
const TOGETHER = 128;

/** Draws rows in the colour that is set. */
export function strokeRows(context: CanvasRenderingContext2D, lines: Lines, rows: readonly number[]): void {
  for (let from = 0; from < rows.length; from += TOGETHER) {
    context.beginPath();
    const end = Math.min(rows.length, from + TOGETHER);
    for (let k = from; k < end; k += 1) add(context, lines, rows[k] ?? 0);
    context.stroke();
  }
}

/** How strongly so many lines are drawn. */
export const strength = (count: number) => Math.max(0.1, Math.min(0.9, 14 / Math.sqrt(Math.max(1, count))));

/** Rows by their colour. */
export function byColour(rows: readonly number[], steps: Uint8Array, colours: number): number[][] {
  const found: number[][] = Array.from({ length: colours + 1 }, () => []);
  for (const row of rows) found[Math.min(colours, steps[row] ?? 0)]?.push(row);
  return found;
}
