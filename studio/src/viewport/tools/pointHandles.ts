/**
 * Handles for points of the selected object: they can be dragged in the view, or moved with the keyboard. Points that are kept
 * go along; for those that are computed sliders are found (`heldPoints.ts`). One drag is one step for Undo.
 */

import { gridSteps, snap } from "../../core/gridSteps";
import type { Point3 } from "../../core/preview";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { runStore } from "../../state/run";
import { ask, newGesture } from "../../state/session";
import { studyStore } from "../../state/study";
import { uiStore } from "../../state/ui";
import type { PlacedPane } from "../panes";
import { settingsStore } from "../settings";
import type { Viewport } from "../Viewport";
import { gridPlane } from "../views";
import { heldPoints, type HeldPoints } from "./heldPoints";
import { dragged, draggedAlong } from "./rays";

type Axis = 0 | 1 | 2;
const AXES = ["x", "y", "z"] as const;

function unit(axis: Axis): Point3 {
  return [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
}

/** The axis along which it has moved most. */
function greatest(to: Point3, from: Point3): Axis {
  const moves = to.map((value, axis) => Math.abs(value - (from[axis] ?? 0)));
  return moves.indexOf(Math.max(...moves)) as Axis;
}

/** The axes of the view's grid, or the one upright to it. */
function planar({ pane }: PlacedPane, upright: boolean): readonly Axis[] {
  const plane = gridPlane(pane.rig.pose);
  const across = plane === "xy" ? 2 : plane === "xz" ? 1 : 0;
  return ([0, 1, 2] as const).filter((axis) => (axis === across) === upright);
}

export class PointHandles {
  #layer: HTMLElement;
  #viewport: Viewport;
  #held: HeldPoints | undefined;
  #buttons: HTMLButtonElement[] = [];
  #drag: { at: number; gesture: number; pane: PlacedPane; before: Point3; lock: Axis | undefined } | undefined;
  #readout: HTMLElement;
  #place = "";
  #isSending = false;
  #next: (() => void) | undefined;
  #asked = 0;
  #keyGesture = 0;
  #stops: (() => void)[];

  constructor(host: HTMLElement, viewport: Viewport) {
    this.#viewport = viewport;
    this.#layer = document.createElement("div");
    this.#layer.className = "viewport-handles";
    this.#readout = document.createElement("div");
    this.#readout.className = "viewport-pointed viewport-readout";
    this.#readout.hidden = true;
    host.append(this.#layer, this.#readout);
    const look = () => void this.#look();
    this.#stops = [
      uiStore.subscribe((now, before) => now.selection !== before.selection && look()),
      documentStore.subscribe((now, before) => now.objects !== before.objects && look()),
      studyStore.subscribe((now, before) => (now.drags !== before.drags || now.target !== before.target) && look()),
      runStore.subscribe((now, before) => {
        const [id] = uiStore.getState().selection;
        if (id && now.results.get(id) !== before.results.get(id)) look();
      }),
    ];
    look();
  }

  /** Puts the handles where their points are in the active pane. */
  place(placed: readonly PlacedPane[]): void {
    const points = this.#held?.points ?? [];
    const active = placed.find(({ pane }) => pane === this.#viewport.panes.active);
    this.#buttons.forEach((button, at) => {
      const point = points[at]?.point;
      const place = point && active && this.#viewport.placeOf(point, active);
      button.hidden = !place;
      if (place) button.style.transform = `translate(${place[0]}px, ${place[1]}px)`;
    });
  }

  dispose(): void {
    for (const stop of this.#stops) stop();
    this.#layer.remove();
    this.#readout.remove();
  }

  /** Finds the selected object and its points. */
  async #look(): Promise<void> {
    if (this.#drag) return;
    const [id, ...others] = uiStore.getState().selection;
    const object = id && others.length === 0 ? documentStore.getState().objects.get(id) : undefined;
    const asked = ++this.#asked;
    if (!object) return this.#hold(undefined);
    try {
      const held = await heldPoints(object);
      if (asked === this.#asked && !this.#drag) this.#hold(held);
    } catch {
      // The refusal is on the line at the bottom already.
      this.#hold(undefined);
    }
  }

  #hold(held: HeldPoints | undefined): void {
    if (!held && !this.#held) return;
    this.#held = held;
    const count = held?.points.length ?? 0;
    while (this.#buttons.length > count) this.#buttons.pop()?.remove();
    while (this.#buttons.length < count) this.#addButton(this.#buttons.length);
    this.#name();
    this.#viewport.invalidate();
  }

  #name(): void {
    this.#buttons.forEach((button, at) => {
      const object = this.#held?.object.nickname ?? "";
      const place = this.#held?.points[at]?.point.map((value) => Number(value.toPrecision(6))).join(", ") ?? "";
      button.setAttribute("aria-label", t("viewport.pointHandle", { index: at, object, place }));
    });
  }

  #addButton(at: number): void {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "viewport-handle";
    button.title = t("viewport.pointHelp");
    button.addEventListener("pointerdown", (event) => this.#begin(event, button, at));
    button.addEventListener("pointermove", (event) => this.#move(event, at));
    button.addEventListener("pointerup", () => this.#end(true));
    button.addEventListener("pointercancel", () => this.#end(false));
    button.addEventListener("focus", () => (this.#keyGesture = newGesture()));
    button.addEventListener("keydown", (event) => this.#key(event, at));
    this.#buttons.push(button);
    this.#layer.append(button);
  }

  #begin(event: PointerEvent, button: HTMLButtonElement, at: number): void {
    const held = this.#held?.points[at];
    if (event.button !== 0 || !held) return;
    button.setPointerCapture(event.pointerId);
    const { panes } = this.#viewport;
    this.#drag = { at, gesture: newGesture(), pane: panes.placedOf(panes.active), before: held.point, lock: undefined };
    void ask({ ask: "draft", on: true }).catch(() => {});
  }

  #move(event: PointerEvent, at: number): void {
    if (this.#drag?.at !== at) return;
    const box = this.#viewport.canvas.getBoundingClientRect();
    const { pane, before, gesture, lock } = this.#drag;
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const free = dragged(pane, before, x, y, event.altKey);
    const axis = lock ?? (event.shiftKey && free ? greatest(free, before) : undefined);
    const target = axis === undefined ? free : draggedAlong(pane, before, unit(axis), x, y);
    if (!target) return;
    const point = this.#snapped(target, pane, axis === undefined ? planar(pane, event.altKey) : [axis], before);
    this.#put(at, point, gesture);
    this.#readout.hidden = false;
    this.#readout.style.transform = `translate(${x + 16}px, ${y + 18}px)`;
    const place = point.map((value) => Number(value.toPrecision(7))).join(", ");
    this.#place = axis === undefined ? place : `${AXES[axis]} · ${place}`;
    this.#readout.textContent = this.#place;
  }

  #end(keep: boolean): void {
    const drag = this.#drag;
    if (!drag) return;
    this.#drag = undefined;
    this.#next = undefined;
    this.#readout.hidden = true;
    const done = keep ? Promise.resolve() : ask({ ask: "abandon", gesture: drag.gesture }).then(() => {});
    if (keep) this.#send(drag.at, drag.gesture, true);
    done.catch(() => {}).finally(() => void ask({ ask: "draft", on: false }).catch(() => {}));
    if (!keep) void this.#look();
  }

  #key(event: KeyboardEvent, at: number): void {
    if (event.key === "Escape" && this.#drag) {
      event.stopPropagation();
      return this.#end(false);
    }
    const axis = AXES.indexOf(event.key.toLowerCase() as "x");
    if (this.#drag && axis >= 0) {
      event.preventDefault();
      event.stopPropagation();
      // The same key again lets it go anywhere.
      this.#drag.lock = this.#drag.lock === axis ? undefined : (axis as Axis);
      return;
    }
    const steps: Record<string, [number, number, number]> = {
      ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0],
      PageUp: [0, 0, 1], PageDown: [0, 0, -1],
    };
    const step = steps[event.key];
    const point = this.#held?.points[at]?.point;
    if (!step || !point || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const { panes } = this.#viewport;
    const placed = panes.placedOf(panes.active);
    const size = gridSteps(placed.pane.rig.pixel(placed.height)).minor * (event.shiftKey ? 10 : 1);
    const moved = point.map((value, axis) => (step[axis] ? snap(value + (step[axis] ?? 0) * size, size) : value));
    this.#put(at, moved as unknown as Point3, this.#keyGesture);
  }

  /** On the grid along the axes that it is moved along; the other coordinates stay as they are, to the last digit. */
  #snapped(point: Point3, { pane, height }: PlacedPane, moved: readonly Axis[], before: Point3): Point3 {
    const step = settingsStore.getState().snap ? gridSteps(pane.rig.pixel(height)).minor : 0;
    return point.map((value, axis) => {
      if (!moved.includes(axis as Axis)) return before[axis] ?? value;
      return step > 0 ? snap(value, step) : value;
    }) as unknown as Point3;
  }

  /** Moves a point here at once, and in the document as fast as it takes it: always the newest, never a queue. */
  #put(at: number, point: Point3, gesture: number): void {
    const held = this.#held;
    const entry = held?.points[at];
    if (!held || !entry || entry.point.every((value, axis) => value === point[axis])) return;
    held.points[at] = { ...entry, point };
    this.#name();
    this.#viewport.invalidate();
    // A key is a whole move of its own.
    this.#send(at, gesture, !this.#drag);
  }

  #send(at: number, gesture: number, done = false): void {
    const held = this.#held;
    const entry = held?.points[at];
    if (!held || !entry) return;
    if (this.#isSending) {
      this.#next = () => this.#send(at, gesture, done);
      return;
    }
    this.#isSending = true;
    void held.move(at, entry.point, gesture, done).then((told) => {
      if (told && this.#drag) this.#readout.textContent = `${this.#place} · ${told}`;
    }, () => {}).finally(() => {
      this.#isSending = false;
      const next = this.#next;
      this.#next = undefined;
      next?.();
      // A computed point may have come less far than it was dragged.
      if (done && !next) void this.#look();
    });
  }
}
