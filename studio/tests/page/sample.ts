/** A document with one of everything that the canvas draws. */

import { IDS, type CatalogueEntry } from "../../src/core/catalogue";
import type { Control } from "../../src/core/protocol/Control";
import type { DocumentState } from "../../src/core/protocol/DocumentState";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import { component, control, id, object, port, wire } from "./make";

export function slider(value: number, min = 0, max = 10, rounding: "float" | "integer" = "float"): Control {
  return { is: "slider", value, min, max, rounding, digits: 2, expression: null };
}

export function panel(text: string): Control {
  const look = { multiline: true, paths: true, indices: true, wrap: true, specialCodes: false };
  return { is: "panel", text, ...look, alignment: 0, colour: [255, 250, 90, 255], stream: null };
}

export function group(label: string, members: ObjectView[], colour: [number, number, number, number] = [170, 135, 255, 150]): ObjectView {
  const ids = members.map((member) => member.id);
  const control: Control = { is: "group", label, colour, border: "box", members: ids };
  return object("Group", [0, 0, 10, 10], { kind: "group", nickname: label, control, previews: false });
}

export function stateOf(objects: ObjectView[], name = "sample"): DocumentState {
  return {
    revision: 1,
    within: [],
    document: {
      name,
      path: null,
      author: "",
      description: "",
      units: "Millimeters",
      tolerance: 0.001,
      angleTolerance: 1,
      previewNormal: [150, 0, 0, 100],
      previewSelected: [0, 150, 0, 100],
      changed: false,
      undo: null,
      redo: null,
      locked: false,
      player: null,
    },
    objects,
    restored: null,
    problems: [],
  };
}

export function emptyState(): DocumentState {
  return stateOf([], "empty");
}

