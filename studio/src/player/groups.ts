/** A visitor's inputs, under the labels of the groups that they stand in on the canvas. */

import { isGroup, leaves, type Objects } from "../core/groups";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { PlayerInput } from "../core/protocol/PlayerInput";
import { t } from "../i18n";

const KINDS = ["slider", "toggle", "button", "valueList", "swatch", "knob", "calendar", "clock", "panel"];

/** A control of the player, as it is called there and what is said of it. */
export interface ShownInput {
  object: ObjectView;
  label: string;
  help: string;
}

export interface InputGroup {
  /** Empty for those in no group with a label. */
  label: string;
  inputs: ShownInput[];
}

/** The controls that a visitor may move, from top to bottom as they stand on the canvas. */
export function playable(objects: readonly ObjectView[]): ObjectView[] {
  const read = new Set(objects.flatMap(({ inputs }) => inputs.flatMap(({ sources }) => sources)));
  const isFree = (object: ObjectView) => object.inputs.every((port) => port.sources.length === 0);
  // A panel that nothing reads is a remark.
  const isRead = ({ control, id, outputs }: ObjectView) => control?.is !== "panel" || read.has(id) || outputs.some((port) => read.has(port.id));
  return objects
    .filter((object) => object.control && KINDS.includes(object.control.is) && isFree(object) && isRead(object) && !object.disabled)
    .sort((a, b) => a.bounds[1] - b.bounds[1] || a.bounds[0] - b.bounds[0]);
}

/**
 * What a control is called: by its own name, or, where nobody gave it one, by the input that it is for: a visitor does
 * not know which panel of three is meant.
 */
function labelOf({ id, nickname, name, outputs }: ObjectView, objects: Objects): string {
  if (nickname && nickname !== name) return nickname;
  const own = new Set([id, ...outputs.map((port) => port.id)]);
  for (const reader of objects.values()) {
    const port = reader.inputs.find(({ sources }) => sources.some((source) => own.has(source)));
    if (!port) continue;
    const called = reader.nickname || reader.name;
    return reader.kind === "parameter" ? called : t("player.of", { input: port.name, object: reader.name || called });
  }
  return nickname || name;
}

/** What the player shows: what the definition publishes, else all that can be moved. */
export function shownInputs(objects: Objects, published: readonly PlayerInput[] | null): ShownInput[] {
  const all = playable([...objects.values()]);
  const own = (object: ObjectView) => labelOf(object, objects);
  if (!published) return all.map((object) => ({ object, label: own(object), help: "" }));
  return published.flatMap(({ object: id, label, help }) => {
    const object = all.find((one) => one.id === id);
    return object ? [{ object, label: label || own(object), help }] : [];
  });
}

/** The inputs that are shown by the smallest labelled group that holds each. */
export function inputGroups(objects: Objects, published: readonly PlayerInput[] | null = null): InputGroup[] {
  const groups = [...objects.values()].flatMap((object) => {
    const label = isGroup(object) && object.control?.is === "group" ? object.control.label.trim() : "";
    return label === "" ? [] : [{ label, id: object.id, holds: leaves([object.id], objects) }];
  });
  groups.sort((a, b) => a.holds.size - b.holds.size);
  const found = new Map<string, InputGroup>();
  for (const input of shownInputs(objects, published)) {
    const group = groups.find(({ holds }) => holds.has(input.object.id));
    const key = group?.id ?? "";
    const known = found.get(key) ?? { label: group?.label ?? "", inputs: [] };
    known.inputs.push(input);
    found.set(key, known);
  }
  return [...found.values()];
}
