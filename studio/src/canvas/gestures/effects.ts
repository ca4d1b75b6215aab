/** What the effects of gestures do: to the stores while they go on, to the document when they end. */

import { snap } from "../../core/align";
import { around, inside, type Point, type Rect } from "../../core/geometry";
import { isGroup, leaves } from "../../core/groups";
import { NO_SHIFTS } from "../../core/places";
import { spreadSteps } from "../../core/spread";
import { picked, windowed, type Keys } from "../../core/selection";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { documentStore } from "../../state/document";
import { select, uiStore } from "../../state/ui";
import { duplicate, joinAll, joinGrips, moveBy, moveEach, selection } from "../edits";
import { openRadial, openSearch } from "../open";
import { canvasStore } from "../store";
import { lens, panBy } from "../view";
import type { Effect, Target } from "./chart";
import { rectNow } from "./world";

export function carryOut(effect: Effect): void {
  switch (effect.do) {
    case "pan":
      panBy(effect.by);
      return;
    case "select":
      select(picked(uiStore.getState().selection, effect.ids, effect.how));
      if (effect.how !== "remove") canvasStore.setState({ active: effect.ids[0] });
      return;
    case "window":
      canvasStore.setState({ window: effect.window });
      return;
    case "take":
      select(picked(uiStore.getState().selection, taken(effect.rect, effect.crossing), effect.how));
      return;
    case "drag":
      drag(effect.by, effect.keys);
      return;
    case "drop":
      drop(effect.by, effect.keys);
      return;
    case "spread":
      spread(effect.from, effect.to, effect.drop);
      return;
    case "undrag":
      canvasStore.setState({ shifts: NO_SHIFTS, ghosts: [], guides: [] });
      return;
    case "wire":
      canvasStore.setState({ wire: effect.wire });
      return;
    case "join":
      void (effect.more.length === 0
        ? joinGrips(effect.from, effect.to, effect.how)
        : joinAll([effect.from, ...effect.more], effect.to, effect.how));
      return;
    case "release":
      openSearch(effect.pixel, effect.grip, effect.more);
      return;
    case "menu":
      pickForMenu(effect.target);
      canvasStore.setState({ menu: { pixel: effect.pixel, at: effect.at, target: effect.target }, tip: undefined });
      return;
    case "radial":
      pickForMenu(effect.target);
      openRadial(effect.pixel);
      return;
    case "pick":
      if (effect.target.is === "object" && effect.keys.ctrl && effect.keys.alt) pointAt(effect.target.id);
      return;
  }
}

/** What a menu is opened on is selected: commands in it are about the selection. A group's menu is about both. */
function pickForMenu(target: Target): void {
  const id = target.is === "object" && !target.group ? target.id : target.is === "grip" ? target.grip.object : undefined;
  if (id === undefined || uiStore.getState().selection.has(id)) return;
  select([id]);
  canvasStore.setState({ active: id });
}

/** Shows in the tabs where an object's component lives. */
function pointAt(id: string): void {
  const object = documentStore.getState().objects.get(id);
  if (object) canvasStore.setState({ pointedAt: object.component, ribbon: true });
}

/** What a window takes. A group is taken only when it lies inside whole: else its area would always come along. */
function taken(window: Rect, crossing: boolean): string[] {
  const { objects, order } = documentStore.getState();
  const rects: (readonly [string, Rect])[] = [];
  const groups: string[] = [];
  for (const id of order) {
    const object = objects.get(id);
    if (!object) continue;
    const rect = rectNow(object);
    if (!isGroup(object)) rects.push([id, rect]);
    else if (inside(rect, window)) groups.push(id);
  }
  return [...groups, ...windowed(window, crossing, rects)];
}

interface Dragged {
  leaves: Set<string>;
  rect: Rect;
  others: Rect[];
}

let dragged: Dragged | undefined;

/** What is dragged and what stays, gathered when a drag begins. */
function gather(): Dragged | undefined {
  const { objects } = documentStore.getState();
  const moving = leaves(selection(), objects);
  const rects: Rect[] = [];
  const others: Rect[] = [];
  for (const object of objects.values()) {
    if (moving.has(object.id)) rects.push(still(object));
    else if (!isGroup(object)) others.push(still(object));
  }
  const rect = around(rects);
  return rect && { leaves: moving, rect, others };
}

function still(object: ObjectView): Rect {
  return object.bounds;
}

/** The step of a drag: lined up with what is near, unless Ctrl says not to. */
function stepOf(by: Point, keys: Keys) {
  const free = keys.ctrl || !canvasStore.getState().snapping || !dragged;
  return free ? { by, guides: [] } : snap(dragged?.rect ?? [0, 0, 0, 0], by, dragged?.others ?? [], 5 / lens().zoom);
}

function drag(by: Point, keys: Keys): void {
  dragged ??= gather();
  if (!dragged) return;
  const step = stepOf(by, keys);
  if (keys.alt) {
    const { objects } = documentStore.getState();
    const ghosts = [...dragged.leaves].flatMap((id) => {
      const object = objects.get(id);
      return object ? [shifted(object.bounds, step.by)] : [];
    });
    canvasStore.setState({ shifts: NO_SHIFTS, ghosts, guides: step.guides });
    return;
  }
  const shifts = new Map([...dragged.leaves].map((id) => [id, step.by]));
  canvasStore.setState({ shifts, ghosts: [], guides: step.guides });
}

function shifted([x, y, w, h]: Rect, [dx, dy]: Point): Rect {
  return [x + dx, y + dy, w, h];
}

function drop(by: Point, keys: Keys): void {
  const step = stepOf(by, keys);
  canvasStore.setState({ ghosts: [], guides: [] });
  dragged = undefined;
  if (keys.alt) void duplicate(selection(), step.by);
  else void moveBy(selection(), step.by);
}

/** Makes room: shown while the hand goes on, asked for when it is done. */
function spread(from: Point, to: Point, done: boolean): void {
  const { objects } = documentStore.getState();
  const rects = [...objects.values()].filter((object) => !isGroup(object)).map((object) => [object.id, object.bounds] as const);
  const steps = spreadSteps(rects, from, to);
  canvasStore.setState({ shifts: steps });
  if (done) void moveEach(steps);
}

/** Forgets what was gathered for a drag that came to nothing. */
export function forgetDrag(): void {
  dragged = undefined;
}
