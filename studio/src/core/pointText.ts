/** Points as the text that ports keep them in: `{1, 2.5, -3}`, one a line, `{0;1}` on a line of its own a branch. */

import type { Point3 } from "./preview";
import type { Row } from "./protocol/Row";

const NUMBER = String.raw`[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?`;
const POINT = new RegExp(String.raw`^\s*\{?\s*(${NUMBER})\s*,\s*(${NUMBER})\s*,\s*(${NUMBER})\s*\}?\s*$`);

export function parsePoint(text: string): Point3 | undefined {
  const match = POINT.exec(text);
  if (!match) return undefined;
  const [x, y, z] = [Number(match[1]), Number(match[2]), Number(match[3])];
  return [x, y, z].every(Number.isFinite) ? [x, y, z] : undefined;
}

export function pointText([x, y, z]: Point3): string {
  return `{${x}, ${y}, ${z}}`;
}

/** The rows with another point in one of them. */
export function withPoint(rows: readonly Row[], which: number, point: Point3): Row[] {
  return rows.map((row, at) => (at === which && row.is === "item" ? { ...row, text: pointText(point) } : row));
}

/** Rows as the text to keep. */
export function rowsText(rows: readonly Row[]): string {
  return rows.map((row) => (row.is === "path" ? row.path : row.text)).join("\n");
}
