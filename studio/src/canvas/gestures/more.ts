/** Double-clicks, keys, and what is dropped on the canvas. */

import type { KeyboardEvent as ReactKeyboardEvent, PointerEvent as ReactPointerEvent } from "react";

import { grownAlong } from "../../core/selection";
import { middle, type Point, type Rect } from "../../core/geometry";
import { isGroup } from "../../core/groups";
import { isStarved, lookOf } from "../../core/look";
import { neighbour, readingOrder, type Direction } from "../../core/order";
import { wiresOf } from "../../core/places";
import { catalogueStore } from "../../state/catalogue";
import { documentStore } from "../../state/document";
import { runStore } from "../../state/run";
import { edit } from "../../state/session";
import { select, uiStore } from "../../state/ui";
import { moveBy, place, selection } from "../edits";
import { spoken } from "../nodes/Frame";
import { activate, closeBoxes, focusCanvas, isBoxOpen, openRadial, openSearch } from "../open";
import { canvasStore, say } from "../store";
import { canvasPoint, pixelOf, reveal, windowPoint } from "../view";
import { cancelGesture } from "./bind";
import { gripOf, rectNow, targetAt } from "./world";

/** The kind of data that an entry of the tabs is dragged as. */
export const DRAGGED = "application/x-katydid-component";

export function doubleClick(event: MouseEvent): void {
  const element = event.target instanceof Element ? event.target : null;
  if (element?.closest("[data-own], .box")) return;
  const pixel = pixelOf(event);
  const at = canvasPoint(pixel);
  const target = targetAt(element, at);
  if (target.is === "object" && !target.group) activate(target.id);
  else if (target.is === "object") openGroup(element, target.id, pixel);
  else if (target.is === "wire") {
    const id = crypto.randomUUID();
    void edit({ do: "insertRelay", id, from: target.from, to: target.to, at: [...at] });
  } else if (target.is === "void") openSearch(pixel);
}

/** A double-click on a group's label writes it; on its ground it searches, as everywhere. */
function openGroup(element: Element | null, id: string, pixel: Point): void {
  if (element?.closest(".label")) activate(id);
  else openSearch(pixel);
}

/** The click that places what was chosen in the tabs. */
export function placeClick(event: ReactPointerEvent): boolean {
  const { placing } = canvasStore.getState();
  if (!placing) return false;
  canvasStore.setState({ placing: undefined });
  if (event.button !== 0) return true;
  event.stopPropagation();
  void place({ component: placing.guid, with: null }, canvasPoint(pixelOf(event)));
  return true;
}

/** An entry of the tabs let go on the canvas. Files are the page's affair. */
export function drop(event: DragEvent): void {
  const guid = event.dataTransfer?.getData(DRAGGED);
  const entry = guid ? catalogueStore.getState().byId.get(guid) : undefined;
  if (!entry) return;
  event.preventDefault();
  event.stopPropagation();
  void place({ component: entry.guid, with: null }, canvasPoint(pixelOf(event)));
}

/** Keys that are no action: what is one is found by its shortcut, as everywhere on the page. */
export function keyDown(event: ReactKeyboardEvent): void {
  if (event.defaultPrevented || event.nativeEvent.isComposing) return;
  const element = event.target instanceof Element ? event.target : null;
  if (element?.matches("input, textarea, select") || element?.closest(".box")) return;
  // The browser tells what is pasted without asking for leave, if the key is left to it.
  if ((event.ctrlKey || event.metaKey) && !event.shiftKey && event.key.toLowerCase() === "v") {
    event.stopPropagation();
    return;
  }
  if (!ownKey(event, element)) return;
  event.preventDefault();
  event.stopPropagation();
}

const ARROWS: Record<string, Direction> = {
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowUp: "up",
  ArrowDown: "down",
};

/** Keys of the canvas itself: going through it, nudging, connecting, going into controls. */
function ownKey(event: ReactKeyboardEvent, element: Element | null): boolean {
  const arrow = ARROWS[event.key];
  const mod = event.ctrlKey || event.metaKey;
  const { active } = canvasStore.getState();
  if (event.key === "Escape") return escape(element);
  if (arrow && event.altKey) return nudge(arrow, event.shiftKey ? 1 : 10);
  if (arrow && mod) return grow(arrow);
  if (arrow) return go(arrow, event.shiftKey);
  if (mod || event.altKey) return false;
  switch (event.key) {
    case "Home":
    case "End":
      return goToEnd(event.key === "Home");
    case "Enter":
      return active === undefined ? false : into(active);
    case "c":
    case "C":
      return connect(active, event.shiftKey);
    case " ":
      if (event.shiftKey) openRadial();
      else openSearch();
      return true;
    case "ContextMenu":
      return menu(active);
    case "F10":
      return event.shiftKey && menu(active);
    default:
      return false;
  }
}

