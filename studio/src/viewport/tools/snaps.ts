/** Where a drawing's point goes that is near something: the end, the middle or the nearest place of a line, or the grid. */

import { gridSteps, snap } from "../../core/gridSteps";
import { coordinatesIn, distance, pointAt, type Frame } from "../../core/frame";
import type { Point3, Preview, PreviewPart } from "../../core/preview";
import type { Pick } from "./picking";

export type SnapName = "end" | "mid" | "near" | "point" | "grid";

export interface Snapped {
  point: Point3;
  name: SnapName | undefined;
}

export interface SnapSettings {
  end: boolean;
  mid: boolean;
  near: boolean;
}

/** How near the pointer must be, in pixels. */
const REACH = 12;

/** The place of a pick that is snapped to; undefined where none is near enough. `far` is how far a point is on the screen. */
export function snapTo(pick: Pick, preview: Preview, on: SnapSettings, far: (point: Point3) => number): Snapped | undefined {
  const { kind } = pick.part;
  if (kind === "points" || kind === "controlPoints") return { point: pick.point, name: "point" };
  if (kind !== "curves" && kind !== "edges" && kind !== "isocurves") return on.near ? { point: pick.point, name: "near" } : undefined;
  const chain = chainOf(pick, preview);
  const candidates: Snapped[] = [
    ...(on.end ? [chain[0], chain.at(-1)].flatMap((point) => (point ? [{ point, name: "end" as const }] : [])) : []),
    ...(on.mid ? [{ point: middle(chain), name: "mid" as const }] : []),
  ];
  const near = candidates.filter(({ point }) => far(point) <= REACH).sort((a, b) => far(a.point) - far(b.point));
  return near[0] ?? (on.near ? { point: pick.point, name: "near" } : undefined);
}

/** A point on the grid of a plane. */
export function onGrid(point: Point3, frame: Frame, pixel: number): Snapped {
  const { minor } = gridSteps(pixel);
  const [u, v, w] = coordinatesIn(frame, point);
  return { point: pointAt(frame, [snap(u, minor), snap(v, minor), w]), name: "grid" };
}

/** The points of the line that was picked, one after the other. Exported for tests. */
export function chainOf({ part, piece, point }: Pick, { origin }: Preview): Point3[] {
  const count = part.indices?.length ?? part.positions.length / 3;
  const from = piece?.start ?? 0;
  const to = Math.min(from + (piece?.count ?? count), count);
  const chains: Point3[][] = [];
  for (let at = from; at + 1 < to; at += 2) {
    const [a, b] = [placeAt(part, at, origin), placeAt(part, at + 1, origin)];
    const last = chains.at(-1);
    if (last && distance(last.at(-1) as Point3, a) === 0) last.push(b);
    else chains.push([a, b]);
  }
  // An item may be several lines, as the borders of a surface: that which was hit counts.
  const off = (chain: readonly Point3[]) => Math.min(...chain.slice(1).map((end, k) => fromSegment(point, chain[k] as Point3, end)));
  return chains.sort((a, b) => off(a) - off(b))[0] ?? [point];
}

function placeAt({ positions, indices }: PreviewPart, at: number, [x, y, z]: Point3): Point3 {
  const from = (indices ? (indices[at] ?? 0) : at) * 3;
  return [x + (positions[from] ?? 0), y + (positions[from + 1] ?? 0), z + (positions[from + 2] ?? 0)];
}

function fromSegment(point: Point3, a: Point3, b: Point3): number {
  const length = distance(a, b);
  const share = length > 0 ? [0, 1, 2].reduce((sum, axis) => sum + ((point[axis] ?? 0) - (a[axis] ?? 0)) * ((b[axis] ?? 0) - (a[axis] ?? 0)), 0) / length ** 2 : 0;
  return distance(point, between(a, b, Math.min(Math.max(share, 0), 1)));
}

function between(a: Point3, b: Point3, share: number): Point3 {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];
}

/** The middle of a chain by its length. */
function middle(chain: readonly Point3[]): Point3 {
  const lengths = chain.slice(1).map((end, k) => distance(chain[k] as Point3, end));
  let left = lengths.reduce((sum, length) => sum + length, 0) / 2;
  for (const [k, length] of lengths.entries()) {
    if (left <= length) return between(chain[k] as Point3, chain[k + 1] as Point3, length > 0 ? left / length : 0);
    left -= length;
  }
  return chain.at(-1) as Point3;
}
