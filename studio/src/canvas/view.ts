/** The window onto the canvas: where it looks, and how it is moved. */

import { around, firstLook, fitted, toCanvas, toWindow, zoomed, type Lens, type Point, type Rect } from "../core/geometry";
import { FAR_BELOW } from "../core/far";
import { frameOf, seenFrameOf } from "../core/places";
import { documentStore } from "../state/document";
import { uiStore } from "../state/ui";
import { glide } from "./gliding";
import { canvasStore } from "./store";

/** Above this zoom (+) and (−) appear. */
const NEAR_ABOVE = 1.7;

interface Flow {
  getViewport(): Lens;
  setViewport(lens: Lens, options?: { duration?: number }): unknown;
}

let flow: Flow | undefined;
let pane: HTMLElement | undefined;

export function setFlow(next: Flow | undefined): void {
  flow = next;
}

export function setPane(next: HTMLElement | undefined): void {
  pane = next;
}

export function paneElement(): HTMLElement | undefined {
  return pane;
}

/** The element of an object, while it is in sight. */
export function objectElement(id: string): HTMLElement | undefined {
  return pane?.querySelector<HTMLElement>(`[data-object="${CSS.escape(id)}"]`) ?? undefined;
}

export function lens(): Lens {
  return flow?.getViewport() ?? { x: 0, y: 0, zoom: 1 };
}

/** How large the window is, in pixels. */
export function paneSize(): Point {
  return pane ? [pane.clientWidth, pane.clientHeight] : [1200, 800];
}

const STILL = "(prefers-reduced-motion: reduce)";

/**
 * What the window is to show as it grows or shrinks: what is seen of a document at first, all of it, or the place that
 * somebody went to.
 */
type Shown = "first" | "all" | "place";

let shown: Shown = "first";
/** Whether the first look was taken. Before it nothing is drawn, so there is nothing to glide away from. */
let isSeen = false;

/** Another document, or the inside of a cluster, came: nobody has looked at it yet. */
export function forgetLook(): void {
  [shown, isSeen] = ["first", false];
}

/** Looks elsewhere; smoothly where people want movement. */
export function look(to: Lens, smoothly = false): void {
  shown = "place";
  turn(to, smoothly);
}

function turn(to: Lens, smoothly: boolean): void {
  const duration = smoothly && isSeen && !matchMedia(STILL).matches ? 180 : 0;
  flow?.setViewport(to, duration > 0 ? { duration } : {});
}

/** The grid's squares on the canvas; from afar each holds several. */
const SQUARE = 120;

/** Called when the lens has changed. */
export function takeLens({ x, y, zoom }: Lens): void {
  const square = SQUARE * zoom * 2 ** Math.max(0, Math.ceil(Math.log2(60 / (SQUARE * zoom))));
  const grid = pane?.querySelector<HTMLElement>(".grid");
  if (grid) {
    // It reaches a square beyond the upper left: moved by less than a square it covers the pane, wherever that looks.
    grid.style.inset = `${-square}px 0 0 ${-square}px`;
    grid.style.backgroundSize = `${square}px ${square}px`;
    grid.style.transform = `translate(${within(x, square)}px, ${within(y, square)}px)`;
  }
  const distance = zoom < FAR_BELOW ? "far" : zoom > NEAR_ABOVE ? "near" : "usual";
  if (canvasStore.getState().distance !== distance) canvasStore.setState({ distance });
}

/** What is left of a length when whole squares are taken from it: from 0 to less than a square. */
function within(length: number, square: number): number {
  return length - Math.floor(length / square) * square;
}

/** What slides rests when it has not been moved for so long, in milliseconds: a hand that is slow goes on sliding. */
const SLIDE_REST = 300;
let resting: ReturnType<typeof setTimeout> | undefined;
let zoomedAt = -Infinity;

/**
 * While the canvas is panned the browser keeps what is on it as a picture of its own and moves that: else it would draw
 * each word and shadow in sight anew for each frame. At rest, and while it is zoomed, words must be sharp: then it is drawn.
 */
function slide(isSliding: boolean): void {
  const { dataset } = pane ?? {};
  if (!dataset) return;
  if (!isSliding) {
    zoomedAt = performance.now();
    delete dataset.sliding;
    return;
  }
  // Two fingers pan and zoom in turns.
  if (performance.now() - zoomedAt < SLIDE_REST) return;
  clearTimeout(resting);
  dataset.sliding = "";
  resting = setTimeout(() => delete dataset.sliding, SLIDE_REST);
}

