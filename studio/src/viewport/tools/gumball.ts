/**
 * The gumball: moves, turns and scales the geometry that the selected parameters keep. The document's own values change
 * as it goes; one drag is one step for Undo.
 */

import { evaluate } from "../../core/arithmetic";
import { centre, union } from "../../core/bounds";
import { minus } from "../../core/frame";
import { imageOf, mapOf, moving, type Grip, type Rows } from "../../core/gumball";
import { snap } from "../../core/gridSteps";
import type { Bounds, Point3 } from "../../core/preview";
import { documentStore } from "../../state/document";
import { pickStore } from "../../state/pickJob";
import { ask, edit, newGesture } from "../../state/session";
import { uiStore } from "../../state/ui";
import type { PlacedPane } from "../panes";
import { settingsStore } from "../settings";
import type { Viewport } from "../Viewport";
import { AmountField } from "./gumballAmount";
import { GumballPicture } from "./gumballPicture";
import { amountOf, COARSE, reached, said, stepOf } from "./gumballReach";
import { movablePorts } from "./movable";
import { keepsPoints } from "./heldPoints";

/** A press that goes less far than this is a click. */
const CLICK = 4;
/** The factor that a press of a key scales by. */
const GROW = 1.1;

interface Drag {
  grip: Grip;
  gesture: number;
  pane: PlacedPane;
  middle: Point3;
  /** Where it was taken: on the axis, in the plane of the turn, or in that of the grid. */
  from: Point3;
  at: [number, number];
  isMoved: boolean;
  rows: Rows;
}

export class Gumball {
  #viewport: Viewport;
  #picture: GumballPicture;
  #amount: AmountField;
  #ports: readonly string[] = [];
  #middle: Point3 | undefined;
  #drag: Drag | undefined;
  /** Where a drag has left it, until the geometry that it moved is here. */
  #left: { middle: Point3; bounds: Bounds | null } | undefined;
  #isSending = false;
  #next: (() => void) | undefined;
  #stops: (() => void)[];