function escape(element: Element | null): boolean {
  if (cancelGesture()) return true;
  if (isBoxOpen()) closeBoxes();
  else if (canvasStore.getState().placing) canvasStore.setState({ placing: undefined });
  else if (element?.closest("[data-inner]")) focusCanvas();
  else if (canvasStore.getState().tip) canvasStore.setState({ tip: undefined });
  else if (uiStore.getState().selection.size > 0) select([]);
  else return false;
  return true;
}

const STEPS: Record<Direction, Point> = { left: [-1, 0], right: [1, 0], up: [0, -1], down: [0, 1] };

function nudge(direction: Direction, by: number): boolean {
  const [x, y] = STEPS[direction];
  void moveBy(selection(), [x * by, y * by]);
  return true;
}

function grow(direction: Direction): boolean {
  if (direction === "up" || direction === "down") return false;
  const { objects, outputs } = documentStore.getState();
  const wires = [...wiresOf(objects, outputs)].map(({ source, target }) => ({ from: source, to: target }));
  select(grownAlong(uiStore.getState().selection, wires, direction === "left" ? "up" : "down"));
  return true;
}

function placed(): (readonly [string, Rect])[] {
  const { objects } = documentStore.getState();
  return [...objects.values()].filter((object) => !isGroup(object)).map((object) => [object.id, rectNow(object)]);
}

/** Goes to the neighbour in a direction; without a place to go from, to the first object of all. */
function go(direction: Direction, extend: boolean): boolean {
  const { active } = canvasStore.getState();
  const objects = placed();
  const from = objects.find(([id]) => id === active)?.[1];
  const next = from ? neighbour(from, objects, direction) : readingOrder(objects)[0];
  if (next) goTo(next, extend);
  return true;
}

function goToEnd(first: boolean): boolean {
  const order = readingOrder(placed());
  const next = first ? order[0] : order.at(-1);
  if (next) goTo(next, false);
  return true;
}

/** Makes an object the one that the keyboard is at: it is selected, brought into view, and told. */
export function goTo(id: string, extend: boolean): void {
  const object = documentStore.getState().objects.get(id);
  if (!object) return;
  select(extend ? [...uiStore.getState().selection, id] : [id]);
  canvasStore.setState({ active: id });
  reveal(id);
  const { results, outputs } = runStore.getState();
  say(spoken(object, lookOf(object, results.get(id), isStarved(object, outputs)), true));
  // Where its element is out of sight, it takes the focus from the canvas when it comes.
  focusCanvas();
}

/** Goes into an object's own control when it has one, else does what a double-click does. */
function into(id: string): boolean {
  const inner = document.querySelector<HTMLElement>(`[data-object="${CSS.escape(id)}"] [data-inner]`);
  if (inner && document.activeElement !== inner) inner.focus({ preventScroll: true });
  else activate(id);
  return true;
}

/** Begins a wire by keyboard: from the first output, with Shift from the first input; from the other where it lacks. */
function connect(id: string | undefined, backwards: boolean): boolean {
  const object = id === undefined ? undefined : documentStore.getState().objects.get(id);
  if (!object) return false;
  const output = object.outputs[0] && gripOf(object.outputs[0].id, "output");
  const input = object.inputs[0] && gripOf(object.inputs[0].id, "input");
  const grip = backwards ? (input ?? output) : (output ?? input);
  if (grip) canvasStore.setState({ connecting: grip });
  return grip !== undefined;
}

function menu(id: string | undefined): boolean {
  const object = id === undefined ? undefined : documentStore.getState().objects.get(id);
  const at = object ? middle(rectNow(object)) : canvasPoint([200, 200]);
  const target = object ? { is: "object" as const, id: object.id, group: isGroup(object) } : { is: "void" as const };
  canvasStore.setState({ menu: { at, pixel: windowPoint(at), target } });
  return true;
}

