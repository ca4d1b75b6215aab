/**
 * How curves bend, from the points that they are drawn by. All of them lie on the curve, so the circle through three
 * of them is the osculating circle as far as the drawing is fine; a curvature graph from the kernel is exact.
 */

import type { Point3 } from "./preview";

export interface Circle {
  centre: Point3;
  /** Unit vectors from the centre that span its plane; the first points at the middle of the three points. */
  x: Point3;
  y: Point3;
  radius: number;
}

/** Segments, two points each, as runs of points that follow each other. */
export function runsOf(positions: Float32Array, indices: Uint16Array | Uint32Array | null): Point3[][] {
  const count = indices ? indices.length : positions.length / 3;
  const point = (at: number): Point3 => {
    const vertex = (indices ? (indices[at] ?? 0) : at) * 3;
    return [positions[vertex] ?? 0, positions[vertex + 1] ?? 0, positions[vertex + 2] ?? 0];
  };
  const runs: Point3[][] = [];
  let run: Point3[] = [];
  for (let at = 0; at + 1 < count; at += 2) {
    const [from, to] = [point(at), point(at + 1)];
    const last = run.at(-1);
    if (!last || last[0] !== from[0] || last[1] !== from[1] || last[2] !== from[2]) {
      run = [from];
      runs.push(run);
    }
    run.push(to);
  }
  return runs;
}

/** The circle through three points; none through points on a line. */
export function circleThrough(before: Point3, at: Point3, after: Point3): Circle | undefined {
  const [a, b] = [minus(before, at), minus(after, at)];
  const normal = cross(a, b);
  const [aa, bb, nn] = [dot(a, a), dot(b, b), dot(normal, normal)];
  // The sine of the angle between them: below it all is rounding.
  if (!(nn > 1e-12 * aa * bb)) return undefined;
  const toCentre = scale(cross(minus(scale(b, aa), scale(a, bb)), normal), 1 / (2 * nn));
  const radius = Math.hypot(...toCentre);
  if (!(radius > 0) || !Number.isFinite(radius)) return undefined;
  const x = scale(toCentre, -1 / radius);
  const y = cross(scale(normal, 1 / Math.sqrt(nn)), x);
  return { centre: plus(at, toCentre), x, y, radius };
}

/** Where a drawn curve turns by more than this, it is a corner and has no curvature there. */
const CORNER = Math.cos(Math.PI / 5);

/** The teeth of a comb: from each point outwards, away from the centre, as long as the curvature times the scale. */
export function combOf(run: readonly Point3[], factor: number): { teeth: [Point3, Point3][]; tips: Point3[] } {
  const closed = run.length > 3 && same(run[0] as Point3, run.at(-1) as Point3);
  const teeth: [Point3, Point3][] = [];
  const last = run.length - 1;
  for (let at = closed ? 0 : 1; at < (closed ? run.length : last); at++) {
    const point = run[at] as Point3;
    const before = (at === 0 ? run[last - 1] : run[at - 1]) as Point3;
    const after = (at === last ? run[1] : run[at + 1]) as Point3;
    const circle = isCorner(before, point, after) ? undefined : circleThrough(before, point, after);
    teeth.push([point, circle ? plus(point, scale(circle.x, factor / circle.radius)) : point]);
  }
  return { teeth, tips: teeth.map(([, tip]) => tip) };
}

function isCorner(before: Point3, at: Point3, after: Point3): boolean {
  const [a, b] = [minus(at, before), minus(after, at)];
  return dot(a, b) < CORNER * Math.sqrt(dot(a, a) * dot(b, b));
}

/** The circle as segments. */
export function circlePoints({ centre, x, y, radius }: Circle, count: number): Point3[] {
  return Array.from({ length: count + 1 }, (_, at) => {
    const angle = (at / count) * 2 * Math.PI;
    return plus(centre, plus(scale(x, radius * Math.cos(angle)), scale(y, radius * Math.sin(angle))));
  });
}

function same(a: Point3, b: Point3): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}

function plus(a: Point3, b: Point3): Point3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function minus(a: Point3, b: Point3): Point3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function scale(a: Point3, factor: number): Point3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

function dot(a: Point3, b: Point3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Point3, b: Point3): Point3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
