import { Vector3, type Mesh } from "three";
import { describe, expect, it } from "vitest";

import type { Point3, Preview, PreviewPart, Rgba } from "../../src/core/preview";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { PortView } from "../../src/core/protocol/PortView";
import { CameraRig } from "../../src/viewport/camera";
import { Batch, batchKey } from "../../src/viewport/scene/batch";
import { ColourTable } from "../../src/viewport/scene/colourTable";
import { makeDrawable, type Budget } from "../../src/viewport/scene/drawable";
import { lookOf, readable, type Layers, type ObjectState, type Palette } from "../../src/viewport/scene/looks";
import { Materials } from "../../src/viewport/scene/materials";
import { alone, merge, segmentSlots, segmentsOf, type Member } from "../../src/viewport/scene/merge";
import { Model } from "../../src/viewport/scene/model";
import { readSettings } from "../../src/viewport/settings";
import { parseColour } from "../../src/viewport/theme";
import { pieceAt } from "../../src/viewport/tools/picking";
import { keepsPoints, pointsOf } from "../../src/viewport/tools/heldPoints";
import { dragged, draggedAlong } from "../../src/viewport/tools/rays";
import { poseOf, type ViewName } from "../../src/viewport/views";

const part = (change: Partial<PreviewPart>): PreviewPart => ({
  kind: "curves", colour: null, width: 0, positions: new Float32Array(), normals: null, colours: null, values: null,
  mean: null, indices: null, texts: [], textHeight: 0, pieces: [], ...change,
});
const member = (slot: number, origin: Point3, change: Partial<PreviewPart>): Member => ({ part: part(change), origin, bounds: null, slot, values: null, isDraft: false });

describe("a batch", () => {
  it("puts parts of several origins together, and knows whose each position is", () => {
    const triangle = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    const indices = Uint16Array.from([0, 1, 2]);
    const normals = Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    const bytes = Int8Array.from([0, 0, -127, 0, 0, -127, 0, 0, -127]);
    const merged = merge(
      [
        member(7, [1000, 0, 0], { kind: "mesh", positions: triangle, indices, normals }),
        member(3, [1000, 5, 0], { kind: "mesh", positions: triangle, indices, normals: bytes }),
      ],
      [1000, 0, 0],
    );
    expect([...merged.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 5, 0, 1, 5, 0, 0, 6, 0]);
    expect([...(merged.indices ?? [])]).toEqual([0, 1, 2, 3, 4, 5]);
    expect([...(merged.normals ?? [])]).toEqual([0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, -127, 0, 0, -127, 0, 0, -127]);
    expect(merged.slots).toEqual(Uint16Array.from([7, 7, 7, 3, 3, 3]));
  });

  it("gives indices to parts that have none, when others have", () => {
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0]);
    const merged = merge(
      [member(0, [0, 0, 0], { positions, indices: Uint16Array.from([1, 0]) }), member(1, [0, 0, 0], { positions })],
      [0, 0, 0],
    );
    expect([...(merged.indices ?? [])]).toEqual([1, 0, 2, 3]);
    expect([...segmentsOf(merged)]).toEqual([1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0]);
    expect([...segmentSlots(merged.slots as Uint16Array, merged.indices)]).toEqual([0, 1]);
  });

  it("does not copy segments that already lie one after the other", () => {
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0]);
    expect(segmentsOf({ positions, indices: null })).toBe(positions);
  });

  it("is of lines of one pixel in software as long as any of it is a draft", () => {
    const software: Budget = { wide: 10, points: 10, edges: 10, areInstances: false, areDraftsThin: true };
    const materials = new Materials(new ColourTable());
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0]);
    const fine = member(0, [0, 0, 0], { positions });
    const draft = { ...fine, isDraft: true };
    const types = (members: Member[], budget = software) =>
      makeDrawable(merge(members, [0, 0, 0]), materials, budget, () => 1).objects.map(({ type }) => type);
    expect(types([fine, fine])).toEqual(["Mesh", "Mesh"]);
    expect(types([fine, draft])).toEqual(["LineSegments", "LineSegments"]);
    expect(types([draft], { ...software, areDraftsThin: false })).toEqual(["Mesh", "Mesh"]);
    expect(makeDrawable(alone(draft), materials, software, () => 1).objects[0]?.type).toBe("LineSegments");
  });

  it("is stale when something comes or goes, full at some time, and another for another look", () => {
    const batch = new Batch("x");
    const small = member(0, [0, 0, 0], { positions: new Float32Array(6) });
    batch.add(small);
    expect(batch.isStale()).toBe(true);
    batch.add(member(1, [0, 0, 0], { positions: new Float32Array(200_000) }));
    expect(batch.isFull()).toBe(true);
    expect(batchKey(part({ width: 2 }), false)).not.toBe(batchKey(part({}), false));
    expect(batchKey(part({}), false)).not.toBe(batchKey(part({}), true));
  });

  it("has a table of colours that grows and uses places again", () => {
    const table = new ColourTable();
    const slots = Array.from({ length: 600 }, () => table.take());
    expect(new Set(slots).size).toBe(600);
    table.set(599, [1, 2, 3, 4]);
    expect(table.get(599)).toEqual([1, 2, 3, 4]);
    table.give(599);
    expect(table.get(599)).toEqual([0, 0, 0, 0]);
    expect(table.take()).toBe(599);
    expect(table.uniform.value.image.data?.length).toBe(256 * 4 * 4);
  });
});