  constructor(host: HTMLElement, viewport: Viewport) {
    this.#viewport = viewport;
    this.#picture = new GumballPicture(host);
    this.#amount = new AmountField(host);
    for (const { grip, button } of this.#picture.buttons) {
      button.addEventListener("pointerdown", (event) => this.#begin(event, button, grip));
      button.addEventListener("pointermove", (event) => this.#move(event));
      button.addEventListener("pointerup", (event) => this.#end(event));
      button.addEventListener("pointercancel", () => this.#leave());
      button.addEventListener("keydown", (event) => this.#key(event, grip));
    }
    const look = () => this.#look();
    this.#stops = [
      uiStore.subscribe((now, before) => now.selection !== before.selection && look()),
      documentStore.subscribe((now, before) => now.objects !== before.objects && look()),
      settingsStore.subscribe((now, before) => now.gumball !== before.gumball && look()),
      pickStore.subscribe((now, before) => (now.job === undefined) !== (before.job === undefined) && look()),
    ];
    look();
  }

  /** Puts it where the geometry is in the active pane. */
  place(placed: readonly PlacedPane[]): void {
    const { panes } = this.#viewport;
    const active = placed.find(({ pane }) => pane === panes.active);
    const bounds = this.#ports.length > 0 ? this.#bounds() : null;
    if (this.#left && String(this.#left.bounds) !== String(bounds)) this.#left = undefined;
    this.#middle = this.#drag ? imageOf(this.#drag.rows, this.#drag.middle) : (this.#left?.middle ?? (bounds ? centre(bounds) : undefined));
    if (!active || !this.#middle) return this.#picture.hide();
    const isPoint = bounds !== null && bounds[0].every((value, axis) => value === bounds[1][axis]);
    const pixel = active.pane.rig.pixel(active.height);
    // Points have handles of their own, of which one may be in the middle.
    const isFree = !this.#hasHandles();
    this.#picture.show(this.#middle, pixel, { isPoint, isFree }, (point) => this.#viewport.placeOf(point, active));
  }

  dispose(): void {
    for (const stop of this.#stops) stop();
    this.#picture.dispose();
    this.#amount.dispose();
  }

  #hasHandles(): boolean {
    const { objects } = documentStore.getState();
    return [...uiStore.getState().selection].some((id) => {
      const object = objects.get(id);
      return object !== undefined && keepsPoints(object);
    });
  }

  /** The box around what the selected parameters show. */
  #bounds(): Bounds | null {
    const { objects } = this.#viewport.model;
    return [...uiStore.getState().selection].reduce<Bounds | null>((all, id) => union(all, objects.get(id)?.bounds ?? null), null);
  }

  #look(): void {
    const { objects } = documentStore.getState();
    const isOn = settingsStore.getState().gumball && pickStore.getState().job === undefined;
    const ports = isOn ? movablePorts([...uiStore.getState().selection].map((id) => objects.get(id))) : [];
    if (ports.length === 0 && this.#ports.length === 0) return;
    if (ports.join() !== this.#ports.join()) {
      this.#leave();
      this.#amount.hide();
      this.#left = undefined;
    }
    this.#ports = ports;
    this.#viewport.invalidate();
  }

  #at(event: PointerEvent): [number, number] {
    const box = this.#viewport.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #begin(event: PointerEvent, button: HTMLButtonElement, grip: Grip): void {
    const middle = this.#middle;
    if (event.button !== 0 || !middle) return;
    const { panes } = this.#viewport;
    const pane = panes.placedOf(panes.active);
    const at = this.#at(event);
    const from = reached(grip, pane, middle, at, false);
    if (!from) return;
    button.setPointerCapture(event.pointerId);
    this.#amount.hide();
    this.#drag = { grip, gesture: newGesture(), pane, middle, from, at, isMoved: false, rows: moving([0, 0, 0]) };
  }

  #move(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag) return;
    const at = this.#at(event);
    if (!drag.isMoved) {
      if (Math.hypot(at[0] - drag.at[0], at[1] - drag.at[1]) < CLICK) return;
      drag.isMoved = true;
      void ask({ ask: "draft", on: true }).catch(() => {});
    }
    const { grip, middle, pane, from } = drag;
    const to = reached(grip, pane, middle, at, event.altKey);
    if (!to) return;
    const isFree = event.altKey || !settingsStore.getState().snap;
    if (grip.axis === undefined) {
      const step = isFree ? 0 : stepOf(pane);
      const by = minus(to, from).map((value) => (step > 0 ? snap(value, step) : value)) as unknown as Point3;
      drag.rows = moving(by);
      this.#amount.tell(by.map((value) => Number(value.toPrecision(6))).join(", "), at);
    } else {
      const amount = amountOf(grip.does, grip.axis, middle, from, to, { isFree, isCoarse: event.shiftKey, step: stepOf(pane) });
      if (amount === undefined) return;
      drag.rows = mapOf(grip, middle, amount, event.shiftKey);
      this.#amount.tell(said(grip, amount), at);
    }
    this.#viewport.invalidate();
    this.#send(drag);
  }

  #end(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag) return;
    this.#drag = undefined;
    this.#next = undefined;
    this.#amount.hide();
    if (!drag.isMoved) return this.#type(drag.grip, this.#at(event));
    this.#left = { middle: imageOf(drag.rows, drag.middle), bounds: this.#bounds() };
    this.#send(drag, true);
  }

  /** Escape: all is as it was. */
  #leave(): void {
    const drag = this.#drag;
    if (!drag) return;
    this.#drag = undefined;
    this.#next = undefined;
    this.#amount.hide();
    if (!drag.isMoved) return;
    void ask({ ask: "abandon", gesture: drag.gesture }).catch(() => {});
    void ask({ ask: "draft", on: false }).catch(() => {});
    this.#viewport.invalidate();
  }

  /** A click on a grip asks how far. */
  #type(grip: Grip, at: [number, number]): void {
    if (grip.axis === undefined) return;
    this.#amount.ask(grip, at, (text) => {
      const amount = evaluate(text);
      if (amount === undefined || (grip.does === "scale" && amount === 0)) return false;
      this.#make(grip, amount);
      return true;
    });
  }

  #make(grip: Grip, amount: number): void {
    if (this.#middle) void edit({ do: "transform", ports: [...this.#ports], map: mapOf(grip, this.#middle, amount) });
  }

  #key(event: KeyboardEvent, grip: Grip): void {
    if (event.key === "Escape" && this.#drag) {
      event.stopPropagation();
      return this.#leave();
    }
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { panes } = this.#viewport;
    const length = stepOf(panes.placedOf(panes.active)) * (event.shiftKey ? 10 : 1);
    if (grip.axis === undefined) {
      const ways: Record<string, Point3> = {
        ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0], PageUp: [0, 0, 1], PageDown: [0, 0, -1],
      };
      const way = ways[event.key];
      if (!way) return;
      void edit({ do: "transform", ports: [...this.#ports], map: moving(way.map((value) => value * length) as unknown as Point3) });
    } else {
      if (event.key === "Enter") {
        const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
        const canvas = this.#viewport.canvas.getBoundingClientRect();
        this.#type(grip, [box.x - canvas.x, box.y - canvas.y]);
      } else {
        const sign = { ArrowRight: 1, ArrowUp: 1, PageUp: 1, ArrowLeft: -1, ArrowDown: -1, PageDown: -1 }[event.key];
        if (!sign) return;
        this.#make(grip, grip.does === "move" ? sign * length : grip.does === "turn" ? sign * COARSE : GROW ** sign);
      }
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** As fast as the document takes it: always the newest, never a queue. */
  #send(drag: Drag, isLast = false): void {
    if (this.#isSending) {
      this.#next = () => this.#send(drag, isLast);
      return;
    }
    this.#isSending = true;
    void edit({ do: "transform", ports: [...this.#ports], map: drag.rows }, drag.gesture)
      .then((answer) => {
        // What is refused is where it was.
        if (!answer) this.#left = undefined;
      })
      .finally(() => {
        this.#isSending = false;
        if (isLast) void ask({ ask: "draft", on: false }).catch(() => {});
        const next = this.#next;
        this.#next = undefined;
        next?.();
      });
  }
}
