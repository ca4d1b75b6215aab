/** What the chart of gestures may ask about the canvas, and what lies below a point or an element. */

import { alike } from "../../core/alike";
import type { Point } from "../../core/geometry";
import { isGroup, leaves } from "../../core/groups";
import { GRIP_REACH, gripAt, topmost, wireAt, WIRE_REACH, type Grip, type Strung } from "../../core/hit";
import { frameOf, gripsOf, strungOf } from "../../core/places";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { documentStore } from "../../state/document";
import { uiStore } from "../../state/ui";
import { canvasStore } from "../store";
import { lens } from "../view";
import type { Target, World } from "./chart";

/** An object's rectangle as it is drawn now. */
export function rectNow(object: ObjectView) {
  const { objects } = documentStore.getState();
  return frameOf(object, objects, canvasStore.getState().shifts, uiStore.getState().fullNames);
}

export function* allGrips(): Generator<Grip> {
  for (const object of documentStore.getState().objects.values()) yield* gripsOf(object, rectNow(object));
}

/** The grip of a port. */
export function gripOf(port: string, side: "input" | "output"): Grip | undefined {
  const { objects, inputs, outputs } = documentStore.getState();
  const place = (side === "input" ? inputs : outputs).get(port);
  const object = place ? objects.get(place.object) : undefined;
  return object && gripsOf(object, rectNow(object)).find((grip) => grip.port === port && grip.side === side);
}

function wires(): Iterable<Strung> {
  const { objects, outputs } = documentStore.getState();
  return strungOf(objects, outputs, rectNow);
}

export const world: World = {
  isSelected: (id) => uiStore.getState().selection.has(id),
  gripNear: (at, fits) => gripAt(at, allGrips(), GRIP_REACH / Math.min(lens().zoom, 1), fits),
  companions,
};

/** The grips of the other selected objects that are wired together with one of them. */
function companions(grip: Grip): Grip[] {
  const { selection } = uiStore.getState();
  if (selection.size < 2 || !selection.has(grip.object)) return [];
  const { objects } = documentStore.getState();
  const of = objects.get(grip.object);
  const port = (grip.side === "input" ? of?.inputs : of?.outputs)?.find(({ id }) => id === grip.port);
  if (!of || !port) return [];
  return [...leaves(selection, objects)].flatMap((id) => {
    const other = id === grip.object ? undefined : objects.get(id);
    const its = other && alike(of, port, other, grip.side);
    const found = its && gripOf(its.id, grip.side);
    return found ? [found] : [];
  });
}

/** The port whose name lies below the pointer: menus and tips of a port open there too. */
export function namedAt(element: Element | null): Target | undefined {
  const name = element?.closest<HTMLElement>("[data-name-of]");
  const { nameOf, side } = name?.dataset ?? {};
  const grip = nameOf && (side === "input" || side === "output") ? gripOf(nameOf, side) : undefined;
  return grip && { is: "grip", grip };
}

/** What lies below the pointer: elements say so where there are some, arithmetic in the far view. */
export function targetAt(element: Element | null, at: Point): Target {
  const grip = element?.closest<HTMLElement>("[data-port]");
  const { port, side } = grip?.dataset ?? {};
  if (port && (side === "input" || side === "output")) {
    const found = gripOf(port, side);
    if (found) return { is: "grip", grip: found };
  }
  const id = element?.closest<HTMLElement>("[data-object]")?.dataset.object;
  const object = id === undefined ? undefined : documentStore.getState().objects.get(id);
  if (object && !isGroup(object)) return { is: "object", id: object.id, group: false };
  const far = canvasStore.getState().distance === "far";
  const under = far ? farObject(at) : object;
  if (under && !isGroup(under)) return { is: "object", id: under.id, group: false };
  const wire = wireAt(at, wires(), WIRE_REACH / lens().zoom);
  if (wire) return { is: "wire", from: wire.from, to: wire.to };
  return under ? { is: "object", id: under.id, group: true } : { is: "void" };
}

/** The topmost object below a point; groups only where nothing else is. */
function farObject(at: Point): ObjectView | undefined {
  const { objects, order } = documentStore.getState();
  const rects = (groups: boolean) =>
    order.flatMap((id) => {
      const object = objects.get(id);
      return object && isGroup(object) === groups ? [[id, rectNow(object)] as const] : [];
    });
  const id = topmost(at, rects(false)) ?? topmost(at, rects(true));
  return id === undefined ? undefined : objects.get(id);
}