describe("a quick picture", () => {
  const preview = (parts: PreviewPart[]): Preview => ({ origin: [0, 0, 0], bounds: null, parts, draft: false }) as unknown as Preview;
  const segments = (count: number) => Float32Array.from({ length: count * 6 }, (_, k) => k % 7);
  const of = (edges: number) => {
    const model = new Model({ wide: 0, points: 10, edges, areInstances: false, areDraftsThin: true }, () => 1);
  const triangle = { kind: "mesh", positions: Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]) } as const;
    const parts = { edge: part({ kind: "edges", positions: segments(4) }), isocurve: part({ kind: "isocurves", positions: segments(5) }),
      curve: part({ kind: "curves", positions: segments(50) }), surface: part(triangle) };
    for (const [id, each] of Object.entries(parts)) {
      for (const entry of model.put(id, preview([each])).parts) model.setColour(entry, [10, 20, 30, 100]);
    }
    model.settle();
    return model;
  };
  const shown = (model: Model, id: string) => model.objects.get(id)!.parts[0]!.batch!.drawable!.objects.filter(({ visible }) => visible);

  it("leaves out edges and isocurves that are many, and lines behind surfaces", () => {
    const lines = (edges: number, isFine: boolean) => {
      const model = of(edges);
      model.choosePasses("own", isFine);
      return ["edge", "isocurve", "curve"].map((id) => shown(model, id).length);
    };
    expect(lines(9, false)).toEqual([1, 1, 1]);
    expect(lines(8, false)).toEqual([0, 0, 1]);
    expect(lines(8, true)).toEqual([2, 2, 2]);
  });

  it("finds light at the vertices, but where surfaces are analysed", () => {
    const model = of(9);
    const material = () => (model.objects.get("surface")!.parts[0]!.batch!.drawable!.surface!.colour as Mesh).material;
    model.choosePasses("own", false);
    expect(material()).toBe(model.materials.quick.translucent);
    model.choosePasses("through", false);
    expect(material()).toBe(model.materials.quick.translucent);
    model.choosePasses("solid", false);
    expect(material()).toBe(model.materials.translucent);
    model.choosePasses("own", true);
    expect(material()).toBe(model.materials.translucent);
  });
});

