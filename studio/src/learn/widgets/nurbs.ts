/**
 * Basis functions and derivatives of a NURBS curve, for pictures of them. The numbers of the page come from the kernel; these
 * only draw. Source: Piegl and Tiller, The NURBS Book, equations 2.5, 3.7 and 4.8.
 */

import type { NurbsView } from "../../core/protocol/NurbsView";

export type Vec = [number, number, number];
type Homogeneous = [number, number, number, number];

/** The knots as textbooks count them: one more at each end than openNURBS keeps. */
export function textbook(knots: readonly number[]): number[] {
  const [first = 0, last = 0] = [knots[0], knots.at(-1)];
  return [first, ...knots, last];
}

const at = (list: readonly number[], index: number): number => list[index] ?? 0;

/** The index of the span of a parameter: the last knot that is not greater, before the end of the domain. */
function spanOf(degree: number, full: readonly number[], t: number): number {
  const count = full.length - degree - 1;
  let span = degree;
  while (span < count - 1 && t >= at(full, span + 1)) span++;
  return span;
}

/** The values of all basis functions at a parameter; `full` are textbook knots. */
export function basis(degree: number, full: readonly number[], t: number): number[] {
  const count = full.length - degree - 1;
  const span = spanOf(degree, full, t);
  const values = new Array<number>(count).fill(0);
  let row = [1];
  for (let p = 1; p <= degree; p++) {
    const next = new Array<number>(p + 1).fill(0);
    for (let k = 0; k < p; k++) {
      const [low, high] = [at(full, span - p + 1 + k), at(full, span + 1 + k)];
      const share = high > low ? (t - low) / (high - low) : 0;
      next[k] = at(next, k) + (1 - share) * at(row, k);
      next[k + 1] = at(next, k + 1) + share * at(row, k);
    }
    row = next;
  }
  row.forEach((value, k) => (values[span - degree + k] = value));
  return values;
}

function homogeneous(curve: NurbsView): Homogeneous[] {
  return curve.points.map(([x, y, z], i) => {
    const w = at(curve.weights, i) || 1;
    return [x * w, y * w, z * w, w];
  });
}

function sum(degree: number, full: readonly number[], points: readonly Homogeneous[], t: number): Homogeneous {
  const total: Homogeneous = [0, 0, 0, 0];
  basis(degree, full, t).forEach((value, i) => points[i]?.forEach((x, axis) => (total[axis] = at(total, axis) + value * x)));
  return total;
}

/** The control points of the derivative, over the same knots without the outermost. */
function differences(degree: number, full: readonly number[], points: readonly Homogeneous[]): Homogeneous[] {
  return points.slice(1).map((next, i) => {
    const room = at(full, i + degree + 1) - at(full, i + 1);
    const factor = room > 0 ? degree / room : 0;
    return next.map((x, axis) => factor * (x - at(points[i] ?? [], axis))) as Homogeneous;
  });
}

const combine = (a: readonly number[], ...rest: [number, readonly number[]][]): Vec =>
  [0, 1, 2].map((axis) => rest.reduce((total, [factor, b]) => total + factor * at(b, axis), at(a, axis))) as Vec;

/** The point of a curve and its first two derivatives. */
export function jet(curve: NurbsView, t: number): [Vec, Vec, Vec] {
  let [degree, full, points] = [curve.degree, textbook(curve.knots), homogeneous(curve)];
  const all: Homogeneous[] = [];
  for (let k = 0; k < 3; k++) {
    all.push(degree >= 0 && points.length > 0 ? sum(degree, full, points, t) : [0, 0, 0, 0]);
    if (degree <= 0) {
      points = [];
      continue;
    }
    points = differences(degree, full, points);
    full = full.slice(1, -1);
    degree -= 1;
  }
  const [a, b, c] = all as [Homogeneous, Homogeneous, Homogeneous];
  const w = a[3] || 1;
  const over = (v: Vec): Vec => v.map((x) => x / w) as Vec;
  const point = over(combine(a));
  const first = over(combine(b, [-b[3], point]));
  const second = over(combine(c, [-2 * b[3], first], [-c[3], point]));
  return [point, first, second];
}

export const length = (v: Vec): number => Math.hypot(...v);

/** The curvature vector. */
export function bend([, first, second]: [Vec, Vec, Vec]): Vec {
  const speed = first[0] ** 2 + first[1] ** 2 + first[2] ** 2;
  if (speed === 0) return [0, 0, 0];
  const along = (first[0] * second[0] + first[1] * second[1] + first[2] * second[2]) / speed;
  return second.map((x, axis) => (x - along * at(first, axis)) / speed) as Vec;
}
