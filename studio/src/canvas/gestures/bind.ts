/** The pointer's events as the chart of gestures has them. */

import { NO_KEYS, type Keys } from "../../core/selection";
import { wheelMeans } from "../../core/wheel";
import { canvasStore } from "../store";
import { canvasPoint, paneSize, panBy, pixelOf, zoomAt } from "../view";
import { IDLE, step, type Button, type Gesture, type Pointer, type State } from "./chart";
import { carryOut, forgetDrag } from "./effects";
import { namedAt, targetAt, world } from "./world";

/** What of a page's event the chart needs. */
type Mouse = Pick<
  PointerEvent,
  "clientX" | "clientY" | "shiftKey" | "ctrlKey" | "metaKey" | "altKey" | "target" | "button" | "pointerId" | "pointerType"
>;

let state: State = IDLE;
let spaceHeld = false;
let last: Pointer = { at: [0, 0], pixel: [0, 0], keys: NO_KEYS };
/** Fingers on a touch screen: two of them pinch. */
const fingers = new Map<number, readonly [number, number]>();

function keysOf(event: Pick<Mouse, "shiftKey" | "ctrlKey" | "metaKey" | "altKey">): Keys {
  return { shift: event.shiftKey, ctrl: event.ctrlKey || event.metaKey, alt: event.altKey };
}

function pointerOf(event: Mouse): Pointer {
  const pixel = pixelOf(event);
  return { pixel, at: canvasPoint(pixel), keys: keysOf(event) };
}

function take(gesture: Gesture): void {
  const [next, effects] = step(state, gesture, world);
  state = next;
  if (next.is !== "dragging") forgetDragUnless(effects.some((effect) => effect.do === "drop"));
  for (const effect of effects) carryOut(effect);
}

function forgetDragUnless(dropping: boolean): void {
  if (!dropping) forgetDrag();
}

function elementOf(target: EventTarget | null): Element | null {
  return target instanceof Element ? target : null;
}

function buttonOf(event: Mouse): Button | undefined {
  if (event.button === 0 && spaceHeld) return "pan";
  if (event.button === 1) return "middle";
  if (event.button === 2) return "right";
  return event.button === 0 ? "left" : undefined;
}

export function pointerDown(event: Mouse): void {
  const element = elementOf(event.target);
  const button = buttonOf(event);
  if (button === undefined || (button === "left" && element?.closest("[data-own]"))) return;
  canvasStore.setState({ tip: undefined, menu: undefined, radial: undefined });
  const pointer = pointerOf(event);
  last = pointer;
  if (event.pointerType === "touch") {
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size > 1) {
      take({ on: "cancel" });
      return;
    }
  }
  const target = (button === "right" ? namedAt(element) : undefined) ?? targetAt(element, pointer.at);
  // A finger on nothing pans: there is no other button for it.
  const pans = event.pointerType === "touch" && (target.is === "void" || (target.is === "object" && target.group));
  take({ on: "down", button: pans ? "pan" : button, target, ...pointer });
}

export function pointerMove(event: Mouse): void {
  if (fingers.size > 1 && fingers.has(event.pointerId)) {
    pinch(event);
    return;
  }
  last = pointerOf(event);
  if (state.is === "idle") return;
  take({ on: "move", ...last });
  creeping ??= requestAnimationFrame(creep);
}

/** From here to the edge of the window the canvas goes along with what is dragged. */
const EDGE = 28;
let creeping: number | undefined;

/** While something is dragged at the edge, the canvas creeps under it. */
function creep(): void {
  creeping = undefined;
  if (state.is !== "dragging" && state.is !== "spreading" && state.is !== "wiring" && state.is !== "window") return;
  const [w, h] = paneSize();
  const pull = (at: number, room: number) => (at < EDGE ? EDGE - at : at > room - EDGE ? room - EDGE - at : 0);
  const limit = (by: number) => Math.max(-24, Math.min(24, by * 0.5));
  const by = [limit(pull(last.pixel[0], w)), limit(pull(last.pixel[1], h))] as const;
  if (by[0] === 0 && by[1] === 0) return;
  panBy(by);
  last = { ...last, at: canvasPoint(last.pixel) };
  take({ on: "move", ...last });
  creeping = requestAnimationFrame(creep);
}

export function pointerUp(event: Mouse): void {
  fingers.delete(event.pointerId);
  if (state.is === "idle") return;
  last = pointerOf(event);
  const below = elementOf(document.elementFromPoint(event.clientX, event.clientY));
  take({ on: "up", target: targetAt(below, last.at), ...last });
}

function pinch(event: Mouse): void {
  const before = fingers.get(event.pointerId);
  const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
  const now = [event.clientX, event.clientY] as const;
  fingers.set(event.pointerId, now);
  if (!before || !other) return;
  const length = (a: readonly [number, number]) => Math.max(Math.hypot(a[0] - other[0], a[1] - other[1]), 1);
  const middle = { clientX: (now[0] + other[0]) / 2, clientY: (now[1] + other[1]) / 2 };
  zoomAt(pixelOf(middle), length(now) / length(before));
  panBy([(now[0] - before[0]) / 2, (now[1] - before[1]) / 2]);
}

export function cancelGesture(): boolean {
  const busy = state.is !== "idle";
  take({ on: "cancel" });
  return busy;
}

export function isBusy(): boolean {
  return state.is !== "idle";
}

/** Where the pointer was last, on the canvas: pasted things go there. */
export function pointerAt(): Pointer["at"] {
  return last.at;
}

/** A key for another way went down or up: what is under way is shown in the other way at once. */
export function keysChanged(event: KeyboardEvent): void {
  if (event.key === " ") spaceHeld = event.type === "keydown";
  if (state.is === "idle" || !["Shift", "Control", "Alt", "Meta"].includes(event.key)) return;
  last = { ...last, keys: keysOf(event) };
  take({ on: "move", ...last });
}

export function wheel(event: WheelEvent): void {
  const scrolls = elementOf(event.target)?.closest<HTMLElement>("[data-scrolls]");
  // Only what is selected or written on takes the wheel: else zooming would stop at every panel on the way.
  const own = scrolls?.closest(".selected") ?? scrolls?.matches("textarea");
  if (scrolls && own && !event.ctrlKey && canScroll(scrolls, event.deltaY)) return;
  event.preventDefault();
  canvasStore.setState({ tip: undefined });
  const meaning = wheelMeans(event, canvasStore.getState().scheme);
  if (meaning.is === "zoom") zoomAt(pixelOf(event), meaning.factor);
  else panBy(meaning.by);
}

/** Whether a panel's text has still something to scroll to: then the wheel is the panel's. */
function canScroll(box: HTMLElement, by: number): boolean {
  const rest = box.scrollHeight - box.clientHeight;
  if (rest <= 1) return false;
  return by < 0 ? box.scrollTop > 0 : box.scrollTop < rest - 1;
}