describe("looks", () => {
  const palette: Palette = {
    normal: [150, 0, 0, 100], selected: [0, 150, 0, 100], ink: [20, 20, 20, 255], plaster: [230, 230, 230, 255],
    background: [220, 220, 220, 255],
  };
  const layers: Layers = { edges: true, isocurves: true, points: true, controlPoints: true, texts: true };
  const plain: ObjectState = { selected: false, hovered: false, hidden: false };
  const own: Rgba = [10, 20, 200, 255];

  it("are the document's, a part's own, or green where selected", () => {
    expect(lookOf("mesh", null, plain, "shaded", palette, layers)).toEqual([150, 0, 0, 100]);
    expect(lookOf("mesh", own, plain, "shaded", palette, layers)).toEqual(own);
    expect(lookOf("mesh", own, { ...plain, selected: true }, "shaded", palette, layers)).toEqual([0, 150, 0, 100]);
    expect(lookOf("curves", null, { ...plain, selected: true }, "shaded", palette, layers).slice(0, 3)).not.toEqual([150, 0, 0]);
    expect(lookOf("mesh", null, plain, "rendered", palette, layers)).toEqual(palette.plaster);
  });

  it("are nothing where hidden, and surfaces nothing in wireframe", () => {
    expect(lookOf("curves", null, { ...plain, hidden: true }, "shaded", palette, layers)[3]).toBe(0);
    expect(lookOf("mesh", own, plain, "wireframe", palette, layers)[3]).toBe(0);
    expect(lookOf("isocurves", null, plain, "wireframe", palette, { ...layers, isocurves: false })[3]).toBeGreaterThan(0);
    expect(lookOf("isocurves", null, plain, "rendered", palette, layers)[3]).toBe(0);
    expect(lookOf("points", null, plain, "shaded", palette, { ...layers, points: false })[3]).toBe(0);
  });

  it("are brighter under the pointer", () => {
    const [red = 0, green = 0] = lookOf("mesh", null, { ...plain, hovered: true }, "shaded", palette, layers);
    expect(red > 150 && green > 0).toBe(true);
  });

  it("are seen on every background", () => {
    expect(readable([150, 0, 0, 255], [217, 220, 223, 255])).toEqual([150, 0, 0, 255]);
    const [red, green] = readable([150, 0, 0, 255], [43, 46, 49, 255]);
    expect(red).toBeGreaterThan(150);
    expect(green).toBeGreaterThan(0);
    expect(readable([255, 255, 255, 255], [255, 255, 255, 255])).not.toEqual([255, 255, 255, 255]);
  });

  it("come from whatever a browser computes", () => {
    expect(parseColour("rgb(1, 2, 3)")).toEqual([1, 2, 3, 255]);
    expect(parseColour("rgba(1, 2, 3, 0.5)")).toEqual([1, 2, 3, 128]);
    expect(parseColour("rgb(1 2 3 / 50%)")).toEqual([1, 2, 3, 128]);
    expect(parseColour("color(srgb 1 0.5 0)")).toEqual([255, 128, 0, 255]);
  });
});

describe("settings", () => {
  it("are kept by the browser, and are as usual where that makes no sense", () => {
    const kept = readSettings('{"mode":"ghosted","shown":{"grid":false,"edges":7},"trackpad":true,"analysis":"zebra"}');
    expect(kept).toMatchObject({ mode: "ghosted", trackpad: true, snap: true, analysis: "none" });
    expect(kept.shown).toMatchObject({ grid: false, edges: true, texts: true });
    for (const bad of [null, "", "{", "null", "7", '{"mode":"x","shown":null}']) expect(readSettings(bad).mode).toBe("shaded");
  });
});

