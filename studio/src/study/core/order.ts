/** The order of the table's rows. */

import type { Cell, Row } from "./rows";

export interface Sort {
  /** `point`, `status`, `front`, or the place of a column. */
  by: "point" | "status" | "front" | number;
  descending: boolean;
}

/** Numbers before texts, both before nothing. */
export function compare(a: Cell | undefined, b: Cell | undefined): number {
  const rank = (cell: Cell | undefined) => (cell === null || cell === undefined || cell === "" ? 2 : typeof cell === "string" ? 1 : 0);
  const difference = rank(a) - rank(b);
  if (difference !== 0) return difference;
  if (rank(a) === 0) return Number(a) - Number(b);
  return rank(a) === 1 ? String(a).localeCompare(String(b)) : 0;
}

/** The places of rows in the order that is asked for; those without a value are last either way. */
export function sorted(places: readonly number[], rows: readonly Row[], { by, descending }: Sort, front: ReadonlySet<number>): number[] {
  const cell = (place: number): Cell | undefined => {
    const row = rows[place];
    if (by === "front") return front.has(place) ? 0 : 1;
    if (by === "point" || by === "status") return row?.[by];
    return row?.cells[by];
  };
  const isNothing = (value: Cell | undefined) => value === null || value === undefined || value === "";
  const turn = descending ? -1 : 1;
  return [...places].sort((a, b) => {
    const [x, y] = [cell(a), cell(b)];
    const order = compare(x, y);
    return (isNothing(x) || isNothing(y) ? order : turn * order) || a - b;
  });
}