export function sampleState(): DocumentState {
  const width = control("Number Slider", [40, 60, 190, 20], slider(3.25), { nickname: "Width", component: IDS.slider });
  const count = control("Number Slider", [40, 100, 190, 20], slider(7, 0, 20, "integer"), { nickname: "Count", component: IDS.slider });
  const series = component("Series", "Series", [300, 50], ["Start: Number", "Step: Number", "Count: Integer"], ["Series: Number"]);
  const pt = component("Construct Point", "Pt", [450, 50], ["X: Number", "Y: Number", "Z: Number"], ["Point: Point"]);
  const circle = component("Circle", "Cir", [620, 70], ["Plane: Plane", "Radius: Number"], ["Circle: Circle"], { hidden: true });
  const tree = component("Graft Tree", "Graft", [450, 150], ["Tree: Generic Data"], ["Tree: Generic Data"]);
  const broken = component("Loft", "Loft", [620, 160], ["Curves: Curve", "Options: Loft options"], ["Loft: Brep"]);
  const warned = component("Divide Curve", "Divide", [760, 60], ["Curve: Curve", "Count: Integer", "Kinks: Boolean"], ["Points: Point", "Tangents: Vector", "Parameters: Number"]);
  const off = component("Move", "Move", [760, 170], ["Geometry: Geometry", "Motion: Vector"], ["Geometry: Geometry", "Transform: Transform"], { disabled: true, strip: "Locked" });
  const unknown = component("Isotrim Plus", "IsoP", [900, 170], ["Surface: Surface"], ["Surface: Surface"], { support: { is: "no", plugin: "LunchBox", reason: "It comes from an add-on" } });
  const entwine = component("Entwine", "Entwine", [900, 50], ["{0;x}: Generic Data", "{1;x}: Generic Data"], ["Result: Generic Data"], { variableInputs: true });
  const output = component("Custom Preview", "Preview", [1060, 60], ["Geometry: Geometry", "Material: Material"], []);
  const plane = component("XY Plane", "XY", [300, 150], [], ["Plane: Plane"]);
  const own = id();
  const ownPort = port("Point", "Point", 12, { id: own, mapping: "flatten", reverse: true });
  const param = object("Point", [620, 240, 70, 24], { id: own, kind: "parameter", nickname: "Pt", inputs: [ownPort], outputs: [ownPort] });
  const note = control("Panel", [300, 240, 180, 80], panel("Hello\nthis is a panel\nwith three lines"), { nickname: "" , component: IDS.panel });
  const data = control("Panel", [760, 270, 190, 120], panel(""), { nickname: "Points", component: IDS.panel });
  const toggle = control("Boolean Toggle", [40, 140, 130, 22], { is: "toggle", on: true }, { nickname: "Closed" });
  const button = control("Button", [40, 175, 130, 22], { is: "button", normal: "False", pressed: "True" }, { nickname: "Go" });
  const items = ["Line", "Arc", "Circle"].map((name, k) => ({ name, expression: String(k), selected: k === 1 }));
  const list = control("Value List", [40, 210, 150, 22], { is: "valueList", mode: "dropDown", items }, { nickname: "List" });
  const checks = control("Value List", [40, 250, 150, 52], { is: "valueList", mode: "check", items }, { nickname: "Checks" });
  const cycle = control("Value List", [40, 315, 150, 22], { is: "valueList", mode: "cycle", items }, { nickname: "Cycle" });
  const swatch = control("Colour Swatch", [40, 350, 100, 22], { is: "swatch", colour: [220, 80, 40, 255] }, { nickname: "Tint" });
  const md = control("MD Slider", [40, 390, 130, 130], { is: "mdSlider", value: [0.3, 0.7, 0], domains: [[0, 1], [0, 1], [0, 1]] });
  const knob = control("Control Knob", [190, 390, 90, 90], { is: "knob", value: 35, min: 0, max: 100, limited: true, range: 100, decimals: 0 });
  const digits = control("Digit Scroller", [190, 495, 190, 22], { is: "digits", value: 12.5, digits: 6, radix: 3, prefix: "", suffix: "" }, { nickname: "D" });
  const genes = control("Gene Pool", [300, 350, 120, 110], { is: "genes", values: [10, 40, 70, 25, 90], decimals: 0, min: 0, max: 100 });
  const drawn = Array.from({ length: 33 }, (_, k): [number, number] => [k / 32, (k / 32) ** 2 * (3 - (2 * k) / 32)]);
  const graph = control("Graph Mapper", [440, 350, 150, 150], { is: "graph", x: [0, 1], y: [0, 1], graph: { name: "Bezier", handles: [[0, 0], [0.35, 0], [0.65, 1], [1, 1]] }, drawn });
  const grips = [[0, [255, 0, 0, 255]], [0.5, [255, 255, 0, 255]], [1, [0, 0, 255, 255]]].map(([at, colour]) => ({
    at: at as number,
    left: colour as [number, number, number, number],
    right: colour as [number, number, number, number],
  }));
  const gradient = control("Gradient", [610, 350, 170, 30], { is: "gradient", grips, linear: true });
  const viewer = { ...control("Param Viewer", [610, 400, 90, 90], { is: "formula", text: "" }), control: null };
  const script = component("C# Script", "C#", [730, 410], ["x: Generic Data", "y: Generic Data"], ["out: Text", "A: Generic Data"], {
    control: { is: "script", language: "C#", text: "A = x;", additional: null, using: null, fromWire: false, hints: [] },
    support: { is: "no", plugin: null, reason: "Scripts in C# do not run here" },
  });
  const cluster = component("Cluster", "Truss", [880, 410], ["Span: Number"], ["Truss: Curve"], { kind: "cluster" });
  const relayId = id();
  const relayPort = port("Relay", "Generic Data", 8, { id: relayId });
  const relay = object("Relay", [1000, 300, 40, 16], { id: relayId, kind: "relay", inputs: [relayPort], outputs: [relayPort] });
  const scribble = object("Scribble", [300, 10, 240, 30], {
    kind: "scribble",
    control: { is: "scribble", text: "A scribble", font: "Arial", size: 25, bold: false, italic: true, corners: [[300, 10], [540, 10], [540, 40], [300, 40]] },
  });
  const sketch = object("Sketch", [1000, 380, 100, 60], {
    kind: "sketch",
    control: { is: "sketch", colour: [0, 90, 200, 255], width: 3, lines: [[[1000, 440], [1030, 380], [1060, 430], [1100, 385]]] },
  });
  wire(width, 0, series, 1);
  wire(count, 0, series, 2);
  wire(series, 0, pt, 0);
  wire(series, 0, tree, 0);
  wire(pt, 0, circle, 0);
  wire(tree, 0, broken, 0);
  wire(circle, 0, warned, 0);
  wire(warned, 0, entwine, 0);
  wire(entwine, 0, output, 0);
  wire(pt, 0, param, 0);
  wire(param, 0, data, 0);
  wire(pt, 0, viewer, 0);
  wire(circle, 0, off, 0);
  const faint = off.inputs[1];
  if (faint) faint.wire = "faint";
  wire(plane, 0, off, 1);
  const all = [width, count, series, pt, circle, tree, broken, warned, off, unknown, entwine, output, plane, param, note, data];
  const controls = [toggle, button, list, checks, cycle, swatch, md, knob, digits, genes, graph, gradient, viewer, script, cluster, relay];
  const groups = [group("Inputs", [width, count]), group("Points", [series, pt, plane], [120, 200, 160, 130])];
  return stateOf([...groups, scribble, sketch, ...all, ...controls]);
}