describe("pieces", () => {
  it("are found in order and out of it", () => {
    const piece = (start: number, count: number, index: number) => ({ output: 0, path: "{0}", index, start, count });
    const ordered = part({ pieces: [piece(0, 3, 0), piece(3, 6, 1), piece(9, 3, 2)] });
    expect([0, 3, 8, 11, 12].map((at) => pieceAt(ordered, at)?.index)).toEqual([0, 1, 1, 2, undefined]);
    const mixed = part({ pieces: [piece(9, 3, 2), piece(0, 3, 0), piece(3, 6, 1)] });
    expect([0, 8, 11].map((at) => pieceAt(mixed, at)?.index)).toEqual([0, 1, 2]);
    const several = part({ pieces: [{ ...piece(0, 3, 5), items: 4 }, piece(12, 6, 9)] });
    expect([0, 2, 3, 11, 12].map((at) => pieceAt(several, at)?.index)).toEqual([5, 5, 6, 8, 9]);
    expect(pieceAt(several, 7)).toMatchObject({ start: 6, count: 3, index: 7 });
  });
});

describe("points that are dragged", () => {
  const placed = (view: ViewName) => {
    const rig = new CameraRig(poseOf(view));
    return { pane: { title: view, rig, left: 0, top: 0, width: 1, height: 1 }, left: 0, top: 0, width: 600, height: 400 };
  };
  const seen = (view: ViewName, point: Point3): [number, number] => {
    const { x, y } = new Vector3(...point).project(placed(view).pane.rig.camera([0, 0, 0], [[-50, -50, -50], [50, 50, 50]], 1.5));
    return [(x + 1) * 300, (1 - y) * 200];
  };

  it.each([
    ["perspective", [4, 5, 3], [7, -2, 3], false],
    ["top", [4, 5, 3], [7, -2, 3], false],
    ["front", [4, 5, 3], [7, 5, -6], false],
    ["right", [4, 5, 3], [4, 1, 8], false],
    ["perspective", [4, 5, 3], [4, 5, 9], true],
  ] as [ViewName, Point3, Point3, boolean][])("follow the pointer in the plane of the view (%s)", (view, from, to, upright) => {
    const at = dragged(placed(view), from, ...seen(view, to), upright);
    at?.forEach((value, axis) => expect(value).toBeCloseTo(to[axis] ?? 0, 5));
    expect(at).toBeDefined();
  });

  it("go along one axis alone when they are held to it", () => {
    for (const [view, axis, to] of [["perspective", 0, [9, 5, 3]], ["perspective", 2, [4, 5, -2]], ["front", 2, [4, 5, 8]]] as const) {
      const along = [0, 1, 2].map((each) => (each === axis ? 1 : 0)) as unknown as Point3;
      const at = draggedAlong(placed(view), [4, 5, 3], along, ...seen(view, [...to]));
      at?.forEach((value, each) => expect(value).toBeCloseTo(to[each] ?? 0, 5));
      expect(at).toBeDefined();
    }
    expect(draggedAlong(placed("top"), [0, 0, 0], [0, 0, 1], 300, 200)).toBeUndefined();
  });

  it("stay where they are when the plane is seen along itself", () => {
    const level = placed("perspective");
    level.pane.rig.pose = { ...level.pane.rig.pose, elevation: 0 };
    expect(dragged(level, [0, 0, 0], 300, 200, false)).toBeUndefined();
    expect(dragged(placed("top"), [0, 0, 0], 300, 200, true)).toBeUndefined();
  });

  it("belong to Point parameters that keep them", () => {
    const port = { sources: [] as string[], kept: 2 } as PortView;
    const object = { component: "FBAC3E32-f100-4292-8692-77240a42fd1a", kind: "parameter", inputs: [port] } as unknown as ObjectView;
    expect(keepsPoints(object)).toBe(true);
    expect(keepsPoints({ ...object, inputs: [{ ...port, sources: ["x"] }] })).toBe(false);
    expect(keepsPoints({ ...object, inputs: [{ ...port, kept: 0 }] })).toBe(false);
    expect(keepsPoints({ ...object, component: "other" })).toBe(false);
  });

  it("are told from other rows", () => {
    const rows = [
      { is: "path", path: "{0}", items: 2 } as const,
      { is: "item", index: 0, text: "{1, 2, 3}" } as const,
      { is: "item", index: 1, text: "null" } as const,
    ];
    expect(pointsOf(rows)).toEqual([{ row: 1, point: [1, 2, 3] }]);
  });
});
