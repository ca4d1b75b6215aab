/**
 * Hands on the viewport: mouse as in Rhino (right-drag turns, with Shift moves, the wheel zooms to the pointer, the
 * left button picks and draws windows), fingers, and trackpads.
 */

import type { Pane } from "../views";

export interface PointerTarget {
  element: HTMLElement;
  paneAt(x: number, y: number): Pane;
  /** A button goes down in a pane. */
  begin(pane: Pane): void;
  orbit(pane: Pane, dx: number, dy: number): void;
  pan(pane: Pane, dx: number, dy: number): void;
  zoom(pane: Pane, x: number, y: number, factor: number): void;
  /** The pointer rests or moves without a button; undefined when it has left. */
  hover(x: number | undefined, y: number | undefined): void;
  click(x: number, y: number, how: "replace" | "add" | "remove"): void;
  /** A click with Alt: to keep what is under the pointer. */
  mark(x: number, y: number): void;
  /** A press with Alt goes on: whether it takes hold of something that can be dragged. */
  hold(x: number, y: number): boolean;
  /** What is held goes there. */
  drag(x: number, y: number): void;
  letGo(): void;
  /** A window is drawn; `done` when the button goes up, undefined corners when it is abandoned. */
  window(corners: [number, number, number, number] | undefined, done: boolean, how: "replace" | "add" | "remove"): void;
  /** Plan views are moved, not turned, by the right button. */
  isPlan(pane: Pane): boolean;
  /** Two fingers on a trackpad move the view instead of zooming. */
  trackpad(): boolean;
}

type Gesture = "none" | "orbit" | "pan" | "press" | "window" | "hold" | "pinch";

/** A press that moves by less than this is a click. */
const SLACK = 4;

export class PointerControls {
  #target: PointerTarget;
  #stop = new AbortController();
  #gesture: Gesture = "none";
  #pane: Pane | undefined;
  #start: [number, number] = [0, 0];
  #last: [number, number] = [0, 0];
  #fingers = new Map<number, [number, number]>();

