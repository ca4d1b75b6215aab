/** Edits of a document in the page: those that the canvas's gestures make. Others are refused by name. */

import { around } from "../../src/core/geometry";
import type { Alignment } from "../../src/core/protocol/Alignment";
import type { Edit } from "../../src/core/protocol/Edit";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { PortView } from "../../src/core/protocol/PortView";
import { IDS } from "../../src/core/catalogue";
import { takeSetting } from "./setting";
import { CATALOGUE, group, panel, slider } from "./sample";
import { component, control, object } from "./make";

interface Applied {
  objects: ObjectView[];
  made: string[];
}

export function applyEdit(objects: ObjectView[], edit: Edit): Applied {
  const change = (ids: readonly string[], how: (object: ObjectView) => ObjectView): Applied => ({
    objects: objects.map((one) => (ids.includes(one.id) ? how(one) : one)),
    made: [],
  });
  const ports = (how: (port: PortView) => PortView): Applied => ({
    objects: objects.map((one) => {
      const inputs = one.inputs.map(how);
      return inputs.every((port, k) => port === one.inputs[k]) ? one : { ...one, inputs };
    }),
    made: [],
  });
  switch (edit.do) {
    case "place":
      return placed(objects, edit);
    case "move": {
      const to = new Map(edit.objects);
      return change([...to.keys()], (one) => {
        const [x, y] = to.get(one.id) ?? [0, 0];
        return { ...one, bounds: [x, y, one.bounds[2], one.bounds[3]] };
      });
    }
    case "align":
      return aligned(objects, edit.objects, edit.how);
    case "resize":
      return change([edit.object], (one) => ({ ...one, bounds: edit.bounds }));
    case "remove": {
      const gone = new Set(edit.objects);
      return { objects: objects.filter((one) => !gone.has(one.id)), made: [] };
    }
    case "connect":
      return ports((port) => {
        if (port.id !== edit.to) return port;
        const rest = port.sources.filter((source) => source !== edit.from);
        if (edit.how === "remove") return { ...port, sources: rest };
        return { ...port, sources: edit.how === "add" ? [...rest, edit.from] : [edit.from] };
      });
    case "rewire": {
      const taken = objects.flatMap((one) => one.inputs).find((port) => port.id === edit.from)?.sources;
      return ports((port) => {
        if (taken && port.id === edit.to) return { ...port, sources: [...port.sources, ...taken] };
        if (taken && port.id === edit.from) return { ...port, sources: [] };
        const sources = port.sources.map((source) => (source === edit.from ? edit.to : source));
        return sources.every((source, k) => source === port.sources[k]) ? port : { ...port, sources };
      });
    }
    case "disconnect":
      return ports((port) => (port.id === edit.port ? { ...port, sources: [] } : port));
    case "change":
      return change(edit.objects, (one) => {
        if (edit.change.is === "nickname") return { ...one, nickname: edit.change.text };
        return edit.change.is === "hidden" ? { ...one, hidden: edit.change.on } : { ...one, disabled: edit.change.on };
      });
    case "changePort":
      return ports((port) => (port.id === edit.port ? changedPort(port, edit.change) : port));
    case "set":
      return change([edit.object], (one) => (one.control ? { ...one, control: takeSetting(one.control, edit.to) } : one));
    case "reshape":
      return change([edit.object], (one) => ({ ...one, control: edit.control }));
    case "group": {
      const members = objects.filter((one) => edit.objects.includes(one.id));
      return { objects: [{ ...group("", members), id: edit.id }, ...objects], made: [edit.id] };
    }
    case "ungroup":
      return { objects: objects.filter((one) => !edit.groups.includes(one.id)), made: [] };
    case "changeGroup":
      return change([edit.group], (one) => {
        const { control: own } = one;
        if (own?.is !== "group") return one;
        const { is: _, ...part } = edit.change;
        return { ...one, control: { ...own, ...("text" in part ? { label: part.text } : part) } };
      });
    case "duplicate":
      return copied(objects, objects.filter((one) => edit.objects.includes(one.id)), edit.by, edit.seed);
    case "paste":
      return copied(objects, JSON.parse(edit.text) as ObjectView[], [30, 30], edit.seed);
    default:
      throw new Error(`${edit.do} is not known here`);
  }
}