function entry(name: string, nick: string, tab: string, sub: string, inputs: [string, string][], outputs: [string, string][], more: Partial<CatalogueEntry> = {}): CatalogueEntry {
  const side = (ports: [string, string][]) =>
    ports.map(([own, kind]) => ({ name: own, nick: own[0] ?? "", help: "", kind, access: "item", optional: false }));
  return {
    guid: id(),
    name,
    nick,
    tab,
    panel: sub,
    help: `${name}, for tests.`,
    keywords: [],
    floating: false,
    old: false,
    inputs: side(inputs),
    outputs: side(outputs),
    variableInputs: false,
    variableOutputs: false,
    ...more,
  };
}

export const CATALOGUE: CatalogueEntry[] = [
  entry("Number Slider", "", "Params", "Input", [], [["Number", "Number"]], { guid: IDS.slider, floating: true }),
  entry("Panel", "", "Params", "Input", [["Panel", "Generic Data"]], [["Panel", "Generic Data"]], { guid: IDS.panel, floating: true }),
  entry("Point", "Pt", "Params", "Geometry", [["Point", "Point"]], [["Point", "Point"]], { guid: IDS.point, floating: true }),
  entry("Scribble", "", "Params", "Util", [], [], { guid: IDS.scribble }),
  entry("Addition", "A+B", "Maths", "Operators", [["A", "Number"], ["B", "Number"]], [["Result", "Number"]]),
  entry("Multiplication", "A×B", "Maths", "Operators", [["A", "Number"], ["B", "Number"]], [["Result", "Number"]]),
  entry("Series", "Series", "Sets", "Sequence", [["Start", "Number"], ["Step", "Number"], ["Count", "Integer"]], [["Series", "Number"]]),
  entry("Construct Point", "Pt", "Vector", "Point", [["X coordinate", "Number"], ["Y coordinate", "Number"], ["Z coordinate", "Number"]], [["Point", "Point"]]),
  entry("Circle", "Cir", "Curve", "Primitive", [["Plane", "Plane"], ["Radius", "Number"]], [["Circle", "Circle"]]),
  entry("Divide Curve", "Divide", "Curve", "Division", [["Curve", "Curve"], ["Count", "Integer"]], [["Points", "Point"]]),
  entry("Loft", "Loft", "Surface", "Freeform", [["Curves", "Curve"]], [["Loft", "Brep"]]),
  entry("Move", "Move", "Transform", "Euclidean", [["Geometry", "Geometry"], ["Motion", "Vector"]], [["Geometry", "Geometry"]]),
];
