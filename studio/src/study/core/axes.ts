/** Columns as axes: where each row stands. */

import { extent } from "d3-array";

import type { Cell, Column, Row } from "./rows";

/** More different texts than these make no axis. */
export const MOST_WORDS = 30;

export interface Axis {
  /** Tells it from all others: `in.height`, `out.Area`, `status`. */
  key: string;
  name: string;
  kind: "in" | "out" | "status";
  /** The least and the largest number. */
  domain: readonly [number, number];
  /** The texts at 0, 1, 2 and so on, where it has no numbers. */
  words: readonly string[] | undefined;
  /** Where each row stands; NaN where it has no finite number. */
  values: Float64Array;
}

/** A domain that has a length. */
function widened(low: number, high: number): [number, number] {
  if (low < high) return [low, high];
  const room = Math.abs(low) * 1e-3 || 1;
  return [low - room, high + room];
}

function numbers(key: string, { name, kind }: Column, at: number, rows: readonly Row[]): Axis | undefined {
  const values = Float64Array.from(rows, ({ cells }) => {
    const cell = cells[at];
    return typeof cell === "number" ? cell : NaN;
  });
  const [low, high] = extent(values);
  if (low === undefined || high === undefined) return undefined;
  return { key, name, kind, domain: widened(low, high), words: undefined, values };
}

function words(key: string, name: string, kind: Axis["kind"], cells: readonly (Cell | undefined)[]): Axis | undefined {
  const texts = cells.map((cell) => (cell === null || cell === undefined || cell === "" ? undefined : String(cell)));
  const all = [...new Set(texts.filter((text) => text !== undefined))].sort();
  if (all.length === 0 || all.length > MOST_WORDS) return undefined;
  const places = new Map(all.map((word, at) => [word, at]));
  const values = Float64Array.from(texts, (text) => (text === undefined ? NaN : (places.get(text) ?? NaN)));
  return { key, name, kind, domain: [-0.5, all.length - 0.5], words: all, values };
}

/** The key of a column's axis. */
export const keyOf = ({ kind, name }: Column) => `${kind}.${name}`;

/**
 * The axes of all columns that have numbers or a few different texts, in their order; and one of the status, where rows differ
 * in it.
 */
export function axesOf(columns: readonly Column[], rows: readonly Row[]): Axis[] {
  const found = columns.map((column, at) => {
    const key = keyOf(column);
    return column.number ? numbers(key, column, at, rows) : words(key, column.name, column.kind, rows.map(({ cells }) => cells[at]));
  });
  const status = words("status", "status", "status", rows.map((row) => row.status));
  return [...found, status && status.words && status.words.length > 1 ? status : undefined].filter((axis) => axis !== undefined);
}

/** A number in a few digits. */
export function shown(x: number): string {
  if (!Number.isFinite(x)) return String(x);
  const size = Math.abs(x);
  if (x !== 0 && (size < 1e-4 || size >= 1e9)) return x.toExponential(3);
  return String(Number(x.toPrecision(size >= 1e5 ? 9 : 6)));
}

/** What stands at a place of an axis. */
export function label(axis: Axis, x: number): string {
  if (!axis.words) return shown(x);
  return Number.isInteger(x) ? (axis.words[x] ?? "") : "";
}

/** A cell as people read it. */
export function cellText(cell: Cell | undefined): string {
  if (cell === null || cell === undefined) return "";
  return typeof cell === "number" ? shown(cell) : String(cell);
}
