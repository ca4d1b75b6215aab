/** The far view: when names cannot be read any more, boxes and wires are drawn on one sheet instead of many elements. */

import type { Point, Rect } from "./geometry";
import { meets } from "./geometry";
import { depths, isGroup, type Objects } from "./groups";
import { isStarved, lookOf, type Look } from "./look";
import { frameOf, strungOf, type Outputs, type Shifts } from "./places";
import { dayText, timeText } from "./dates";
import { numberText } from "./numbers";
import type { Control } from "./protocol/Control";
import type { ObjectView } from "./protocol/ObjectView";
import type { OutputView } from "./protocol/OutputView";
import type { ResultView } from "./protocol/ResultView";
import { css } from "./colours";
import { sliderText } from "./slider";
import { t } from "../i18n";
import { wireLook, type WireLook } from "./wires";

/** Below this zoom the canvas is drawn in the far way. */
export const FAR_BELOW = 0.5;

/** Rows of a panel's data that can be made out from afar, at most. */
const MOST_ROWS = 40;

export interface FarBox {
  id: string;
  rect: Rect;
  look: Look;
  /** A colour of its own, as CSS: of groups, panels, swatches. */
  colour: string | undefined;
  kind: "group" | "box" | "text" | "lines" | "dot";
  lines: readonly (readonly (readonly [number, number])[])[];
  /** What is written on it. */
  label: FarLabel | undefined;
  /** The message below it. */
  strip: string | undefined;
  /** The component whose picture stands on it where no name does, or even instead of its name. */
  icon: { component: string; name: string; forName: boolean } | undefined;
  selected: boolean;
}

export interface FarLabel {
  text: string;
  /** What is left of it where there is less room: the value of a slider. */
  short?: string;
  size: number;
  across: "left" | "centre" | "right";
  bold: boolean;
  /** Whether it is a name, or text of which the first lines are shown. */
  lines: "one" | "many";
}

export interface FarWire {
  a: Point;
  b: Point;
  look: WireLook;
}

export interface FarList {
  /** From the back to the front. */
  groups: FarBox[];
  wires: FarWire[];
  boxes: FarBox[];
}

export interface FarInput {
  objects: Objects;
  order: readonly string[];
  outputs: Outputs;
  results: ReadonlyMap<string, ResultView>;
  data: ReadonlyMap<string, OutputView>;
  selection: ReadonlySet<string>;
  shifts: Shifts;
  full: boolean;
}

/** Everything to draw, in canvas units: it holds until something changes, however the canvas is panned. */
export function farList(input: FarInput): FarList {
  const { objects, order, selection } = input;
  const rects = new Map<string, Rect>();
  const rect = (object: ObjectView): Rect => {
    const known = rects.get(object.id);
    if (known) return known;
    const found = frameOf(object, objects, input.shifts, input.full);
    rects.set(object.id, found);
    return found;
  };
  const list: FarList = { groups: [], wires: [], boxes: [] };
  for (const id of order) {
    const object = objects.get(id);
    if (!object) continue;
    const result = input.results.get(id);
    const box = farBox(object, rect(object), lookOf(object, result, isStarved(object, input.data)), selection.has(id), result);
    (isGroup(object) ? list.groups : list.boxes).push(box);
  }
  const depth = depths(objects);
  list.groups.sort((a, b) => (depth.get(a.id) ?? 0) - (depth.get(b.id) ?? 0));
  for (const wire of strungOf(objects, input.outputs, rect)) {
    const target = objects.get(wire.target)?.inputs.find((port) => port.id === wire.to);
    const chosen = selection.has(wire.source) || selection.has(wire.target);
    const look = wireLook(input.data.get(wire.from)?.structure, target?.wire ?? "normal", chosen);
    if (!look.wireless) list.wires.push({ a: wire.a, b: wire.b, look });
  }
  return list;
}

function farBox(
  object: ObjectView,
  rect: Rect,
  look: Look,
  selected: boolean,
  result: ResultView | undefined,
): FarBox {
  const box: FarBox = {
    id: object.id,
    rect,
    look,
    colour: undefined,
    kind: "box",
    lines: [],
    label: undefined,
    strip: object.strip?.trim() || undefined,
    icon: undefined,
    selected,
  };
  const { control } = object;
  switch (control?.is) {
    case "group":
      return { ...box, kind: "group", colour: css(control.colour), label: label(control.label, 12, "left", true) };
    case "panel":
      return { ...box, colour: css(control.colour), label: label(shown(object, control.text, result), 11, across(control.alignment), false, "many") };
    case "swatch":
      return { ...box, colour: css(control.colour) };
    case "scribble":
      return { ...box, kind: "text", label: label(control.text, control.size, "left", control.bold) };
    case "sketch":
      return { ...box, kind: "lines", lines: control.lines, colour: css(control.colour) };
    default: {
      if (object.kind === "relay") return { ...box, kind: "dot" };
      const name = object.nickname.trim() || object.name;
      const value = control ? valueOf(control) : undefined;
      const named = label(value === undefined ? name : `${name} ${value}`, 11, "centre");
      return {
        ...box,
        label: named && value !== undefined ? { ...named, short: value } : named,
        icon: iconOf(object),
      };
    }
  }
}

/** What a control is set to, in a word. */
function valueOf(control: Control): string | undefined {
  switch (control.is) {
    case "slider":
      return sliderText(control, control.value);
    case "toggle":
      return t(control.on ? "canvas.true" : "canvas.false");
    case "knob":
    case "digits":
      return numberText(control.value);
    case "calendar":
      return dayText(control.date);
    case "clock":
      return timeText(control.seconds);
    case "valueList":
      return control.items.find(({ selected }) => selected)?.name;
    default:
      return undefined;
  }
}

/** Clusters are told apart by their names alone; sliders and the like keep theirs while they can be read. */
function iconOf(object: ObjectView): FarBox["icon"] {
  if (object.kind === "cluster") return undefined;
  return { component: object.component, name: object.name, forName: !object.control };
}

/** What a panel shows: its own text, or the first of what comes in. */
function shown(object: ObjectView, text: string, result: ResultView | undefined): string {
  if ((object.inputs[0]?.sources.length ?? 0) === 0) return text;
  const rows = result?.panel?.rows ?? [];
  return rows
    .slice(0, MOST_ROWS)
    .map((row) => (row.is === "path" ? row.path : row.text))
    .join("\n");
}

function across(alignment: number): "left" | "centre" | "right" {
  return alignment === 1 ? "centre" : alignment === 2 ? "right" : "left";
}

function label(text: string, size: number, side: FarLabel["across"], bold = false, lines: FarLabel["lines"] = "one"): FarBox["label"] {
  const trimmed = text.trim();
  return trimmed === "" ? undefined : { text: trimmed, size, across: side, bold, lines };
}

/** What of the list is in a rectangle of the canvas. */
export function seen<T extends { rect: Rect }>(boxes: readonly T[], field: Rect): T[] {
  return boxes.filter((box) => meets(box.rect, field));
}
