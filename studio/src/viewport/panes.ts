/** The panes of the canvas and their cameras: where each is, which is the active one, and how cameras fly. */

import { Vector3 } from "three";

import type { Bounds, Point3 } from "../core/preview";
import { CameraRig, MARGIN, wrap, type Pose } from "./camera";
import { fourPanes, poseOf, viewOf, type Layout, type Pane, type ViewName } from "./views";

/** A pane in pixels, from the top left of the canvas. */
export interface PlacedPane {
  pane: Pane;
  left: number;
  top: number;
  width: number;
  height: number;
}

const FLIGHT = 260;

export class Panes {
  width = 1;
  height = 1;
  #layout: Layout = "one";
  #four = fourPanes({
    top: new CameraRig(poseOf("top")),
    perspective: new CameraRig(poseOf("perspective")),
    front: new CameraRig(poseOf("front")),
    right: new CameraRig(poseOf("right")),
  });
  #active = this.#four[1] as Pane;
  /** The panes that a hand has turned, moved or zoomed: they are framed when it asks for it, and never by themselves. */
  #own = new Set<Pane>();
  #flights = new Map<Pane, { from: Pose; to: Pose; start: number }>();
  #changed: () => void;
  readonly #margin: number;

  /** `margin` is how much of the view geometry leaves free when it is framed. */
  constructor(changed: () => void, margin: number = MARGIN) {
    this.#changed = changed;
    this.#margin = margin;
  }

  get active(): Pane {
    return this.#active;
  }

  get layout(): Layout {
    return this.#layout;
  }

  set layout(layout: Layout) {
    this.#layout = layout;
    this.#changed();
  }

  all(): readonly Pane[] {
    return this.#four;
  }

  activate(pane: Pane): void {
    if (this.#active === pane) return;
    this.#active = pane;
    this.#changed();
  }

  /** The panes that are shown, in whole pixels. */
  placed(): PlacedPane[] {
    const { width, height } = this;
    if (this.#layout === "one") return [{ pane: this.#active, left: 0, top: 0, width, height }];
    return this.#four.map((pane) => {
      const [left, top] = [Math.round(pane.left * width), Math.round(pane.top * height)];
      const right = Math.round((pane.left + pane.width) * width);
      const bottom = Math.round((pane.top + pane.height) * height);
      return { pane, left, top, width: Math.max(right - left, 1), height: Math.max(bottom - top, 1) };
    });
  }

  at(x: number, y: number): PlacedPane {
    const placed = this.placed();
    const inside = placed.find((p) => x >= p.left && x < p.left + p.width && y >= p.top && y < p.top + p.height);
    return inside ?? (placed[0] as PlacedPane);
  }

  placedOf(pane: Pane): PlacedPane {
    return this.placed().find((placed) => placed.pane === pane) ?? this.at(0, 0);
  }

  orbit(pane: Pane, dx: number, dy: number): void {
    this.#take(pane);
    // Half a turn for the height of the pane, whatever its size.
    const turn = Math.PI / Math.max(this.placedOf(pane).height, 200);
    pane.rig.orbit(-dx * turn, dy * turn);
    this.#changed();
  }

  pan(pane: Pane, dx: number, dy: number): void {
    this.#take(pane);
    pane.rig.pan(dx, dy, this.placedOf(pane).height);
    this.#changed();
  }

  zoom(pane: Pane, about: Vector3, factor: number): void {
    this.#take(pane);
    pane.rig.zoomAbout(about, factor);
    this.#changed();
  }

  /** A hand takes the camera of a pane. */
  #take(pane: Pane): void {
    this.#flights.delete(pane);
    this.#own.add(pane);
  }

  /** Cameras go by themselves again, as they do in a document that was just opened. */
  letGo(): void {
    this.#own.clear();
  }

  /** Shows all of some boxes in those panes that no hand has taken and that do not frame them already. */
  frame(boxes: readonly Bounds[], isStill: boolean): void {
    const free = this.all().filter((pane) => !this.#own.has(pane));
    this.fit(boxes, free.filter((pane) => !this.#frames(pane, boxes)), isStill);
  }

  #frames(pane: Pane, boxes: readonly Bounds[]): boolean {
    const { width, height } = this.placedOf(pane);
    return boxes.length === 0 || new CameraRig(this.#target(pane)).frames(boxes, width / height, this.#margin);
  }

  /** Shows all of some boxes in all panes that are shown, or in the active one. */
  fit(boxes: readonly Bounds[], which: readonly Pane[], isStill: boolean): void {
    if (boxes.length === 0) return;
    for (const pane of which) {
      const { width, height } = this.placedOf(pane);
      const rig = new CameraRig(this.#target(pane));
      rig.fit(boxes, width / height, this.#margin);
      this.fly(pane, rig.pose, isStill);
    }
  }

  /** Turns the active view; views by name are parallel but for Perspective, as Rhino has them. */
  look(view: ViewName, keepProjection: boolean, isStill: boolean): void {
    const from = this.#target(this.#active);
    const pose = poseOf(view, from);
    this.fly(this.#active, keepProjection ? { ...pose, projection: from.projection } : pose, isStill);
  }

  /** Turns the active view to a pose that somebody chose: it stays there. */
  goTo(pose: Pose, isStill: boolean): void {
    this.#own.add(this.#active);
    this.fly(this.#active, { ...pose }, isStill);
  }

  /** Turns the active view about the upright axis through what it looks at. */
  turn(angle: number): void {
    this.#own.add(this.#active);
    this.#active.rig.orbit(angle, 0);
  }

  setProjection(projection: Pose["projection"]): void {
    const rig = this.#active.rig;
    rig.pose = { ...rig.pose, projection };
    this.#changed();
  }

  fly(pane: Pane, to: Pose, isStill: boolean): void {
    if (isStill) {
      this.#flights.delete(pane);
      pane.rig.pose = to;
    } else {
      this.#flights.set(pane, { from: { ...pane.rig.pose, projection: to.projection }, to, start: performance.now() });
    }
    this.#changed();
  }

  /** Moves what flies; gives whether something still does. */
  advance(now: number): boolean {
    for (const [pane, { from, to, start }] of this.#flights) {
      const along = Math.min(Math.max((now - start) / FLIGHT, 0), 1);
      if (along >= 1) this.#flights.delete(pane);
      pane.rig.pose = along >= 1 ? to : between(from, to, along * along * (3 - 2 * along));
    }
    return this.#flights.size > 0;
  }

  isFlying(): boolean {
    return this.#flights.size > 0;
  }

  viewName(): ViewName | undefined {
    const pose = this.#target(this.#active);
    return viewOf(pose) ?? (pose.projection === "perspective" ? "perspective" : undefined);
  }

  projection(): Pose["projection"] {
    return this.#active.rig.pose.projection;
  }

  /** Where a pane will be when it has arrived. */
  #target(pane: Pane): Pose {
    return this.#flights.get(pane)?.to ?? pane.rig.pose;
  }
}

/** From where panes are looked at, as text: it is the same as long as nothing moves. */
export function placeOf(panes: readonly PlacedPane[]): string {
  return JSON.stringify(panes.map(({ pane, left, top, width, height }) => [pane.title, left, top, width, height, pane.rig.pose]));
}

function between(from: Pose, to: Pose, along: number): Pose {
  const mix = (a: number, b: number) => a + (b - a) * along;
  return {
    ...to,
    target: from.target.map((value, axis) => mix(value, to.target[axis] ?? value)) as unknown as Point3,
    azimuth: wrap(from.azimuth + wrap(to.azimuth - from.azimuth) * along),
    elevation: mix(from.elevation, to.elevation),
    height: from.height * (to.height / from.height) ** along,
  };
}
