/**
 * The document as the nodes and edges that xyflow mounts. They hold places only: what an object is and what the solver
 * says of it is read by each element for itself, so that neither a solve nor a slider touches a node. Nodes of what has
 * not moved stay the same values, and so do the lists of them.
 */

import { Position, type Edge, type Node, type NodeHandle } from "@xyflow/react";

import { depths, isGroup, type Objects } from "../core/groups";
import { frameOf, gripsOf, wiresOf, type Outputs, type Shifts } from "../core/places";
import type { Rect } from "../core/geometry";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { WireView } from "../core/protocol/WireView";

export interface CanvasNodeData extends Record<string, unknown> {
  /** Its size as it is drawn; wider than the document's when full names are shown. */
  size: readonly [number, number];
}

export interface WireData extends Record<string, unknown> {
  from: string;
  to: string;
  view: WireView;
}

export type CanvasNode = Node<CanvasNodeData>;
export type WireEdge = Edge<WireData>;

interface Kept {
  object: ObjectView;
  rect: Rect;
  z: number;
  node: CanvasNode;
}

/** Above groups come wires, above wires objects. */
const WIRES = 20;
const OBJECTS = 40;

/** Makes nodes, and knows those it made before. */
export class NodeMaker {
  #kept = new Map<string, Kept>();
  #depths: { objects: Objects; of: Map<string, number> } | undefined;
  #made: CanvasNode[] = [];
  #from: readonly unknown[] = [];

  /** The same list as before where no node is another. */
  make(objects: Objects, order: readonly string[], shifts: Shifts, full: boolean): CanvasNode[] {
    const from = [objects, order, shifts, full];
    if (from.every((part, at) => part === this.#from[at])) return this.#made;
    this.#from = from;
    if (this.#depths?.objects !== objects) this.#depths = { objects, of: depths(objects) };
    const depth = this.#depths.of;
    const kept = new Map<string, Kept>();
    const nodes: CanvasNode[] = [];
    for (const id of order) {
      const object = objects.get(id);
      if (!object) continue;
      const rect = frameOf(object, objects, shifts, full);
      const z = isGroup(object) ? Math.min(depth.get(id) ?? 0, WIRES - 1) : OBJECTS;
      const old = this.#kept.get(id);
      const same = old?.z === z && old.rect.every((part, k) => part === rect[k]) && standsAlike(old.object, object);
      const one = same ? { ...old, object } : { object, rect, z, node: node(object, rect, z) };
      kept.set(id, one);
      nodes.push(one.node);
    }
    this.#kept = kept;
    const isSame = nodes.length === this.#made.length && nodes.every((each, at) => each === this.#made[at]);
    if (!isSame) this.#made = nodes;
    return this.#made;
  }
}

/** Whether two states of an object are the same node, where their rectangles are: of one kind, with the same grips. */
function standsAlike(a: ObjectView, b: ObjectView): boolean {
  if (a === b) return true;
  const alike = (side: "inputs" | "outputs") =>
    a[side].length === b[side].length && a[side].every(({ id, at }, k) => id === b[side][k]?.id && at === b[side][k]?.at);
  return a.kind === b.kind && alike("inputs") && alike("outputs");
}

function node(object: ObjectView, rect: Rect, zIndex: number): CanvasNode {
  const [x, y, w, h] = rect;
  // Whole numbers: the browser measures elements in them, and what it finds must agree with what is said here.
  const [width, height] = [Math.max(Math.round(w), 1), Math.max(Math.round(h), 1)];
  const handles = gripsOf(object, rect).map(
    (grip): NodeHandle => ({
      id: grip.port,
      type: grip.side === "input" ? "target" : "source",
      position: grip.side === "input" ? Position.Left : Position.Right,
      x: grip.at[0] - x,
      y: grip.at[1] - y,
      width: 0,
      height: 0,
    }),
  );
  return {
    id: object.id,
    type: `k-${object.kind}`,
    position: { x, y },
    width,
    height,
    measured: { width, height },
    handles,
    zIndex,
    data: { size: [w, h] },
  };
}

/** Makes edges, and knows those it made before. */
export class EdgeMaker {
  #kept = new Map<string, WireEdge>();
  #made: WireEdge[] = [];
  #from: readonly unknown[] = [];

  /** The same list as before where no wire is another: the canvas looks through none of them then. */
  make(objects: Objects, outputs: Outputs): WireEdge[] {
    if (this.#from[0] === objects && this.#from[1] === outputs) return this.#made;
    this.#from = [objects, outputs];
    const kept = new Map<string, WireEdge>();
    for (const wire of wiresOf(objects, outputs)) {
      const id = `${wire.from}>${wire.to}`;
      const view = objects.get(wire.target)?.inputs.find((port) => port.id === wire.to)?.wire ?? "normal";
      const old = this.#kept.get(id);
      const same = old?.source === wire.source && old.target === wire.target && old.data?.view === view;
      kept.set(id, same ? old : edge(id, wire.source, wire.target, { from: wire.from, to: wire.to, view }));
    }
    this.#kept = kept;
    const made = [...kept.values()];
    const isSame = made.length === this.#made.length && made.every((each, at) => each === this.#made[at]);
    if (!isSame) this.#made = made;
    return this.#made;
  }
}

function edge(id: string, source: string, target: string, data: WireData): WireEdge {
  const ends = { sourceHandle: data.from, targetHandle: data.to };
  return { id, type: "wire", source, target, ...ends, zIndex: WIRES, data };
}
