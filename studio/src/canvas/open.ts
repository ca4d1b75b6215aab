/** Opening and closing the boxes of the canvas. */

import { boxPlace } from "../core/boxPlace";
import { IDS } from "../core/catalogue";
import type { Point, Rect } from "../core/geometry";
import { isGroup } from "../core/groups";
import type { Grip } from "../core/hit";
import type { ObjectView } from "../core/protocol/ObjectView";
import { documentStore } from "../state/document";
import { showScript } from "../dialogs/store";
import { canvasStore, type EditorAt } from "./store";
import { enter, set } from "./edits";
import { rectNow } from "./gestures/world";
import { canvasPoint, lens, paneElement, paneSize, windowPoint } from "./view";

/** Room between an object and one that the keyboard places beside it. */
const BESIDE = 150;
/** Half the height that is kept free for it. */
const ROOM = 30;

/**
 * Where the keyboard places something: to the right of what it is at, else in the middle of what is seen; below what
 * stands there already.
 */
export function keyboardPlace(): Point {
  const [w, h] = paneSize();
  const { objects } = documentStore.getState();
  const bounds = objects.get(canvasStore.getState().active ?? "")?.bounds;
  const [x, y] = bounds ? [bounds[0] + bounds[2] + BESIDE, bounds[1] + bounds[3] / 2] : canvasPoint([w / 2, h / 3]);
  return windowPoint([x, freeBelow(x, y, [...objects.values()].filter((object) => !isGroup(object)).map(rectNow))]);
}

/** The first height from `y` down where an object of the usual size about `x` is in nobody's way. */
function freeBelow(x: number, y: number, taken: readonly Rect[]): number {
  const column = taken.filter((rect) => rect[0] < x + BESIDE - 20 && rect[0] + rect[2] > x - BESIDE + 20);
  const below = column.sort((a, b) => a[1] - b[1]);
  let free = y;
  for (const rect of below) {
    if (rect[1] < free + ROOM && rect[1] + rect[3] > free - ROOM) free = rect[1] + rect[3] + ROOM + 10;
  }
  return free;
}

/** Opens the search box: at a pixel, or where the keyboard is. What was found goes there. */
export function openSearch(pixel?: Point, from?: Grip, more: readonly Grip[] = []): void {
  const where = pixel ?? keyboardPlace();
  const at = canvasPoint(where);
  canvasStore.setState({ search: { pixel: where, at, from, more }, menu: undefined, tip: undefined });
}

export function openEditor(object: string, is: EditorAt["is"], more: Partial<EditorAt> = {}): void {
  canvasStore.setState({ editor: { object, is, ...more }, menu: undefined, tip: undefined });
}

/** Closes whatever is open, and gives the focus back to the canvas. */
export function closeBoxes(): void {
  canvasStore.setState({
    menu: undefined,
    radial: undefined,
    search: undefined,
    editor: undefined,
    writing: undefined,
    connecting: undefined,
    finding: false,
    tip: undefined,
    hotWire: undefined,
  });
  focusCanvas();
}

/** Whether a box is open over the canvas; the focus may be elsewhere, as after a double-click on what opened it. */
export function isBoxOpen(): boolean {
  const { menu, radial, search, editor, connecting, finding } = canvasStore.getState();
  return Boolean(menu ?? radial ?? search ?? editor ?? connecting) || finding;
}

/** Opens the ring of commands: about a pixel, or where the keyboard is. */
export function openRadial(pixel: Point = keyboardPlace()): void {
  canvasStore.setState({ radial: pixel, menu: undefined, tip: undefined });
}

/** Gives the focus to the object that the keyboard is at, or to the canvas itself. */
export function focusCanvas(): void {
  const pane = paneElement();
  const { active } = canvasStore.getState();
  const object = active ? pane?.querySelector<HTMLElement>(`[data-object="${active}"]`) : undefined;
  (object ?? pane)?.focus({ preventScroll: true });
}

/** Whether an object is a Param Viewer. */
export function isViewer(object: ObjectView): boolean {
  return object.component === IDS.viewer;
}

/** Has a Param Viewer draw the tree, or list its paths. */
export function turnViewer(id: string): void {
  const drawing = new Set(canvasStore.getState().drawing);
  if (!drawing.delete(id)) drawing.add(id);
  canvasStore.setState({ drawing });
}

/** What a double-click on an object, or Enter, does: what the object is for. */
export function activate(id: string): void {
  const object = documentStore.getState().objects.get(id);
  if (!object) return;
  if (object.kind === "cluster") {
    void enter([...documentStore.getState().within, id]);
    return;
  }
  if (isViewer(object)) {
    turnViewer(id);
    return;
  }
  switch (object.control?.is) {
    case "panel":
    case "scribble":
      canvasStore.setState({ writing: id });
      return;
    case "toggle":
      set(id, { is: "switch", on: !object.control.on });
      return;
    case "script":
      showScript(id);
      return;
    case "formula":
      openEditor(id, "formula");
      return;
    case undefined:
      openEditor(id, "nickname");
      return;
    default:
      openEditor(id, "control");
  }
}

/** Where a box of this size about an object opens, in the window. */
export function besideObject(id: string, size: Point): Point {
  const [x, y, w, h] = documentStore.getState().objects.get(id)?.bounds ?? [0, 0, 0, 0];
  const { zoom } = lens();
  return boxPlace([...windowPoint([x, y]), w * zoom, h * zoom], size, paneSize());
}
