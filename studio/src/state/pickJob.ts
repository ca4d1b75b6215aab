/** *Set one* and *Set multiple*: geometry is picked or drawn in the viewport for an input, which keeps it. */

import { createStore } from "zustand/vanilla";

import { drawingOf, lastPoint, SETTABLE, toolsFor, type DrawTool } from "../core/drawing";
import { distance, type Frame } from "../core/frame";
import type { Point3 } from "../core/preview";
import type { GeometrySource } from "../core/protocol/GeometrySource";
import type { PortView } from "../core/protocol/PortView";
import { documentStore } from "./document";
import { ask, edit, newGesture } from "./session";

export type PickTool = "pick" | DrawTool;

export interface PickJob {
  port: string;
  /** The type of the input. */
  kind: string;
  isMany: boolean;
  tool: PickTool;
  /** What was taken so far. */
  items: readonly GeometrySource[];
  /** The points of the drawing that is being made. */
  points: readonly Point3[];
  /** All that one job sets is one step for Undo. */
  gesture: number;
}

export const pickStore = createStore<{ job: PickJob | undefined }>(() => ({ job: undefined }));

const job = () => pickStore.getState().job;
const change = (now: Partial<PickJob>) => pickStore.setState(({ job }) => ({ job: job && { ...job, ...now } }));

/** Whether geometry can be set in an input: its data are its own, and of a type that is seen. */
export function isSettable({ kind, sources }: PortView): boolean {
  return SETTABLE.has(kind) && sources.length === 0;
}

export function beginPick({ id, kind }: PortView, isMany: boolean): void {
  // There is mostly none of these to pick.
  const tool = kind === "Point" || kind === "Plane" || kind === "Vector" ? (toolsFor(kind)[0] ?? "pick") : "pick";
  pickStore.setState({ job: { port: id, kind, isMany, tool, items: [], points: [], gesture: newGesture() } });
}

export function chooseTool(tool: PickTool): void {
  change({ tool, points: [] });
}

/** The tools of a job, to pick first. */
export function toolsOf({ kind }: PickJob): readonly PickTool[] {
  return ["pick", ...toolsFor(kind)];
}

/** Takes an item. What the session refuses is not taken; it says why. */
export async function takeSource(source: GeometrySource): Promise<void> {
  const now = job();
  if (!now) return;
  const items = now.isMany ? [...now.items, source] : [source];
  change({ items, points: [] });
  const answer = await edit({ do: "setGeometry", port: now.port, items: [...items] }, now.gesture);
  if (job()?.gesture !== now.gesture) return;
  if (!answer) change({ items: job()?.items.filter((item) => item !== source) ?? [] });
  else if (!now.isMany) pickStore.setState({ job: undefined });
}

/** Takes a point of a drawing, which is done with its last one. */
export function takePoint(point: Point3, frame: Frame): void {
  const now = job();
  if (!now || now.tool === "pick") return;
  const points = [...now.points, point];
  change({ points });
  if (points.length >= lastPoint(now.tool)) void complete(frame);
}

/** Takes the drawing as it is; where it is none yet it goes on. */
export async function complete(frame: Frame, closed = false): Promise<void> {
  const now = job();
  if (!now || now.tool === "pick") return;
  const drawing = drawingOf(now.tool, now.points, frame, closed);
  if (drawing) await takeSource({ from: "drawn", drawing });
  // Two points in one place make nothing: the second is asked for again.
  else if (now.points.length >= lastPoint(now.tool)) change({ points: now.points.slice(0, -1) });
}

/** Takes back the point that was drawn last. */
export function dropPoint(): void {
  change({ points: job()?.points.slice(0, -1) ?? [] });
}

/** Enter: ends the drawing, or all where none is being made. */
export async function finish(frame: Frame): Promise<void> {
  const now = job();
  if (!now) return;
  if (now.tool !== "pick" && drawingOf(now.tool, now.points, frame)) await complete(frame);
  else pickStore.setState({ job: undefined });
}

/** Escape: leaves the drawing, or all, and then nothing is set. */
export function leave(): void {
  const now = job();
  if (!now) return;
  if (now.points.length > 0) return change({ points: [] });
  pickStore.setState({ job: undefined });
  if (now.items.length > 0) void ask({ ask: "abandon", gesture: now.gesture }).catch(() => {});
}

/** Whether a point is where a drawing began, within a distance: there it closes. */
export function closes(point: Point3, within: number): boolean {
  const { points = [] } = job() ?? {};
  const [first] = points;
  return first !== undefined && points.length > 2 && distance(first, point) <= within;
}

// What the job is for may go away: the input, or the cluster that it is in.
documentStore.subscribe(({ inputs, within }, before) => {
  const now = job();
  if (now && (within.join() !== before.within.join() || !inputs.has(now.port))) pickStore.setState({ job: undefined });
});
