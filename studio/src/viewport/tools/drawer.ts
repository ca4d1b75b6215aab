/** Picks and draws in the viewport what an input is to keep, as long as such a job is going on. */

import { outline } from "../../core/drawing";
import { distance, FRAMES, type Frame } from "../../core/frame";
import type { Point3, Preview, PreviewPart } from "../../core/preview";
import type { GeometrySource } from "../../core/protocol/GeometrySource";
import type { PartKind } from "../../core/protocol/PartKind";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { objectOf } from "../../state/model";
import { closes, complete, pickStore, takePoint, takeSource, type PickJob } from "../../state/pickJob";
import { settingsStore } from "../settings";
import type { Viewport } from "../Viewport";
import { gridPlane } from "../views";
import { layerOf } from "./beside";
import type { Pick } from "./picking";
import { dragged } from "./rays";
import { onGrid, snapTo, type Snapped } from "./snaps";

/** What is drawn of the job: what the pointer is on, and the drawing that is being made. */
const DRAWN = "tool:drawn";
/** A click so near to the last point ends the drawing, to the first one closes it; in pixels. */
const SAME = 8;

/** The construction plane of the active view. */
export function frameOf({ panes }: Viewport): Frame {
  return FRAMES[gridPlane(panes.active.rig.pose)];
}

/** What a pick gives an input. */
export function sourceOf({ object, piece }: Pick): GeometrySource | undefined {
  const layer = layerOf(object);
  if (layer !== undefined) {
    const found = objectOf(layer, piece?.index ?? -1);
    return found && { from: "model", object: found.id };
  }
  const port = piece && documentStore.getState().objects.get(object)?.outputs[piece.output]?.id;
  return port && piece ? { from: "item", port, path: piece.path, index: piece.index } : undefined;
}

export class Drawer {
  #viewport: Viewport;
  #marker: HTMLElement;
  /** Where the pointer is, and the point that it stands for. */
  #at: [number, number] | undefined;
  #snapped: Snapped | undefined;
  #stop: () => void;

