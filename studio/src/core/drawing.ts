/** What is drawn in the viewport: which points it takes, what it is, and how it looks while it is drawn. */

import { along, coordinatesIn, cross, distance, dot, minus, type Frame } from "./frame";
import type { Point3 } from "./preview";
import type { Drawing } from "./protocol/Drawing";

export type DrawTool = Drawing["is"];

const CURVES: readonly DrawTool[] = ["line", "polyline", "interpolated", "circle", "rectangle"];

/** What can be drawn for an input of a type. */
export function toolsFor(kind: string): readonly DrawTool[] {
  switch (kind) {
    case "Point":
      return ["point"];
    case "Line":
    case "Plane":
    case "Vector":
    case "Circle":
    case "Rectangle":
      return [kind.toLowerCase() as DrawTool];
    case "Curve":
      return CURVES;
    case "Geometry":
      return ["point", ...CURVES];
    default:
      return [];
  }
}

/** The types of inputs that geometry is picked or drawn for. */
export const SETTABLE: ReadonlySet<string> = new Set([
  "Point", "Curve", "Line", "Circle", "Arc", "Rectangle", "Surface", "Brep", "Box", "Mesh", "SubD", "Geometry", "Plane", "Vector",
]);

/** After how many points a drawing is done; those that go on are ended by hand. */
export function lastPoint(tool: DrawTool): number {
  return tool === "point" ? 1 : tool === "polyline" || tool === "interpolated" ? Infinity : 2;
}

const triple = ([x, y, z]: Point3): [number, number, number] => [x, y, z];

/** A drawing by its points; undefined while they are too few or make nothing. */
export function drawingOf(tool: DrawTool, points: readonly Point3[], frame: Frame, closed = false): Drawing | undefined {
  const [first, second] = points;
  if (!first) return undefined;
  if (tool === "point") return { is: "point", at: triple(first) };
  if (!second) return undefined;
  const plane = { origin: triple(first), x: triple(frame.x), y: triple(frame.y) };
  switch (tool) {
    case "vector":
      return distance(first, second) > 0 ? { is: "vector", along: triple(minus(second, first)) } : undefined;
    case "plane": {
      const x = minus(second, first);
      return inPlane(frame, first, second) > 0 ? { is: "plane", plane: { origin: plane.origin, x: triple(x), y: triple(cross(frame.z, x)) } } : undefined;
    }
    case "line":
      return distance(first, second) > 0 ? { is: "line", ends: [triple(first), triple(second)] } : undefined;
    case "circle": {
      const radius = inPlane(frame, first, second);
      return radius > 0 ? { is: "circle", plane, radius } : undefined;
    }
    case "rectangle": {
      const size = sides(frame, first, second);
      return size[0] !== 0 && size[1] !== 0 ? { is: "rectangle", plane, size } : undefined;
    }
    case "polyline": {
      const all = closed && points.length > 2 ? [...points, first] : points;
      return { is: "polyline", points: all.map(triple) };
    }
    case "interpolated":
      return { is: "interpolated", points: points.map(triple), closed: closed && points.length > 2 };
  }
}

function sides({ x, y }: Frame, from: Point3, to: Point3): [number, number] {
  const away = minus(to, from);
  return [dot(away, x), dot(away, y)];
}

function inPlane(frame: Frame, from: Point3, to: Point3): number {
  return Math.hypot(...sides(frame, from, to));
}

const SEGMENTS = 72;
/** Segments between two points of an interpolated curve. */
const FINE = 12;

/** The lines that show a drawing while it is made. The kernel's own curve takes their place when it is done. */
export function outline(tool: DrawTool, points: readonly Point3[], frame: Frame): readonly Point3[] {
  const [first, second] = points;
  if (!first || !second) return points;
  const { x, y, z } = frame;
  if (tool === "plane") {
    const u = minus(second, first);
    const v = cross(z, u);
    return [first, second, along(second, [1, v]), along(first, [1, v]), first];
  }
  if (tool === "circle") {
    const radius = inPlane(frame, first, second);
    return Array.from({ length: SEGMENTS + 1 }, (_, k) => {
      const angle = (2 * Math.PI * k) / SEGMENTS;
      return along(first, [radius * Math.cos(angle), x], [radius * Math.sin(angle), y]);
    });
  }
  if (tool === "rectangle") {
    const [u, v] = sides(frame, first, second);
    return [first, along(first, [u, x]), along(first, [u, x], [v, y]), along(first, [v, y]), first];
  }
  return tool === "interpolated" ? smooth(points) : points;
}

/** A curve through points (Catmull and Rom's, with knots by distance): near to the cubic that the kernel makes. */
function smooth(points: readonly Point3[]): Point3[] {
  if (points.length < 3) return [...points];
  const at = (k: number) => points[Math.min(Math.max(k, 0), points.length - 1)] as Point3;
  const found: Point3[] = [at(0)];
  for (let k = 0; k + 1 < points.length; k++) {
    const [a, b, c, d] = [at(k - 1), at(k), at(k + 1), at(k + 2)];
    const length = distance(b, c);
    const [out, into] = [tangent(a, b, c), tangent(b, c, d)];
    for (let step = 1; step <= FINE; step++) {
      const s = step / FINE;
      const [s2, s3] = [s * s, s * s * s];
      const shares = [2 * s3 - 3 * s2 + 1, (s3 - 2 * s2 + s) * length, 3 * s2 - 2 * s3, (s3 - s2) * length] as const;
      found.push(along([0, 0, 0], [shares[0], b], [shares[1], out], [shares[2], c], [shares[3], into]));
    }
  }
  return found;
}

/** The direction in a point of a curve through three, by how far they are from each other. */
function tangent(before: Point3, at: Point3, after: Point3): Point3 {
  const [far, next] = [distance(before, at), distance(at, after)];
  if (far === 0 || next === 0) return along([0, 0, 0], [1 / Math.max(far + next, 1e-300), minus(after, before)]);
  const [u, v] = [next / (far + next), far / (far + next)];
  return along([0, 0, 0], [u / far, minus(at, before)], [v / next, minus(after, at)]);
}

/** A drawing's size in words: its length, its radius, its sides. */
export function measures(tool: DrawTool, points: readonly Point3[], frame: Frame): readonly number[] {
  const [before, now] = points.slice(-2);
  if (!before || !now) return points.length === 1 ? coordinatesIn(frame, points[0] as Point3) : [];
  if (tool === "rectangle") return sides(frame, before, now).map(Math.abs);
  return [tool === "circle" ? inPlane(frame, before, now) : distance(before, now)];
}
