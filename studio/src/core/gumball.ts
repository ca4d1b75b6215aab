/** The gumball: the maps that its grips make of how far they were dragged, along and about the axes of the world. */

import { along, cross, dot, minus } from "./frame";
import type { Point3 } from "./preview";
import type { Edit } from "./protocol/Edit";

export type Axis = 0 | 1 | 2;
export const AXES = ["x", "y", "z"] as const;

/** What a grip does along or about an axis; without an axis it moves freely. */
export type Grip = { does: "move"; axis: Axis | undefined } | { does: "turn" | "scale"; axis: Axis };

/** The first three rows of a matrix. */
export type Rows = Extract<Edit, { do: "transform" }>["map"];

const ALL: readonly Axis[] = [0, 1, 2];

/** Every grip, in the order in which the Tab key comes to them. */
export const GRIPS: readonly Grip[] = [
  { does: "move", axis: undefined },
  ...(["move", "turn", "scale"] as const).flatMap((does) => ALL.map((axis): Grip => ({ does, axis }))),
];

export function unit(axis: Axis): Point3 {
  return [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
}

/** The two axes across an axis, in the order in which a turn about it goes. */
export function across(axis: Axis): readonly [Axis, Axis] {
  return [((axis + 1) % 3) as Axis, ((axis + 2) % 3) as Axis];
}

/** A map whose columns are the images of the axes, and which leaves a point where it is. */
function about(fixed: Point3, columns: readonly [Point3, Point3, Point3]): Rows {
  const moved = along([0, 0, 0], [fixed[0], columns[0]], [fixed[1], columns[1]], [fixed[2], columns[2]]);
  const row = (k: Axis): Rows[0] => [columns[0][k], columns[1][k], columns[2][k], fixed[k] - moved[k]];
  return [row(0), row(1), row(2)];
}

export function moving(by: Point3): Rows {
  return [[1, 0, 0, by[0]], [0, 1, 0, by[1]], [0, 0, 1, by[2]]];
}

/** A turn about an axis through a point, by an angle in radians. */
export function turning(fixed: Point3, axis: Axis, angle: number): Rows {
  const [u, v] = across(axis);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const columns: [Point3, Point3, Point3] = [unit(0), unit(1), unit(2)];
  columns[u] = along([0, 0, 0], [cos, unit(u)], [sin, unit(v)]);
  columns[v] = along([0, 0, 0], [cos, unit(v)], [-sin, unit(u)]);
  return about(fixed, columns);
}

export function scaling(fixed: Point3, factors: Point3): Rows {
  const column = (axis: Axis) => along([0, 0, 0], [factors[axis], unit(axis)]);
  return about(fixed, [column(0), column(1), column(2)]);
}

export function imageOf(rows: Rows, point: Point3): Point3 {
  const row = (k: Axis) => rows[k][3] + dot([rows[k][0], rows[k][1], rows[k][2]], point);
  return [row(0), row(1), row(2)];
}

/** The angle from one point to another, seen against an axis through a third; from −π to π. */
export function angleAbout(middle: Point3, axis: Axis, from: Point3, to: Point3): number {
  const [a, b] = [minus(from, middle), minus(to, middle)];
  const way = unit(axis);
  const flat = dot(a, b) - dot(a, way) * dot(b, way);
  return Math.atan2(dot(cross(a, b), way), flat);
}

/** What a grip makes of an amount: a length for a move, degrees for a turn, a factor for a scale. */
export function mapOf(grip: Grip, middle: Point3, amount: number, isUniform = false): Rows {
  if (grip.axis === undefined) return moving([0, 0, 0]);
  if (grip.does === "move") return moving(along([0, 0, 0], [amount, unit(grip.axis)]));
  if (grip.does === "turn") return turning(middle, grip.axis, (amount * Math.PI) / 180);
  const factor = (axis: Axis) => (isUniform || axis === grip.axis ? amount : 1);
  return scaling(middle, [factor(0), factor(1), factor(2)]);
}