/** A pixel of the page as one of the pane. */
export function pixelOf(event: { clientX: number; clientY: number }): Point {
  const box = pane?.getBoundingClientRect();
  return [event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0)];
}

export function canvasPoint(pixel: Point): Point {
  return toCanvas(lens(), pixel);
}

export function windowPoint(at: Point): Point {
  return toWindow(lens(), at);
}

export function panBy([dx, dy]: Point): void {
  glide();
  slide(true);
  const { x, y, zoom } = lens();
  look({ x: x + dx, y: y + dy, zoom });
}

export function zoomAt(pixel: Point, factor: number): void {
  glide();
  slide(false);
  look(zoomed(lens(), pixel, factor));
}

/** Zooms about the middle of the window. */
export function zoomBy(factor: number): void {
  const [w, h] = paneSize();
  look(zoomed(lens(), [w / 2, h / 2], factor), true);
}

export function zoomTo(zoom: number): void {
  zoomBy(zoom / lens().zoom);
}

/** What the zoom box at the lower left takes of the window's height, in pixels. */
const FOOT = 28;
/** What is left free around what is shown whole: a part of the window's shorter side, and its limits in pixels. */
const MARGIN = 0.06;
const LEAST_MARGIN = 16;
const MOST_MARGIN = 40;

/** Shows these objects whole; all when none are given. */
export function zoomExtents(ids?: Iterable<string>, smoothly = true): void {
  const { objects } = documentStore.getState();
  const { fullNames } = uiStore.getState();
  const wanted = ids ? [...ids] : [...objects.keys()];
  const rects: Rect[] = [];
  for (const id of wanted) {
    const object = objects.get(id);
    if (object) rects.push(seenFrameOf(object, objects, canvasStore.getState().shifts, fullNames));
  }
  const all = around(rects);
  const { size, margin } = roomOfPane();
  if (!all) return;
  look(fitted(all, size, ids ? 1.5 : 1, margin), smoothly);
  if (!ids) shown = "all";
}

/**
 * Takes the first look at a document that has just come, and keeps what it showed in a window that became another. Where
 * somebody already went to a place it stays there: a large document takes a moment to come, and keys are heard meanwhile.
 */
export function keepLook(): void {
  if (shown === "first") lookFirst();
  else if (shown === "all") zoomExtents(undefined, false);
  isSeen = true;
}

/** Where so many objects have a heading among them, groups and scribbles tell what is where when names cannot be read. */
const A_HEADING_FOR = 20;

/** Shows a document whole, or the beginning of one that is too long for that. */
function lookFirst(): void {
  const { objects } = documentStore.getState();
  const { fullNames } = uiStore.getState();
  const all = [...objects.values()];
  const headings = all.filter(({ control }) => (control?.is === "group" && control.label.trim() !== "") || control?.is === "scribble");
  const rects = all.map((object) => seenFrameOf(object, objects, canvasStore.getState().shifts, fullNames));
  const { size, margin } = roomOfPane();
  const first = firstLook(rects, size, margin, headings.length * A_HEADING_FOR >= all.length);
  if (first) turn(first, false);
}

/** The part of the window that is free for what is shown whole, and what is left free around it. */
function roomOfPane(): { size: Point; margin: number } {
  const [width, height] = paneSize();
  const margin = Math.min(Math.max(Math.min(width, height) * MARGIN, LEAST_MARGIN), MOST_MARGIN);
  return { size: [width, Math.max(height - FOOT, 1)], margin };
}

/** Moves the window only as far as is needed for an object to be seen. */
export function reveal(id: string): void {
  const { objects } = documentStore.getState();
  const object = objects.get(id);
  if (!object) return;
  const [x, y, w, h] = frameOf(object, objects, canvasStore.getState().shifts, uiStore.getState().fullNames);
  const { zoom, ...at } = lens();
  const [left, top] = windowPoint([x, y]);
  const [width, height] = paneSize();
  const margin = 48;
  const push = (low: number, size: number, room: number) => {
    if (low < margin) return margin - low;
    return low + size > room - margin ? Math.max(room - margin - size - low, margin - low) : 0;
  };
  const [dx, dy] = [push(left, w * zoom, width), push(top, h * zoom, height)];
  if (dx !== 0 || dy !== 0) look({ x: at.x + dx, y: at.y + dy, zoom }, true);
}
