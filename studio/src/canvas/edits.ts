/** The edits that gestures, menus and controls of the canvas ask for. */

import { inOrder } from "../core/alike";
import { holds, type Point } from "../core/geometry";
import { leaves } from "../core/groups";
import type { Grip } from "../core/hit";
import { latest, type Latest } from "../core/latest";
import { NO_SHIFTS } from "../core/places";
import { present, type Placing } from "../core/initial";
import { withRecent } from "../core/ribbon";
import type { Control } from "../core/protocol/Control";
import type { Edit } from "../core/protocol/Edit";
import type { Initial } from "../core/protocol/Initial";
import type { ObjectChange } from "../core/protocol/ObjectChange";
import type { PortChange } from "../core/protocol/PortChange";
import type { Setting } from "../core/protocol/Setting";
import { documentStore } from "../state/document";
import { ask, edit, newGesture } from "../state/session";
import { select, uiStore } from "../state/ui";
import type { Wiring } from "./gestures/chart";
import { canvasStore, keep } from "./store";
import { paneSize, reveal, windowPoint } from "./view";

/** As many components are remembered as were placed lately. */
const MOST_RECENT = 12;

/** The selected objects that are still there, in the order of drawing. */
export function selection(): string[] {
  const { order } = documentStore.getState();
  const chosen = uiStore.getState().selection;
  return order.filter((id) => chosen.has(id));
}

/** The selected objects, those of a group in its place. */
export function selectedMembers(): string[] {
  return [...leaves(selection(), documentStore.getState().objects)];
}

/** Places a component, selects it, and goes there; it is brought into view where it is out of it. */
export async function place(what: Pick<Placing, "component" | "with">, at: Point): Promise<string | undefined> {
  const id = crypto.randomUUID();
  const start = what.with ?? present(what.component, new Date());
  const done = await edit({ do: "place", id, component: what.component, at: [...at], with: start });
  if (done?.event !== "done") return undefined;
  keep({ recent: withRecent(canvasStore.getState().recent, what.component, MOST_RECENT) });
  select([id]);
  canvasStore.setState({ active: id });
  await mirrored(done.revision);
  if (!holds([0, 0, ...paneSize()], windowPoint(at))) reveal(id);
  return id;
}

/** Places a component and draws a wire between it and a grip, and from the same port of it to the others. */
export async function placeWired(component: string, at: Point, from: Grip, more: readonly Grip[] = []): Promise<string | undefined> {
  const start: Initial = { is: "wire", port: from.port };
  const id = await place({ component, with: start }, at);
  if (id === undefined || more.length === 0) return id;
  const gesture = newGesture();
  const { objects } = documentStore.getState();
  const sourcesOf = (port: string) => objects.get(from.object)?.inputs.find((one) => one.id === port)?.sources ?? [];
  const made = objects.get(id);
  const end =
    from.side === "output"
      ? made?.inputs.find(({ sources }) => sources.includes(from.port))
      : made?.outputs.find((output) => sourcesOf(from.port).includes(output.id));
  for (const grip of end ? inOrder(more) : []) {
    await edit({ do: "connect", ...ends(grip, end?.id ?? ""), how: from.side === "output" ? "add" : "replace" }, gesture);
  }
  return id;
}

/** The ends of a wire between a grip and a port of the other side. */
function ends(grip: Grip, port: string): { from: string; to: string } {
  return grip.side === "output" ? { from: grip.port, to: port } : { from: port, to: grip.port };
}

/**
 * Draws wires between several grips and one: one step for Undo. An input that reads several outputs has them from top to
 * bottom, and where wires replace those before, all of the new ones stay.
 */
export async function joinAll(from: readonly Grip[], to: Grip, how: Wiring): Promise<void> {
  const gesture = newGesture();
  let revision = 0;
  for (const [k, grip] of inOrder(from).entries()) {
    const each = how === "remove" ? how : how === "add" || (grip.side === "output" && k > 0) ? "add" : "replace";
    const done = await edit({ do: "connect", ...ends(grip, to.port), how: each }, gesture);
    if (done?.event === "done") revision = Math.max(revision, done.revision);
  }
  if (revision > 0) await mirrored(revision);
}

/** Waits until the mirror shows what an edit made, so that nothing jumps back in between. */
export async function mirrored(revision: number): Promise<void> {
  if (documentStore.getState().revision >= revision) return;
  await new Promise<void>((resolve) => {
    const stop = documentStore.subscribe((mirror) => {
      if (mirror.revision >= revision) finish();
    });
    const timer = setTimeout(finish, 1500);
    function finish() {
      clearTimeout(timer);
      stop();
      resolve();
    }
  });
}

/** Moves objects by a step; groups take their members along. */
export async function moveBy(ids: Iterable<string>, by: Point, gesture: number | null = null): Promise<void> {
  const { objects } = documentStore.getState();
  await moveEach(new Map([...leaves(ids, objects)].map((id) => [id, by])), gesture);
}

