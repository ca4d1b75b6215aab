/** Many small parts of one kind as one, with the place in the colour table of each position. */

import { from, union } from "../../core/bounds";
import type { Bounds, Point3, PreviewPart } from "../../core/preview";

/** What one drawing takes: a part, or many that were merged. */
export interface Merged {
  kind: PreviewPart["kind"];
  width: number;
  /** What positions are measured from. */
  origin: Point3;
  /** Offset from there as the positions are. */
  bounds: Bounds | null;
  positions: Float32Array;
  normals: Float32Array | Int8Array | null;
  colours: Uint8Array | null;
  values: Float32Array | null;
  indices: Uint16Array | Uint32Array | null;
  /** One place for all, or one a position. */
  slots: number | Uint16Array;
  /** Whether any of it is coarser than it will be. */
  isDraft: boolean;
}

export interface Member {
  part: PreviewPart;
  origin: Point3;
  /** The box of its positions, in model units. */
  bounds: Bounds | null;
  slot: number;
  values: Float32Array | null;
  isDraft: boolean;
}

/** A part that is drawn alone: its own arrays, not a copy. */
export function alone({ part, origin, bounds, slot, values, isDraft }: Member): Merged {
  const { kind, width, positions, normals, colours, indices } = part;
  const box = bounds && from(bounds, origin);
  return { kind, width, origin, bounds: box, positions, normals, colours, values, indices, slots: slot, isDraft };
}

/** Parts of one kind and width, either all with normals (colours, values) or none. */
export function merge(members: readonly Member[], origin: Point3): Merged {
  const first = members[0]?.part;
  const count = members.reduce((sum, { part }) => sum + part.positions.length / 3, 0);
  const used = members.reduce((sum, { part }) => sum + (part.indices ?? part.positions).length / (part.indices ? 1 : 3), 0);
  const bounds = boundsOf(members);
  const has = (array: (member: Member) => unknown) => members.some((member) => array(member) !== null);
  const merged = {
    kind: first?.kind ?? "curves",
    width: first?.width ?? 0,
    origin,
    bounds: bounds && from(bounds, origin),
    positions: new Float32Array(count * 3),
    normals: has(({ part }) => part.normals) ? new Int8Array(count * 3) : null,
    colours: has(({ part }) => part.colours) ? new Uint8Array(count * 4).fill(255) : null,
    values: has(({ values }) => values) ? new Float32Array(count) : null,
    indices: has(({ part }) => part.indices) ? new Uint32Array(used) : null,
    slots: new Uint16Array(count),
    isDraft: members.some(({ isDraft }) => isDraft),
  } satisfies Merged;
  let vertex = 0;
  let index = 0;
  for (const member of members) {
    addPart(merged, member, vertex, index);
    vertex += member.part.positions.length / 3;
    index += member.part.indices?.length ?? member.part.positions.length / 3;
  }
  return merged;
}

/** The box of all of them. */
export function boundsOf(members: Iterable<Member>): Bounds | null {
  let all: Bounds | null = null;
  for (const { bounds } of members) all = union(all, bounds);
  return all;
}

function addPart(merged: Merged & { slots: Uint16Array }, { part, origin, slot, values }: Member, vertex: number, index: number): void {
  const count = part.positions.length / 3;
  const [x, y, z] = [origin[0] - merged.origin[0], origin[1] - merged.origin[1], origin[2] - merged.origin[2]];
  const { positions } = part;
  for (let at = 0, to = vertex * 3; at < positions.length; at += 3, to += 3) {
    merged.positions[to] = (positions[at] as number) + x;
    merged.positions[to + 1] = (positions[at + 1] as number) + y;
    merged.positions[to + 2] = (positions[at + 2] as number) + z;
  }
  if (merged.normals && part.normals) {
    const scale = part.normals instanceof Int8Array ? 1 : 127;
    for (let at = 0; at < part.normals.length; at++) {
      merged.normals[vertex * 3 + at] = Math.round((part.normals[at] ?? 0) * scale);
    }
  }
  if (merged.colours && part.colours) merged.colours.set(part.colours, vertex * 4);
  if (merged.values && values) merged.values.set(values, vertex);
  merged.slots.fill(slot, vertex, vertex + count);
  if (!merged.indices) return;
  const used = part.indices?.length ?? count;
  for (let at = 0; at < used; at++) merged.indices[index + at] = vertex + (part.indices ? (part.indices[at] ?? 0) : at);
}

/** Segments as start and end, six numbers each: the positions themselves where they already lie like that. */
export function segmentsOf({ positions, indices }: Pick<Merged, "positions" | "indices">): Float32Array {
  if (!indices) return positions;
  const segments = new Float32Array(indices.length * 3);
  for (let at = 0; at < indices.length; at++) {
    const from = (indices[at] ?? 0) * 3;
    segments[at * 3] = positions[from] ?? 0;
    segments[at * 3 + 1] = positions[from + 1] ?? 0;
    segments[at * 3 + 2] = positions[from + 2] ?? 0;
  }
  return segments;
}

/** The place in the colour table of each segment: that of its first position. */
export function segmentSlots(slots: Uint16Array, indices: Merged["indices"]): Uint16Array {
  const count = (indices?.length ?? slots.length) / 2;
  const result = new Uint16Array(count);
  for (let at = 0; at < count; at++) result[at] = slots[indices ? (indices[at * 2] ?? 0) : at * 2] ?? 0;
  return result;
}