/** Lines objects up by the rectangle around them. Spreading is not known here. */
function aligned(objects: ObjectView[], ids: readonly string[], how: Alignment): Applied {
  const all = around(objects.filter((one) => ids.includes(one.id)).map((one) => one.bounds)) ?? [0, 0, 0, 0];
  const [x, y, w, h] = all;
  const place: Partial<Record<Alignment, (own: ObjectView["bounds"]) => [number, number]>> = {
    left: (own) => [x, own[1]],
    centre: (own) => [x + (w - own[2]) / 2, own[1]],
    right: (own) => [x + w - own[2], own[1]],
    top: (own) => [own[0], y],
    middle: (own) => [own[0], y + (h - own[3]) / 2],
    bottom: (own) => [own[0], y + h - own[3]],
  };
  const to = place[how];
  if (!to) throw new Error(`${how} is not known here`);
  const moved = objects.map((one): ObjectView => {
    const [left, top] = to(one.bounds);
    return ids.includes(one.id) ? { ...one, bounds: [left, top, one.bounds[2], one.bounds[3]] } : one;
  });
  return { objects: moved, made: [] };
}

function changedPort(port: PortView, change: Extract<Edit, { do: "changePort" }>["change"]): PortView {
  const { is, ...rest } = change;
  const value = Object.values(rest)[0] as never;
  return { ...port, [is]: value };
}

function copied(objects: ObjectView[], which: ObjectView[], [dx, dy]: readonly [number, number], seed: string): Applied {
  const ids = new Map<string, string>();
  let count = 0;
  const fresh = (id: string) => {
    const known = ids.get(id) ?? `${seed.slice(0, 24)}${String(++count).padStart(12, "0")}`;
    ids.set(id, known);
    return known;
  };
  for (const one of which) for (const each of [one, ...one.inputs, ...one.outputs]) fresh(each.id);
  const port = (own: PortView): PortView => ({
    ...own,
    id: fresh(own.id),
    sources: own.sources.map((source) => ids.get(source) ?? source),
  });
  const made = which.map((one): ObjectView => {
    const [x, y, w, h] = one.bounds;
    const inner = one.control?.is === "group" ? { ...one.control, members: one.control.members.map((id) => ids.get(id) ?? id) } : one.control;
    return { ...one, id: fresh(one.id), bounds: [x + dx, y + dy, w, h], inputs: one.inputs.map(port), outputs: one.outputs.map(port), control: inner };
  });
  return { objects: [...objects, ...made], made: made.map((one) => one.id) };
}

function placed(objects: ObjectView[], edit: Extract<Edit, { do: "place" }>): Applied {
  const [x, y] = edit.at;
  const start = edit.with?.is === "control" ? edit.with.control : undefined;
  const own = made(edit.component, [x, y], start);
  const [w, h] = [own.bounds[2], own.bounds[3]];
  const shared = own.outputs[0]?.id === own.id;
  const port = (one: PortView) => (shared ? { ...one, id: edit.id } : one);
  const next: ObjectView = {
    ...own,
    id: edit.id,
    component: edit.component,
    bounds: [x - w / 2, y - h / 2, w, h],
    inputs: own.inputs.map(port),
    outputs: own.outputs.map(port),
  };
  const from = edit.with?.is === "wire" ? edit.with.port : undefined;
  const [first] = next.inputs;
  if (from && first) first.sources = [from];
  return { objects: [...objects, next], made: [edit.id] };
}

function made(id: string, [x, y]: [number, number], start: ObjectView["control"] | undefined): ObjectView {
  if (id === IDS.slider) return control("Number Slider", [x, y, 180, 20], start ?? slider(0.25, 0, 1));
  if (id === IDS.panel) return control("Panel", [x, y, 160, 80], start ?? panel(""), { nickname: "" });
  if (id === IDS.scribble && start) return object("Scribble", [x, y, 200, 32], { kind: "scribble", control: start });
  const entry = CATALOGUE.find((one) => one.guid === id);
  if (!entry) throw new Error(`No component ${id}`);
  const side = (ports: typeof entry.inputs) => ports.map((port) => `${port.name}: ${port.kind}`);
  return component(entry.name, entry.nick || entry.name, [x, y], side(entry.inputs), side(entry.outputs));
}