/** Moves each of these objects by its own step. */
export async function moveEach(steps: ReadonlyMap<string, Point>, gesture: number | null = null): Promise<void> {
  const { objects } = documentStore.getState();
  const places: [string, [number, number]][] = [];
  for (const [id, [dx, dy]] of steps) {
    const bounds = objects.get(id)?.bounds;
    if (bounds) places.push([id, [bounds[0] + dx, bounds[1] + dy]]);
  }
  if (places.length === 0) return;
  const done = await edit({ do: "move", objects: places }, gesture);
  if (done?.event === "done") await mirrored(done.revision);
  canvasStore.setState({ shifts: NO_SHIFTS });
}

/** Copies objects beside themselves and selects the copies. */
export async function duplicate(ids: readonly string[], by: Point): Promise<void> {
  if (ids.length === 0) return;
  const done = await edit({ do: "duplicate", objects: [...ids], by: [...by], seed: crypto.randomUUID() });
  if (done?.event === "done" && done.made.length > 0) select(done.made);
}

/** Takes objects out. A relay that goes alone leaves its wires joined. */
export async function remove(ids: readonly string[]): Promise<void> {
  const { objects } = documentStore.getState();
  const relays = ids.every((id) => objects.get(id)?.kind === "relay");
  if (!relays) {
    await edit({ do: "remove", objects: [...ids] });
    return;
  }
  const gesture = newGesture();
  for (const object of ids) await edit({ do: "removeAndJoin", object }, gesture);
}

/** Carries out what a wire was drawn for, from whichever end it was drawn. Gives whether it was taken. */
export async function joinGrips(from: Grip, to: Grip, how: Wiring): Promise<boolean> {
  const [output, input] = from.side === "output" ? [from, to] : [to, from];
  const change: Edit =
    how === "move"
      ? // Parameters have one id for both sides: which is meant is said with it.
        { do: "rewire", from: from.port, to: to.port, input: from.side === "input" }
      : { do: "connect", from: output.port, to: input.port, how };
  const done = await edit(change);
  if (done?.event !== "done") return false;
  await mirrored(done.revision);
  return true;
}

export function unwire(from: string, to: string): void {
  void edit({ do: "connect", from, to, how: "remove" });
}

export function change(objects: readonly string[], how: ObjectChange): void {
  if (objects.length > 0) void edit({ do: "change", objects: [...objects], change: how });
}

export function changePort(port: string, how: PortChange): void {
  void edit({ do: "changePort", port, change: how });
}

/** Sets a value; done when the mirror shows it. */
export async function set(object: string, to: Setting): Promise<void> {
  const done = await edit({ do: "set", object, to });
  if (done?.event === "done") await mirrored(done.revision);
}

export function reshape(object: string, control: Control, gesture: number | null = null): void {
  void edit({ do: "reshape", object, control }, gesture);
}

export function addPort(object: string, input: boolean, index: number): void {
  const added = { do: "addPort" as const, object, input, index, id: crypto.randomUUID() };
  void edit(added);
}

export function removePort(port: string): void {
  void edit({ do: "removePort", port });
}

/** Values that are set while something is dragged: one step for Undo, the newest first, Escape takes all back. */
export interface LiveSetting<T> {
  send(value: T): void;
  end(): void;
  abandon(): void;
}

/** Begins a drag that sets values. The preview is as coarse as it may be meanwhile. */
function live<T>(carry: (value: T, gesture: number) => Promise<unknown>): LiveSetting<T> {
  const gesture = newGesture();
  const line: Latest<T> = latest((value) => carry(value, gesture));
  let coarse = false;
  const finish = async (abandoned: boolean) => {
    await line.settled();
    if (abandoned) await quietly({ ask: "abandon", gesture });
    if (coarse) await quietly({ ask: "draft", on: false });
  };
  return {
    send(value) {
      if (!coarse) {
        coarse = true;
        void quietly({ ask: "draft", on: true });
      }
      line.send(value);
    },
    end: () => void finish(false),
    abandon: () => void finish(true),
  };
}

async function quietly(what: Parameters<typeof ask>[0]): Promise<void> {
  try {
    await ask(what);
  } catch {
    // What was refused stands in the line below.
  }
}

export function liveSetting(object: string): LiveSetting<Setting> {
  return live((to, gesture) => edit({ do: "set", object, to }, gesture));
}

export function liveShape(object: string): LiveSetting<Control> {
  return live((control, gesture) => edit({ do: "reshape", object, control }, gesture));
}

export function liveBounds(object: string): LiveSetting<[number, number, number, number]> {
  return live((bounds, gesture) => edit({ do: "resize", object, bounds }, gesture));
}

/** Shows the inside of a cluster, or of what lies around it. */
export async function enter(within: string[]): Promise<void> {
  try {
    await ask({ ask: "enter", within });
    select([]);
  } catch {
    // What was refused stands in the line below.
  }
}
