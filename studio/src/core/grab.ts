/**
 * The gesture that drags a particle of a solver: what is sent to the Grabs of a document while a hand holds one. One message
 * is on its way at a time, always the newest. While the hand rests the same is sent again after each solve: each goes on from
 * the one before, so that one sees the form give way.
 */

import { along, minus } from "./frame";
import type { Point3 } from "./preview";
import type { HeldPoint } from "./protocol/HeldPoint";
import type { ObjectView } from "./protocol/ObjectView";

/** Kangaroo 2's Grab, in its versions. */
const GRABS: ReadonlySet<string> = new Set([
  "ea145d1d-7727-4d52-8db6-c9b7100ab7f9",
  "4c90aad1-0748-4800-99db-a27d690bb1e1",
  "4c53ba00-f4bd-4ede-8d26-55106278268d",
  "3d13a415-6ac5-4b59-9677-3975e4696a85",
]);

/** The Grabs of a document that may drag something. */
export function grabsOf(objects: Iterable<ObjectView>): string[] {
  return [...objects].filter(({ component, disabled }) => !disabled && GRABS.has(component.toLowerCase())).map(({ id }) => id);
}

export interface GrabWays {
  /** Tells the Grabs what is held, or that it is let go; false where they do not take it. */
  send(held: HeldPoint | null): Promise<boolean>;
  /** Calls when the next picture is due: solves follow each other no faster than they are seen. */
  soon(then: () => void): void;
  /** The hand holds nothing any more, because it was refused. */
  lost(): void;
}

export class GrabGesture {
  #ways: GrabWays;
  #held: HeldPoint | undefined;
  /** Where the plane of the view was taken: a hand may take hold a little beside the particle. */
  #start: Point3 = [0, 0, 0];
  /** Whether a solve of what was sent is still to end. */
  #isWaiting = false;
  #isMoved = false;
  /** The number of this hold: answers to what was sent for another are of no account. */
  #number = 0;

  constructor(ways: GrabWays) {
    this.#ways = ways;
  }

  /** What is held; nothing while no hand holds anything. */
  get held(): HeldPoint | undefined {
    return this.#held;
  }

  /** Takes the particle at `from` with the hand at `start`, within `reach` of it. */
  begin(from: Point3, start: Point3, reach: number): void {
    this.#number += 1;
    this.#held = { from: [...from], to: [...from], reach };
    this.#start = start;
    this.#isWaiting = false;
    this.#send();
  }

  /** The hand is there now. */
  move(to: Point3): void {
    if (!this.#held) return;
    this.#held = { ...this.#held, to: [...along(this.#held.from, [1, minus(to, this.#start)])] };
    if (this.#isWaiting) this.#isMoved = true;
    else this.#send();
  }

  /** Lets go; the solver comes to rest from there. */
  end(): void {
    if (!this.#held) return;
    this.#held = undefined;
    this.#number += 1;
    void this.#ways.send(null).catch(() => {});
  }

  /** A solve has ended. */
  solved(): void {
    if (!this.#held || !this.#isWaiting) return;
    const number = this.#number;
    const next = () => {
      if (number === this.#number && this.#held) this.#send();
    };
    // Where the hand has gone on, it goes first; else the form has time to be seen.
    if (this.#isMoved) next();
    else this.#ways.soon(next);
  }

  #send(): void {
    const [held, number] = [this.#held, this.#number];
    if (!held) return;
    this.#isWaiting = true;
    this.#isMoved = false;
    this.#ways.send(held).then(
      (isTaken) => !isTaken && this.#lose(number),
      () => this.#lose(number),
    );
  }

  #lose(number: number): void {
    if (number !== this.#number || !this.#held) return;
    this.#held = undefined;
    this.#number += 1;
    this.#ways.lost();
  }
}
