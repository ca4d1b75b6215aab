/** The points of a scatter on a canvas. */

import type { Axis } from "./core/axes";

export interface Field {
  x: Axis;
  y: Axis;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Room at the ends of an axis, as a share of its length. */
const ROOM = 0.03;

/** The place of a number between two ends in pixels. */
export function between({ domain: [low, high], words }: Axis, value: number, from: number, to: number): number {
  const room = words ? 0 : ROOM;
  return from + (to - from) * (room + ((1 - 2 * room) * (value - low)) / (high - low));
}

/** Where a row stands; what has no value on an axis stands beside it. */
export function spot({ x, y, left, right, top, bottom }: Field, row: number): [number, number] {
  const [a, b] = [x.values[row] ?? NaN, y.values[row] ?? NaN];
  return [Number.isNaN(a) ? left - 12 : between(x, a, left, right), Number.isNaN(b) ? bottom + 12 : between(y, b, bottom, top)];
}

/** More points than these are drawn as squares, which is quicker; they are so small that nobody sees it. */
const MANY = 1500;

export function dots(context: CanvasRenderingContext2D, field: Field, rows: readonly number[], radius: number, count: number): void {
  if (count > MANY) {
    const side = radius * 1.7;
    for (const row of rows) {
      const [x, y] = spot(field, row);
      context.fillRect(x - side / 2, y - side / 2, side, side);
    }
    return;
  }
  context.beginPath();
  for (const row of rows) {
    const [x, y] = spot(field, row);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.fill();
}

export function crosses(context: CanvasRenderingContext2D, field: Field, rows: readonly number[], radius: number): void {
  context.beginPath();
  for (const row of rows) {
    const [x, y] = spot(field, row);
    context.moveTo(x - radius, y - radius);
    context.lineTo(x + radius, y + radius);
    context.moveTo(x + radius, y - radius);
    context.lineTo(x - radius, y + radius);
  }
  context.stroke();
}

/** Diamonds with an edge. */
export function diamonds(context: CanvasRenderingContext2D, field: Field, rows: readonly number[], radius: number): void {
  for (const row of rows) {
    const [x, y] = spot(field, row);
    context.beginPath();
    context.moveTo(x, y - radius);
    context.lineTo(x + radius, y);
    context.lineTo(x, y + radius);
    context.lineTo(x - radius, y);
    context.closePath();
    context.fill();
    context.stroke();
  }
}

/** A line through points. */
export function path(context: CanvasRenderingContext2D, field: Field, rows: readonly number[]): void {
  context.beginPath();
  rows.forEach((row, k) => {
    const [x, y] = spot(field, row);
    if (k === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.stroke();
}
