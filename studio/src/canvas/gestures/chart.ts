/**
 * The gestures of the canvas as a small chart of states. It knows no elements: it takes events with canvas points and
 * gives effects, so that every gesture can be tested without a browser.
 */

import { between, distance, type Point, type Rect } from "../../core/geometry";
import type { Grip } from "../../core/hit";
import { picking, type Keys, type Picking } from "../../core/selection";

/** What lies below the pointer. */
export type Target =
  | { is: "void" }
  | { is: "object"; id: string; group: boolean }
  | { is: "grip"; grip: Grip }
  | { is: "wire"; from: string; to: string };

/** What a wire does when it is let go over another grip. */
export type Wiring = "replace" | "add" | "remove" | "move";

export interface Pointer {
  /** On the canvas. */
  at: Point;
  /** In the window. */
  pixel: Point;
  keys: Keys;
}

/** Space with the left button pans at once; the middle button only when it is dragged. */
export type Button = "left" | "pan" | "middle" | "right";

export type Gesture =
  | ({ on: "down"; button: Button; target: Target } & Pointer)
  | ({ on: "move" } & Pointer)
  | ({ on: "up"; target: Target } & Pointer)
  | { on: "cancel" };

export type State =
  | { is: "idle" }
  /** The left button is down and has hardly moved. */
  | { is: "pressed"; target: Target; start: Pointer; wasSelected: boolean }
  | { is: "rightPressed"; target: Target; start: Pointer }
  | { is: "middlePressed"; target: Target; start: Pointer }
  | { is: "panning"; pixel: Point }
  | { is: "window"; start: Pointer }
  | { is: "dragging"; start: Point }
  /** Alt on the empty canvas: all that lies farther on gives way. */
  | { is: "spreading"; from: Point }
  /** `more` are the grips of other selected objects that go along. */
  | { is: "wiring"; grip: Grip; more: readonly Grip[] };

/** An elastic wire, from a grip to the pointer or to the grip that it would take hold of. */
export interface Elastic {
  grip: Grip;
  /** Grips of other selected objects from which wires go to the same end. */
  more: readonly Grip[];
  to: Point;
  end: Grip | undefined;
  how: Wiring;
}

export type Effect =
  | { do: "pan"; by: Point }
  | { do: "select"; ids: readonly string[]; how: Picking }
  | { do: "window"; window: { rect: Rect; crossing: boolean } | undefined }
  | { do: "take"; rect: Rect; crossing: boolean; how: Picking }
  | { do: "drag"; by: Point; keys: Keys }
  | { do: "drop"; by: Point; keys: Keys }
  | { do: "spread"; from: Point; to: Point; drop: boolean }
  | { do: "undrag" }
  | { do: "wire"; wire: Elastic | undefined }
  | { do: "join"; from: Grip; more: readonly Grip[]; to: Grip; how: Wiring }
  | { do: "release"; grip: Grip; more: readonly Grip[]; at: Point; pixel: Point }
  | { do: "menu"; target: Target; at: Point; pixel: Point }
  | { do: "radial"; target: Target; pixel: Point }
  | { do: "pick"; target: Target; keys: Keys };

export interface World {
  isSelected(id: string): boolean;
  /** The nearest grip that a wire can take hold of. */
  gripNear(at: Point, fits: (grip: Grip) => boolean): Grip | undefined;
  /** The grips of other selected objects that go along with one of a selected object. */
  companions(grip: Grip): readonly Grip[];
}

export const IDLE: State = { is: "idle" };

/** Pixels that a press may stray and still be a click. */
const STRAY = 4;

type Outcome = readonly [State, readonly Effect[]];

export function wiring(keys: Keys): Wiring {
  if (keys.ctrl && keys.shift) return "move";
  return keys.ctrl ? "remove" : keys.shift ? "add" : "replace";
}

/** Whether a wire that begins at one grip can end at another. */
export function joins(from: Grip, to: Grip, how: Wiring): boolean {
  if (how === "move") return from.side === to.side && from.port !== to.port;
  return from.side !== to.side && from.object !== to.object;
}

export function step(state: State, gesture: Gesture, world: World): Outcome {
  if (gesture.on === "cancel") return [IDLE, undone(state)];
  if (gesture.on === "down") return state.is === "idle" ? down(gesture, world) : [state, []];
  return gesture.on === "move" ? moved(state, gesture, world) : up(state, gesture, world);
}

function undone(state: State): Effect[] {
  switch (state.is) {
    case "window":
      return [{ do: "window", window: undefined }];
    case "dragging":
    case "spreading":
      return [{ do: "undrag" }];
    case "wiring":
      return [{ do: "wire", wire: undefined }];
    default:
      return [];
  }
}

function down(gesture: Extract<Gesture, { on: "down" }>, world: World): Outcome {
  const { target, at, pixel, keys } = gesture;
  const start: Pointer = { at, pixel, keys };
  if (gesture.button === "pan") return [{ is: "panning", pixel }, []];
  if (gesture.button === "right") return [{ is: "rightPressed", target, start }, []];
  if (gesture.button === "middle") return [{ is: "middlePressed", target, start }, []];
  if (target.is === "grip") {
    const more = world.companions(target.grip);
    return [{ is: "wiring", grip: target.grip, more }, [elastic(target.grip, more, gesture, world)]];
  }
  const wasSelected = target.is === "object" && world.isSelected(target.id);
  const pressed: State = { is: "pressed", target, start, wasSelected };
  // What is pressed is selected at once, so that a drag takes it along; a window in a group begins with Shift or Ctrl.
  const picks = target.is === "object" && !wasSelected && !asWindow(target, keys);
  const how = picking(keys);
  return [pressed, picks && how !== "remove" ? [{ do: "select", ids: [target.id], how }] : []];
}