  constructor(host: HTMLElement, viewport: Viewport) {
    this.#viewport = viewport;
    this.#marker = document.createElement("div");
    this.#marker.className = "viewport-snap";
    this.#marker.hidden = true;
    host.append(this.#marker);
    this.#stop = pickStore.subscribe(({ job }, before) => {
      viewport.canvas.classList.toggle("is-picking", job !== undefined);
      if (job && before.job?.tool !== job.tool) this.#snapped = undefined;
      this.#show(job);
    });
  }

  dispose(): void {
    this.#stop();
    this.#marker.remove();
  }

  isOn(): boolean {
    return pickStore.getState().job !== undefined;
  }

  /** Where a number alone leads: towards the pointer. */
  get towards(): Point3 | undefined {
    return this.#snapped?.point;
  }

  hover(at: [number, number] | undefined): void {
    const { job } = pickStore.getState();
    if (!job) return;
    this.#at = at;
    this.#snapped = at && job.tool !== "pick" ? this.#snap(job, ...at) : undefined;
    this.#show(job);
  }

  click(x: number, y: number): void {
    const { job } = pickStore.getState();
    if (!job) return;
    if (job.tool === "pick") {
      const pick = this.#viewport.pickAt(x, y, true);
      const source = pick && sourceOf(pick);
      if (source) void takeSource(source);
      return;
    }
    const { point } = this.#snap(job, x, y) ?? {};
    if (!point) return;
    const frame = frameOf(this.#viewport);
    const last = job.points.at(-1);
    if (closes(point, this.#reach(point))) void complete(frame, true);
    else if (last && job.points.length > 1 && this.#far(last, x, y) <= SAME) void complete(frame);
    else takePoint(point, frame);
  }

  /** Keeps the mark where its point is when the view moves. */
  place(): void {
    const place = this.#snapped && this.#viewport.placeOf(this.#snapped.point);
    this.#marker.hidden = !place || !this.isOn();
    if (place) this.#marker.style.transform = `translate(${place[0]}px, ${place[1]}px)`;
  }

  /** How far a point is from a place of the canvas, in pixels. */
  #far(point: Point3, x: number, y: number): number {
    const place = this.#viewport.placeOf(point);
    return place ? Math.hypot(place[0] - x, place[1] - y) : Infinity;
  }

  /** How far from a point in the model a click still hits it. */
  #reach(point: Point3): number {
    const first = pickStore.getState().job?.points[0];
    const place = this.#viewport.placeOf(point);
    if (!first || !place) return 0;
    return this.#far(first, ...place) <= SAME ? distance(first, point) : 0;
  }

  #snap(job: PickJob, x: number, y: number): Snapped | undefined {
    const { panes } = this.#viewport;
    const { snaps, snap } = settingsStore.getState();
    const pick = this.#viewport.pickAt(x, y, true);
    const preview = pick && this.#viewport.model.objects.get(pick.object)?.preview;
    const found = pick && preview && snapTo(pick, preview, snaps, (point) => this.#far(point, x, y));
    if (found) return found;
    const own = [job.points[0], job.points.at(-1)].find((point) => point && this.#far(point, x, y) <= SAME);
    if (own) return { point: own, name: "point" };
    const frame = frameOf(this.#viewport);
    const placed = panes.placedOf(panes.active);
    const point = dragged(placed, job.points.at(-1) ?? frame.origin, x, y, false);
    if (!point) return undefined;
    return snap ? onGrid(point, frame, placed.pane.rig.pixel(placed.height)) : { point, name: undefined };
  }

  #show(job: PickJob | undefined): void {
    const preview = job && (job.tool === "pick" ? this.#pointed() : this.#drawing(job));
    if (preview) this.#viewport.put(DRAWN, preview);
    else if (this.#viewport.model.objects.has(DRAWN)) this.#viewport.drop(DRAWN);
    this.#marker.dataset.snap = this.#snapped?.name ?? "";
    this.#marker.textContent = this.#snapped?.name ? t(`pick.snap.${this.#snapped.name}`) : "";
    this.place();
  }

  /** What is under the pointer, in the colour of picking. */
  #pointed(): Preview | undefined {
    const pick = this.#at && this.#viewport.pickAt(...this.#at, true);
    const preview = pick && this.#viewport.model.objects.get(pick.object)?.preview;
    if (!pick || !preview || !sourceOf(pick)) return undefined;
    const { part, piece } = pick;
    const count = part.indices?.length ?? part.positions.length / 3;
    const [from, to] = piece ? [piece.start, piece.start + piece.count] : [0, count];
    const indices = part.indices?.slice(from, to) ?? Uint32Array.from({ length: to - from }, (_, k) => from + k);
    return { ...preview, object: "", bounds: null, parts: [{ ...part, kind: part.kind === "curves" ? "circles" : part.kind, colour: PICKED, colours: null, indices, pieces: [], width: 3 }] };
  }

  #drawing({ tool, points }: PickJob): Preview | undefined {
    const next = this.#snapped?.point;
    const all = next ? [...points, next] : points;
    const [origin] = all;
    if (!origin || tool === "pick") return undefined;
    const line = outline(tool, all, frameOf(this.#viewport));
    const segments = line.slice(1).flatMap((end, k) => [line[k] as Point3, end]);
    const parts = [partOf("circles", segments, origin, 2), partOf("controlPoints", points, origin, 0)];
    return { object: "", origin, bounds: null, draft: false, parts, size: 0 };
  }
}

/** Blue, as Grasshopper shows what is picked. */
const PICKED = [10, 88, 202, 255] as const;

function partOf(kind: PartKind, points: readonly Point3[], origin: Point3, width: number): PreviewPart {
  const positions = Float32Array.from(points.flatMap((point) => point.map((value, axis) => value - (origin[axis] ?? 0))));
  return {
    kind, width, positions, colour: PICKED, normals: null, colours: null, values: null, mean: null,
    indices: null, texts: [], textHeight: 0, pieces: [],
  };
}
