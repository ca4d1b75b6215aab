/**
 * Places whose curvature is shown: that under the pointer, and those that are pinned, which stay at their parameter while
 * the curve or surface changes. The session answers off the curves themselves.
 */

import { createStore } from "zustand/vanilla";

import { circlePoints } from "../../core/circle";
import type { Point3, Preview, PreviewPart } from "../../core/preview";
import type { CircleView } from "../../core/protocol/CircleView";
import type { PartKind } from "../../core/protocol/PartKind";
import type { Probe } from "../../core/protocol/Probe";
import type { Probed } from "../../core/protocol/Probed";
import { analysisStore } from "../../state/analysis";
import { ask, lineStore } from "../../state/session";
import type { Pick } from "./picking";

/** A place with what is known of it. */
export interface Place {
  probe: Probe;
  found: Probed | null;
}

export interface Places {
  pinned: readonly Place[];
  pointed: Place | undefined;
}

export const placesStore = createStore<Places>(() => ({ pinned: [], pointed: undefined }));

/** The session answers no more places at once. */
const MOST_PINNED = 40;

/** What is asked of what is under the pointer; nothing of what has no curvature. */
export function probeOf(pick: Pick | undefined): Probe | undefined {
  if (!pick?.piece || !["curves", "mesh", "edges", "isocurves"].includes(pick.part.kind)) return undefined;
  const { output, path, index } = pick.piece;
  const [x, y, z] = pick.point;
  return { object: pick.object, output, path, index, at: { is: "near", point: [x, y, z] } };
}

export function unpin(place: Place): void {
  placesStore.setState(({ pinned }) => ({ pinned: pinned.filter((each) => each !== place) }));
}

/** Where places are drawn. */
export interface PlacesScene {
  show(preview: Preview | undefined): void;
  /** The size of the model. */
  size(): number;
}

export class Probes {
  #round = 0;
  /** The places of the round that is on its way, in its order. */
  #asked: readonly Place[] = [];
  #isSending = false;
  #isStale = false;
  #stops: (() => void)[];
  #scene: PlacesScene;

  constructor(scene: PlacesScene) {
    this.#scene = scene;
    this.#stops = [
      analysisStore.subscribe((now, before) => now.probes !== before.probes && this.#take(now.round, now.probes)),
      placesStore.subscribe((now, before) => {
        const isSame = (a: readonly Place[], b: readonly Place[]) => a.length === b.length && a.every((each, at) => each.probe === b[at]?.probe);
        if (now.pointed?.probe !== before.pointed?.probe || !isSame(now.pinned, before.pinned)) this.#ask();
        this.#draw();
      }),
      lineStore.subscribe((now, before) => now.state !== before.state && this.#ask()),
    ];
    this.#draw();
    this.#ask();
  }

  point(pick: Pick | undefined): void {
    const probe = probeOf(pick);
    const { pointed } = placesStore.getState();
    if (!probe && !pointed) return;
    // What is known stays until the next is, so that nothing flickers.
    placesStore.setState({ pointed: probe && { probe, found: pointed?.found ?? null } });
  }

  /** Keeps the place under the pointer. */
  pin(pick: Pick | undefined): void {
    const probe = probeOf(pick);
    const { pinned } = placesStore.getState();
    if (probe && pinned.length < MOST_PINNED) placesStore.setState({ pinned: [...pinned, { probe, found: null }] });
  }

  dispose(): void {
    for (const stop of this.#stops) stop();
    placesStore.setState({ pointed: undefined });
  }

  #draw(): void {
    this.#scene.show(drawn(placesStore.getState(), this.#scene.size() * LARGEST));
  }

  #ask(): void {
    if (lineStore.getState().state !== "open") return;
    if (this.#isSending) {
      this.#isStale = true;
      return;
    }
    const { pinned, pointed } = placesStore.getState();
    const places = pointed ? [...pinned, pointed] : [...pinned];
    if (places.length === 0 && this.#asked.length === 0) return;
    this.#asked = places;
    [this.#isSending, this.#isStale] = [true, false];
    const probes = places.map(({ probe }) => probe);
    void ask({ ask: "probe", round: ++this.#round, probes }).catch(() => {}).finally(() => {
      this.#isSending = false;
      if (this.#isStale) this.#ask();
    });
  }

  #take(round: number, found: readonly (Probed | null)[]): void {
    if (round !== this.#round) return;
    const answers = new Map(this.#asked.map(({ probe }, at) => [probe, found[at] ?? null]));
    const taken = (place: Place): Place => {
      const answer = answers.get(place.probe);
      return answer === undefined ? place : { probe: place.probe, found: answer };
    };
    const { pinned, pointed } = placesStore.getState();
    placesStore.setState({ pinned: pinned.map((place) => settled(taken(place))), pointed: pointed && taken(pointed) });
  }
}

/** A pinned place that was found goes by its parameter from then on. */
function settled({ probe, found }: Place): Place {
  if (!found || probe.at.is === "parameter") return { probe, found };
  const { member, parameter } = found;
  return { probe: { ...probe, at: { is: "parameter", member, parameter } }, found };
}

const SEGMENTS = 144;
/** A circle so many times as large as the model is a line to the eye. */
const LARGEST = 100;

/** Circles, their radii, and the places themselves. Exported for tests. */
export function drawn({ pinned, pointed }: Places, largest: number): Preview | undefined {
  const found = [...pinned, ...(pointed ? [pointed] : [])].flatMap((place) => (place.found ? [place.found] : []));
  const [first] = found;
  if (!first) return undefined;
  const origin: Point3 = first.point;
  const [lines, radii, points]: [number[], number[], number[]] = [[], [], []];
  const put = (list: number[], ...places: Point3[]) => {
    for (const place of places) place.forEach((value, axis) => list.push(value - (origin[axis] ?? 0)));
  };
  for (const { point, bend } of found) {
    put(points, point);
    const circles = bend.is === "curve" ? [bend.circle] : bend.circles;
    for (const circle of circles.filter((each): each is CircleView => each !== null && each.radius <= largest)) {
      const around = circlePoints(circle, SEGMENTS);
      for (let at = 1; at < around.length; at++) put(lines, around[at - 1] as Point3, around[at] as Point3);
      put(radii, circle.centre, point);
      put(points, circle.centre);
    }
  }
  const part = (kind: PartKind, positions: number[], width: number): PreviewPart => ({
    kind, width, positions: Float32Array.from(positions), colour: null, normals: null, colours: null, values: null, mean: null,
    indices: null, texts: [], textHeight: 0, pieces: [],
  });
  const parts = [part("circles", lines, 1.6), part("circles", radii, 1), part("controlPoints", points, 0)];
  return { object: "", origin, bounds: null, draft: false, parts, size: 0 };
}
