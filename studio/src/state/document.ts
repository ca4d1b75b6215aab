/** A mirror of the document in Rust: changed by the session's events only. */

import { createStore } from "zustand/vanilla";

import type { DocumentState } from "../core/protocol/DocumentState";
import type { DocumentView } from "../core/protocol/DocumentView";
import type { Event } from "../core/protocol/Event";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { Problem } from "../core/protocol/Problem";
import type { Restored } from "../core/protocol/Restored";

/** Where a port is. */
export interface PortPlace {
  object: string;
  side: "input" | "output";
  index: number;
}

export interface DocumentMirror {
  revision: number;
  /** The clusters that lead to what is shown. */
  within: string[];
  document: DocumentView | undefined;
  /** The objects by id. The map is another one after every change, its values only where they changed. */
  objects: ReadonlyMap<string, ObjectView>;
  /** The ids in the order of drawing. */
  order: readonly string[];
  /** Inputs and outputs by their ids. A floating parameter's port has its object's id on both sides. */
  inputs: ReadonlyMap<string, PortPlace>;
  outputs: ReadonlyMap<string, PortPlace>;
  restored: Restored | null;
  problems: Problem[];
}

const EMPTY: DocumentMirror = {
  revision: 0,
  within: [],
  document: undefined,
  objects: new Map(),
  order: [],
  inputs: new Map(),
  outputs: new Map(),
  restored: null,
  problems: [],
};

export const documentStore = createStore<DocumentMirror>(() => EMPTY);

/** Takes an event that speaks of the document; others pass by. */
export function takeDocument(event: Event): void {
  if (event.event === "document") documentStore.setState(whole(event));
  else if (event.event === "patch") documentStore.setState((mirror) => patched(mirror, event));
}

function whole(state: DocumentState): DocumentMirror {
  const objects = new Map(state.objects.map((object) => [object.id, object]));
  const { revision, within, document, restored, problems } = state;
  const order = state.objects.map((object) => object.id);
  return { revision, within, document, objects, order, ...ports(objects), restored, problems };
}

/** The mirror after a patch. Exported for tests. */
export function patched(mirror: DocumentMirror, patch: Extract<Event, { event: "patch" }>): DocumentMirror {
  const document = patch.document ?? mirror.document;
  if (patch.within.join() !== mirror.within.join()) return { ...mirror, document };
  const touched = patch.put.length > 0 || patch.removed.length > 0;
  const objects = touched ? new Map(mirror.objects) : mirror.objects;
  if (objects instanceof Map) {
    for (const object of patch.put) objects.set(object.id, object);
    for (const id of patch.removed) objects.delete(id);
  }
  const order = patch.order ?? (touched ? reordered(mirror.order, objects) : mirror.order);
  const isSame = patch.removed.length === 0 && patch.put.every((object) => hasPortsOf(object, mirror.objects.get(object.id)));
  const known = isSame ? { inputs: mirror.inputs, outputs: mirror.outputs } : ports(objects);
  return { ...mirror, revision: patch.revision, document, objects, order, ...known };
}

/** The order without what is gone; what is new comes last. */
function reordered(order: readonly string[], objects: ReadonlyMap<string, ObjectView>): readonly string[] {
  const kept = order.filter((id) => objects.has(id));
  if (kept.length === order.length && kept.length === objects.size) return order;
  const known = new Set(kept);
  return [...kept, ...[...objects.keys()].filter((id) => !known.has(id))];
}

/** Whether an object has the ports that it had: a slider that is dragged changes none. */
function hasPortsOf(now: ObjectView, before: ObjectView | undefined): boolean {
  const isSame = (side: "inputs" | "outputs") =>
    now[side].length === before?.[side].length && now[side].every(({ id }, at) => id === before[side][at]?.id);
  return isSame("inputs") && isSame("outputs");
}

function ports(objects: ReadonlyMap<string, ObjectView>): Pick<DocumentMirror, "inputs" | "outputs"> {
  const inputs = new Map<string, PortPlace>();
  const outputs = new Map<string, PortPlace>();
  for (const { id: object, ...sides } of objects.values()) {
    sides.inputs.forEach((port, index) => inputs.set(port.id, { object, side: "input", index }));
    sides.outputs.forEach((port, index) => outputs.set(port.id, { object, side: "output", index }));
  }
  return { inputs, outputs };
}
