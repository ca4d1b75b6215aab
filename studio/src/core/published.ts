/** The list of inputs that a definition publishes, while it is edited. */

import type { ObjectView } from "./protocol/ObjectView";
import type { PlayerInput } from "./protocol/PlayerInput";

export interface Row extends PlayerInput {
  isShown: boolean;
}

/** A row for each control: the published ones in their order, then the others, which are shown where nothing is published. */
export function rowsOf(controls: readonly ObjectView[], published: readonly PlayerInput[] | null): Row[] {
  const first = (published ?? []).filter(({ object }) => controls.some(({ id }) => id === object)).map((input) => ({ ...input, isShown: true }));
  const others = controls.filter(({ id }) => !first.some(({ object }) => object === id));
  return [...first, ...others.map(({ id }) => ({ object: id, label: "", help: "", isShown: !published }))];
}

/** The rows with one of them a place up or down. */
export function movedRow(rows: readonly Row[], from: number, by: 1 | -1): Row[] {
  const to = from + by;
  const [one, other] = [rows[from], rows[to]];
  if (!one || !other) return [...rows];
  return rows.map((row, at) => (at === from ? other : at === to ? one : row));
}

/** What the rows publish. */
export function publishedOf(rows: readonly Row[]): PlayerInput[] {
  return rows.filter(({ isShown }) => isShown).map(({ object, label, help }) => ({ object, label: label.trim(), help: help.trim() }));
}
