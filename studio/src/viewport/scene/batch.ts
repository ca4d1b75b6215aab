/** Small parts of one kind and look as one drawing, made anew when one of them changes. */

import { centre } from "../../core/bounds";
import type { Point3, PreviewPart } from "../../core/preview";
import type { Drawable } from "./drawable";
import { boundsOf, merge, type Member, type Merged } from "./merge";

/** Parts of more positions than this are drawn alone. */
export const ALONE = 20_000;
/** A batch takes no more parts once it has this many positions: one change makes all of it anew. */
const FULL = 60_000;

/** What parts of one batch have in common. Surfaces that hide and those that shine through are drawn at different times. */
export function batchKey({ kind, width, normals, colours, indices, colour }: PreviewPart, hasValues: boolean): string {
  const hides = kind === "mesh" && colour?.[3] === 255;
  return [kind, width, normals !== null, colours !== null, indices !== null, hasValues, hides].join();
}

export class Batch {
  readonly key: string;
  readonly members = new Set<Member>();
  drawable: Drawable | undefined;
  #size = 0;
  #isStale = false;

  constructor(key: string) {
    this.key = key;
  }

  isFull(): boolean {
    return this.#size > FULL;
  }

  isStale(): boolean {
    return this.#isStale;
  }

  add(member: Member): void {
    this.members.add(member);
    this.#size += member.part.positions.length / 3;
    this.#isStale = true;
  }

  remove(member: Member): void {
    if (!this.members.delete(member)) return;
    this.#size -= member.part.positions.length / 3;
    this.#isStale = true;
  }

  /** Makes the drawing anew; gives the old one, to be disposed of. */
  remake(make: (merged: Merged) => Drawable): Drawable | undefined {
    const old = this.drawable;
    const bounds = boundsOf(this.members);
    const origin: Point3 = bounds ? centre(bounds) : ([...this.members][0]?.origin ?? [0, 0, 0]);
    this.drawable = this.members.size > 0 ? make(merge([...this.members], origin)) : undefined;
    this.#isStale = false;
    return old;
  }
}