function asWindow(target: Target, keys: Keys): boolean {
  return target.is !== "object" || (target.group && (keys.shift || keys.ctrl));
}

function moved(state: State, pointer: Pointer, world: World): Outcome {
  switch (state.is) {
    case "idle":
      return [state, []];
    case "panning": {
      const by: Point = [pointer.pixel[0] - state.pixel[0], pointer.pixel[1] - state.pixel[1]];
      return [{ is: "panning", pixel: pointer.pixel }, [{ do: "pan", by }]];
    }
    case "rightPressed":
    case "middlePressed":
      if (distance(pointer.pixel, state.start.pixel) < STRAY) return [state, []];
      return moved({ is: "panning", pixel: state.start.pixel }, pointer, world);
    case "pressed":
      if (distance(pointer.pixel, state.start.pixel) < STRAY) return [state, []];
      if (state.target.is === "void" && state.start.keys.alt) {
        return moved({ is: "spreading", from: state.start.at }, pointer, world);
      }
      if (asWindow(state.target, state.start.keys)) {
        return moved({ is: "window", start: state.start }, pointer, world);
      }
      if (state.start.keys.ctrl) return [state, []];
      return moved({ is: "dragging", start: state.start.at }, pointer, world);
    case "window":
      return [state, [{ do: "window", window: frame(state.start, pointer) }]];
    case "dragging":
      return [state, [{ do: "drag", by: offset(state.start, pointer.at), keys: pointer.keys }]];
    case "spreading":
      return [state, [{ do: "spread", from: state.from, to: pointer.at, drop: false }]];
    case "wiring":
      return [state, [elastic(state.grip, state.more, pointer, world)]];
  }
}

function up(state: State, gesture: Extract<Gesture, { on: "up" }>, world: World): Outcome {
  const { at, pixel, keys } = gesture;
  // A busy page may tell of the way only when it is over.
  if ("start" in state && "target" in state && distance(pixel, state.start.pixel) >= STRAY) {
    const [next, effects] = moved(state, gesture, world);
    if (next.is !== state.is) {
      const [end, more] = up(next, gesture, world);
      return [end, [...effects, ...more]];
    }
  }
  switch (state.is) {
    case "idle":
    case "panning":
      return [IDLE, []];
    case "rightPressed":
      return [IDLE, [{ do: "menu", target: state.target, at, pixel }]];
    case "middlePressed":
      return [IDLE, [{ do: "radial", target: state.target, pixel }]];
    case "pressed":
      return [IDLE, clicked(state)];
    case "window": {
      const { rect, crossing } = frame(state.start, gesture);
      const how = picking(keys);
      return [IDLE, [{ do: "window", window: undefined }, { do: "take", rect, crossing, how }]];
    }
    case "dragging":
      return [IDLE, [{ do: "drop", by: offset(state.start, at), keys }]];
    case "spreading":
      return [IDLE, [{ do: "spread", from: state.from, to: at, drop: true }]];
    case "wiring": {
      const how = wiring(keys);
      const end = world.gripNear(at, (grip) => joins(state.grip, grip, how));
      const clear: Effect = { do: "wire", wire: undefined };
      const more = along(state.more, end, how, world);
      if (end) return [IDLE, [clear, { do: "join", from: state.grip, more, to: end, how }]];
      const open = gesture.target.is === "void" || (gesture.target.is === "object" && gesture.target.group);
      const far = distance(at, state.grip.at) > 2 * STRAY;
      const release: Effect = { do: "release", grip: state.grip, more, at, pixel };
      return [IDLE, open && far && how !== "remove" && how !== "move" ? [clear, release] : [clear]];
    }
  }
}

/** What a click selects. A click on nothing selects nothing. */
function clicked({ target, start, wasSelected }: Extract<State, { is: "pressed" }>): Effect[] {
  const how = picking(start.keys);
  const pick: Effect = { do: "pick", target, keys: start.keys };
  if (target.is !== "object") return how === "replace" ? [{ do: "select", ids: [], how }, pick] : [pick];
  if (wasSelected || how === "remove" || asWindow(target, start.keys)) {
    return [{ do: "select", ids: [target.id], how }, pick];
  }
  return [pick];
}

function offset([ax, ay]: Point, [bx, by]: Point): Point {
  return [bx - ax, by - ay];
}

/** The window: it crosses when it is drawn to the left. */
function frame(start: Pointer, pointer: Pointer): { rect: Rect; crossing: boolean } {
  return { rect: between(start.at, pointer.at), crossing: pointer.at[0] < start.at[0] };
}

function elastic(grip: Grip, more: readonly Grip[], pointer: Pointer, world: World): Effect {
  const how = wiring(pointer.keys);
  const end = world.gripNear(pointer.at, (other) => joins(grip, other, how));
  return { do: "wire", wire: { grip, more: along(more, end, how, world), to: end?.at ?? pointer.at, end, how } };
}

/**
 * The grips that go along to an end. None do to another selected object, which is meant as one of them, and none where
 * all wires of a grip are taken elsewhere.
 */
function along(more: readonly Grip[], end: Grip | undefined, how: Wiring, world: World): readonly Grip[] {
  return how === "move" || (end && world.isSelected(end.object)) ? [] : more;
}