  constructor(target: PointerTarget) {
    this.#target = target;
    const { element } = target;
    const { signal } = this.#stop;
    element.addEventListener("pointerdown", (event) => this.#down(event), { signal });
    element.addEventListener("pointermove", (event) => this.#move(event), { signal });
    element.addEventListener("pointerup", (event) => this.#up(event), { signal });
    element.addEventListener("pointercancel", (event) => this.#cancel(event.pointerId), { signal });
    element.addEventListener("pointerleave", () => this.#target.hover(undefined, undefined), { signal });
    element.addEventListener("wheel", (event) => this.#wheel(event), { signal, passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
    element.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.#gesture !== "none") {
        this.#cancel();
        event.stopPropagation();
      }
    }, { signal });
  }

  dispose(): void {
    this.#stop.abort();
  }

  /** Whether a hand is on it: then nothing is hovered. */
  isBusy(): boolean {
    return this.#gesture !== "none";
  }

  #place(event: MouseEvent): [number, number] {
    const box = this.#target.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #down(event: PointerEvent): void {
    const [x, y] = this.#place(event);
    this.#target.element.focus({ preventScroll: true });
    this.#target.element.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") this.#fingers.set(event.pointerId, [x, y]);
    if (this.#fingers.size === 2) {
      this.#gesture = "pinch";
      return;
    }
    if (this.#gesture !== "none") return;
    this.#pane = this.#target.paneAt(x, y);
    this.#target.begin(this.#pane);
    [this.#start, this.#last] = [[x, y], [x, y]];
    this.#gesture = this.#begin(event);
  }

  #begin(event: PointerEvent): Gesture {
    const pane = this.#pane;
    if (event.button === 2) return event.shiftKey || (pane && this.#target.isPlan(pane)) ? "pan" : "orbit";
    if (event.button === 1) return "pan";
    return event.button === 0 ? "press" : "none";
  }

  #move(event: PointerEvent): void {
    const [x, y] = this.#place(event);
    const pane = this.#pane;
    if (this.#gesture === "pinch") return this.#pinch(event.pointerId, x, y);
    if (this.#gesture === "none" || !pane) {
      // What is dragged elsewhere on the page passes over, and points at nothing here.
      if (event.buttons === 0) this.#target.hover(x, y);
      return;
    }
    const [dx, dy] = [x - this.#last[0], y - this.#last[1]];
    this.#last = [x, y];
    const isFar = Math.hypot(x - this.#start[0], y - this.#start[1]) >= SLACK;
    if (this.#gesture === "press" && isFar) {
      const isTouch = event.pointerType === "touch";
      if (event.altKey && this.#target.hold(...this.#start)) this.#gesture = "hold";
      else this.#gesture = isTouch ? (this.#target.isPlan(pane) ? "pan" : "orbit") : "window";
    }
    if (this.#gesture === "orbit") this.#target.orbit(pane, dx, dy);
    else if (this.#gesture === "pan") this.#target.pan(pane, dx, dy);
    else if (this.#gesture === "hold") this.#target.drag(x, y);
    else if (this.#gesture === "window") this.#target.window([...this.#start, x, y], false, how(event));
  }

  #up(event: PointerEvent): void {
    const [x, y] = this.#place(event);
    this.#fingers.delete(event.pointerId);
    const gesture = this.#gesture;
    if (gesture === "pinch" && this.#fingers.size > 0) return;
    this.#gesture = "none";
    if (gesture === "press" && event.altKey) this.#target.mark(...this.#start);
    else if (gesture === "press") this.#target.click(...this.#start, how(event));
    else if (gesture === "hold") this.#target.letGo();
    else if (gesture === "window") this.#target.window([...this.#start, x, y], true, how(event));
    if (event.pointerType === "mouse") this.#target.hover(x, y);
  }

  #cancel(pointer?: number): void {
    if (pointer !== undefined) this.#fingers.delete(pointer);
    if (this.#gesture === "window") this.#target.window(undefined, true, "replace");
    if (this.#gesture === "hold") this.#target.letGo();
    this.#gesture = "none";
  }

  #pinch(id: number, x: number, y: number): void {
    const before = [...this.#fingers.values()];
    if (!this.#fingers.has(id) || before.length !== 2 || !this.#pane) return;
    const was = span(before);
    this.#fingers.set(id, [x, y]);
    const is = span([...this.#fingers.values()]);
    this.#target.pan(this.#pane, is.x - was.x, is.y - was.y);
    if (is.size > 1 && was.size > 1) this.#target.zoom(this.#pane, is.x, is.y, was.size / is.size);
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const [x, y] = this.#place(event);
    const pane = this.#target.paneAt(x, y);
    // Lines and pages are worth about so many pixels.
    const unit = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
    // A pinch on a trackpad comes as a wheel with Ctrl, in small steps.
    if (event.ctrlKey) this.#target.zoom(pane, x, y, Math.exp(clamp(dy, 50) * 0.01));
    else if (!this.#target.trackpad()) this.#target.zoom(pane, x, y, Math.exp(clamp(dy, 240) * 0.0015));
    else if (event.shiftKey && !this.#target.isPlan(pane)) this.#target.orbit(pane, -dx, -dy);
    else this.#target.pan(pane, -dx, -dy);
  }
}

function how({ shiftKey, ctrlKey, metaKey }: MouseEvent): "replace" | "add" | "remove" {
  return ctrlKey || metaKey ? "remove" : shiftKey ? "add" : "replace";
}

function clamp(value: number, most: number): number {
  return Math.min(Math.max(value, -most), most);
}

function span([a, b]: [number, number][]): { x: number; y: number; size: number } {
  const [p, q]: [number, number][] = [a ?? [0, 0], b ?? [0, 0]];
  if (!p || !q) return { x: 0, y: 0, size: 0 };
  return { x: (p[0] + q[0]) / 2, y: (p[1] + q[1]) / 2, size: Math.hypot(p[0] - q[0], p[1] - q[1]) };
}
