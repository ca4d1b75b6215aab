/** Where everything stands on the canvas, also while it is dragged: rectangles, grips and wires. */

import { growth } from "./capsule";
import { groupFrame, isGroup, type Objects } from "./groups";
import { moved, type Point, type Rect } from "./geometry";
import type { Grip, Strung } from "./hit";
import type { ObjectView } from "./protocol/ObjectView";
import { HALF_BOLD, textWidth } from "./text";

/** What stands elsewhere than the document says, and by how far: what is being dragged. */
export type Shifts = ReadonlyMap<string, Point>;

export const NO_SHIFTS: Shifts = new Map();

/** An object's rectangle. Groups are framed by their members. */
export function rectOf(object: ObjectView, shifts: Shifts, full: boolean): Rect {
  const [left, right] = growth(object, full);
  const [x, y, w, h] = object.bounds;
  const rect: Rect = [x - left, y, w + left + right, h];
  const by = shifts.get(object.id);
  return by ? moved(rect, by) : rect;
}

/** The rectangle of any object, a group's frame too. */
export function frameOf(object: ObjectView, objects: Objects, shifts: Shifts, full: boolean): Rect {
  if (!isGroup(object)) return rectOf(object, shifts, full);
  return groupFrame(object.id, objects, (member) => rectOf(member, shifts, full)) ?? object.bounds;
}

/** Where the label of a group begins within it, and its size. */
const LABEL = { left: 8, size: 12 } as const;

/** What is seen of an object: of a group its label too, which may be longer than its members reach. */
export function seenFrameOf(object: ObjectView, objects: Objects, shifts: Shifts, full: boolean): Rect {
  const [x, y, w, h] = frameOf(object, objects, shifts, full);
  const label = object.control?.is === "group" ? object.control.label.trim() : "";
  if (label === "") return [x, y, w, h];
  const lines = label.split("\n").map((line) => textWidth(line, LABEL.size) * HALF_BOLD);
  return [x, y, Math.max(w, LABEL.left + Math.max(...lines)), h];
}

/** The grips of an object. The session leaves ports out that nobody can wire, such as a slider's input. */
export function gripsOf(object: ObjectView, [x, y, w]: Rect): Grip[] {
  return [
    ...object.inputs.map((port): Grip => ({ port: port.id, object: object.id, side: "input", at: [x, y + port.at] })),
    ...object.outputs.map(
      (port): Grip => ({ port: port.id, object: object.id, side: "output", at: [x + w, y + port.at] }),
    ),
  ];
}

/** Which object an output belongs to. */
export type Outputs = ReadonlyMap<string, { object: string; index: number }>;

/** A wire by its ends' ids, and the objects that it joins. */
export interface Wire {
  from: string;
  to: string;
  source: string;
  target: string;
}

/** All wires whose ends are both here. */
export function* wiresOf(objects: Objects, outputs: Outputs): Generator<Wire> {
  for (const object of objects.values()) {
    for (const input of object.inputs) {
      for (const from of input.sources) {
        const source = outputs.get(from)?.object;
        if (source !== undefined) yield { from, to: input.id, source, target: object.id };
      }
    }
  }
}

/** The wires with the places of their ends. */
export function* strungOf(
  objects: Objects,
  outputs: Outputs,
  rect: (object: ObjectView) => Rect,
): Generator<Strung & Wire> {
  for (const wire of wiresOf(objects, outputs)) {
    const [source, target] = [objects.get(wire.source), objects.get(wire.target)];
    const output = source?.outputs[outputs.get(wire.from)?.index ?? -1];
    const input = target?.inputs.find((port) => port.id === wire.to);
    if (!source || !target || !output || !input) continue;
    const [from, to] = [rect(source), rect(target)];
    yield { ...wire, a: [from[0] + from[2], from[1] + output.at], b: [to[0], to[1] + input.at] };
  }
}
