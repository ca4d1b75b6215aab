import { describe, expect, test } from "vitest";

import { snap } from "../../src/core/align";
import { capsuleLayout, growth, tornPath } from "../../src/core/capsule";
import { tabs } from "../../src/core/catalogue";
import { fromHex, gradientCss, hex, inkOn } from "../../src/core/colours";
import { farList } from "../../src/core/far";
import { found } from "../../src/core/find";
import { firstLook, fitted, STRUCTURE_BELOW, toCanvas, toWindow, zoomed, type Rect } from "../../src/core/geometry";
import { draggable, withHandle } from "../../src/core/graph";
import { blobPath, depths, groupFrame, hull, leaves } from "../../src/core/groups";
import { gripAt, topmost, wireAt } from "../../src/core/hit";
import { fit } from "../../src/core/kinds";
import { latest } from "../../src/core/latest";
import { emptyInputs, isStarved, lookOf } from "../../src/core/look";
import { digitsText, numberText, timeText } from "../../src/core/numbers";
import { neighbour, readingOrder } from "../../src/core/order";
import { gripsOf, NO_SHIFTS, rectOf, strungOf, wiresOf } from "../../src/core/places";
import { search } from "../../src/core/search";
import { grownAlong, picked, windowed } from "../../src/core/selection";
import { cut, textWidth, wrapped } from "../../src/core/text";
import { wheelMeans } from "../../src/core/wheel";
import { component, wire } from "../page/make";
import { CATALOGUE, group, sampleState, stateOf } from "../page/sample";
import { resultsOf } from "../page/results";
import type { GraphView } from "../../src/core/protocol/GraphView";
import type { ObjectView } from "../../src/core/protocol/ObjectView";

const byId = (list: ObjectView[]) => new Map(list.map((one) => [one.id, one]));
const outputsOf = (list: ObjectView[]) =>
  new Map(list.flatMap((one) => one.outputs.map((port, index) => [port.id, { object: one.id, index }] as const)));

describe("the window onto the canvas", () => {
  const lens = { x: 30, y: -20, zoom: 0.7 };
  test("pixels and points answer each other", () => {
    const at = toCanvas(lens, toWindow(lens, [12, 34]));
    expect(at[0]).toBeCloseTo(12);
    expect(at[1]).toBeCloseTo(34);
  });
  test("zooming leaves the point below the pointer", () => {
    const before = toCanvas(lens, [200, 100]);
    for (const factor of [0.5, 1.3, 1e9, 1e-9]) {
      const after = toCanvas(zoomed(lens, [200, 100], factor), [200, 100]);
      expect(after[0]).toBeCloseTo(before[0]);
      expect(after[1]).toBeCloseTo(before[1]);
    }
  });
  test("what is as long as hundreds of windows is seen whole too", () => {
    const rect: Rect = [-500, 20, 4000, 30_000];
    const all = fitted(rect, [390, 215], 1, 16);
    for (const corner of [[-500, 20], [3500, 30_020]] as const) {
      const [x, y] = toWindow(all, corner);
      expect(Math.min(x, y, 390 - x, 215 - y)).toBeGreaterThanOrEqual(16 - 1e-9);
    }
  });

  describe("at first", () => {
    const size: [number, number] = [740, 590];
    test("all is seen of what can be read then", () => {
      const short: Rect = [10, 20, 4000, 900];
      expect(firstLook([short], size, 35)).toEqual(fitted(short, size, 1, 35));
      expect(firstLook([], size, 35)).toBeUndefined();
    });
    test("most is seen of what could not be read if all were", () => {
      const wide: Rect[] = [[0, 0, 100, 40], [6000, 100, 200, 400]];
      const seen = firstLook(wide, size, 35);
      expect(fitted([0, 0, 6200, 500], size, 1, 35).zoom).toBeLessThan(STRUCTURE_BELOW);
      expect(seen?.zoom).toBe(STRUCTURE_BELOW);
      // Headings can be read from farther away.
      expect(firstLook(wide, size, 35, true)).toEqual(fitted([0, 0, 6200, 500], size, 1, 35));
      expect(seen && toWindow(seen, [0, 250])).toEqual([expect.closeTo(35), expect.closeTo(size[1] / 2)]);
    });
    test("a long column is seen from its top, in the middle", () => {
      const column = Array.from({ length: 400 }, (_, k): Rect => [-50, 80 + 90 * k, 440, 60]);
      const seen = firstLook(column, size, 35);
      expect(seen?.zoom).toBe(0.5);
      expect(seen && toWindow(seen, [170, 80])).toEqual([370, 35]);
    });
    test("of what is long and wide that part of the beginning is seen where most of it stands", () => {
      const lonely: Rect = [0, 0, 60, 40];
      const block = Array.from({ length: 900 }, (_, k): Rect => [9_000 + (k % 3) * 100, Math.floor(k / 3) * 100, 60, 40]);
      const seen = firstLook([lonely, ...block], size, 35);
      expect(seen?.zoom).toBeGreaterThanOrEqual(0.15);
      expect(seen && toWindow(seen, [9_000, 0])).toEqual([expect.closeTo(35), 35]);
    });
  });

  test("what is fitted is seen whole", () => {
    const rect: Rect = [-500, 300, 4000, 90];
    const all = fitted(rect, [800, 600]);
    const [a, b] = [toWindow(all, [-500, 300]), toWindow(all, [3500, 390])];
    expect(Math.min(...a, ...b)).toBeGreaterThanOrEqual(0);
    expect(b[0]).toBeLessThanOrEqual(800);
  });
});

describe("search", () => {
  const first = (query: string) => search(CATALOGUE, query)[0]?.entry.name;
  test.each([["addition", "Addition"], ["addi", "Addition"], ["cp", "Construct Point"], ["divide", "Divide Curve"], ["dvcrv", "Divide Curve"], ["xyz", "Construct Point"], ["slider", "Number Slider"], ["CIRC", "Circle"], ["point construct", "Construct Point"]])(
    "%s finds %s",
    (query, name) => expect(first(query)).toBe(name),
  );
  test("of a component and a parameter that are named alike the component is meant", () => {
    const parameter = { ...(CATALOGUE.find((entry) => entry.name === "Circle") ?? CATALOGUE[0]), floating: true, tab: "Params", guid: "a" };
    const two = [parameter, { ...parameter, floating: false, tab: "Curve", guid: "b" }] as typeof CATALOGUE;
    expect(search(two, "circ").map(({ entry }) => entry.guid)).toEqual(["b", "a"]);
  });
  test("nonsense finds nothing", () => expect(first("qqqq")).toBeUndefined());
  test("a wire finds only what takes it", () => {
    const names = search(CATALOGUE, "", { side: "input", kind: "Curve" }, 99).map(({ entry }) => entry.name);
    expect(names).toContain("Loft");
    expect(names).not.toContain("Number Slider");
  });
  test("the tabs are in Grasshopper's order", () => {
    expect(tabs(CATALOGUE).map(({ name }) => name)).toEqual(["Params", "Maths", "Sets", "Vector", "Curve", "Surface", "Transform"]);
  });
  test("types fit by what is cast", () => {
    expect([fit("Circle", "Curve"), fit("Number", "Integer"), fit("Brep", "Number"), fit("Mesh", "Geometry")]).toEqual([1, 1, 0, 2]);
  });
});

describe("selection", () => {
  const rects: [string, Rect][] = [["a", [0, 0, 10, 10]], ["b", [20, 0, 10, 10]]];
  test("windows", () => {
    expect(windowed([-1, -1, 25, 20], false, rects)).toEqual(["a"]);
    expect(windowed([-1, -1, 25, 20], true, rects)).toEqual(["a", "b"]);
  });
  test("picks", () => {
    expect([...picked(new Set(["a"]), ["b"], "add")]).toEqual(["a", "b"]);
    expect([...picked(new Set(["a", "b"]), ["b"], "remove")]).toEqual(["a"]);
    expect([...picked(new Set(["a"]), ["b"], "replace")]).toEqual(["b"]);
  });
  test("grows along wires", () => {
    const wires = [{ from: "a", to: "b" }, { from: "b", to: "c" }];
    expect([...grownAlong(new Set(["b"]), wires, "up")].sort()).toEqual(["a", "b"]);
    expect([...grownAlong(new Set(["b"]), wires, "down")].sort()).toEqual(["b", "c"]);
  });
});

describe("the keyboard's way", () => {
  const all: [string, Rect][] = [["c", [200, 0, 50, 20]], ["b", [10, 100, 50, 20]], ["a", [0, 0, 50, 20]], ["d", [210, 90, 50, 20]]];
  test("goes from left to right in bands from top to bottom", () => expect(readingOrder(all)).toEqual(["a", "b", "c", "d"]));
  test("takes everything once", () => expect(readingOrder([...all, ...all.map(([id, r]) => [`${id}2`, r] as [string, Rect])])).toHaveLength(8));
  test("finds neighbours", () => {
    const go = (direction: "left" | "right" | "up" | "down") => neighbour([0, 0, 50, 20], all, direction);
    expect([go("right"), go("down"), go("left"), go("up")]).toEqual(["c", "b", undefined, undefined]);
  });
});

test("dragged things line up with what is near, and with nothing far", () => {
  const found = snap([0, 0, 50, 20], [103, 47], [[105, 200, 50, 20]], 5);
  expect(found.by).toEqual([105, 47]);
  expect(found.guides).toEqual([{ axis: "x", at: 105, from: 47, to: 220 }]);
  expect(snap([0, 0, 50, 20], [103, 47], [[105, 2000, 50, 20]], 5).by).toEqual([103, 47]);
});

describe("groups", () => {
  const one = component("One", "One", [0, 0], ["A"], ["R"]);
  const two = component("Two", "Two", [200, 100], ["A"], ["R"]);
  const inner = group("Inner", [one]);
  const outer = group("", [inner, two]);
  const objects = byId([outer, inner, one, two]);
  const rect = (object: ObjectView) => rectOf(object, NO_SHIFTS, false);
  test("frame their members, groups with their labels", () => {
    expect(groupFrame(inner.id, objects, rect)).toEqual([-10, -25, 92, 63]);
    const frame = groupFrame(outer.id, objects, rect);
    expect(frame?.slice(0, 2)).toEqual([-20, -35]);
  });
  test("take along what is in groups in them", () => expect([...leaves([outer.id], objects)].sort()).toEqual([one.id, two.id].sort()));
  test("in groups are drawn later", () => {
    const depth = depths(objects);
    expect(depth.get(inner.id)).toBeGreaterThan(depth.get(outer.id) ?? 9);
  });
  test("that hold each other come to an end", () => {
    const [a, b] = [group("A", []), group("B", [])];
    if (a.control?.is === "group") a.control.members = [b.id];
    if (b.control?.is === "group") b.control.members = [a.id, a.id, b.id];
    const ring = byId([a, b]);
    expect(groupFrame(a.id, ring, rect)).toBeUndefined();
    expect([...leaves([a.id], ring)]).toEqual([]);
    expect(depths(ring).size).toBe(2);
  });
  test("as blobs go around all corners", () => {
    const ring = hull([[0, 0], [10, 0], [10, 10], [0, 10], [5, 5], [5, 0]]);
    expect(ring).toHaveLength(4);
    expect(blobPath([[0, 0, 10, 10]], [0, 0], 5)).toBe("M-5,0 A5,5 0 0 1 0,-5 L10,-5 A5,5 0 0 1 15,0 L15,10 A5,5 0 0 1 10,15 L0,15 A5,5 0 0 1 -5,10 Z");
    expect(blobPath([], [0, 0])).toBe("");
  });
});

describe("capsules", () => {
  const one = component("Construct Point", "Pt", [0, 0], ["X coordinate", "Y"], ["Point"]);
  test("have a band between the names", () => {
    const { band, tornLeft, tornRight } = capsuleLayout(one, 72, false);
    expect(band[0]).toBeGreaterThan(5);
    expect(band[1]).toBeLessThan(72 - 5);
    expect([tornLeft, tornRight]).toEqual([false, false]);
  });
  test("grow for full names", () => {
    expect(growth(one, false)).toEqual([0, 0]);
    const [left, right] = growth(one, true);
    expect(left).toBeGreaterThan(right);
    expect(rectOf(one, NO_SHIFTS, true)[2]).toBe(72 + left + right);
  });
  test("are torn where there is no port", () => {
    expect(capsuleLayout(component("XY", "XY", [0, 0], [], ["P"]), 72, false).tornLeft).toBe(true);
    expect(tornPath(50, 40, true, false)).toMatch(/^M0,0 .* Z$/);
    expect(tornPath(50, 40, true, true)).not.toContain("NaN");
  });
  test("show the worst state", () => {
    const result = resultsOf([one])[0];
    expect(lookOf(one, result && { ...result, status: "error" })).toBe("error");
    expect(lookOf({ ...one, disabled: true }, result && { ...result, status: "error" })).toBe("disabled");
    expect(lookOf({ ...one, hidden: true }, undefined)).toBe("hidden");
    expect(lookOf({ ...one, hidden: true }, result && { ...result, status: "warning" })).toBe("warning");
  });
  test("are empty when nothing comes over a wire, also where the input could do without", () => {
    const source = component("Source", "Source", [0, 0], [], ["R"]);
    const move = component("Move", "Move", [200, 0], ["G", "T"], ["G"]);
    wire(source, 0, move, 0);
    const output = { port: source.outputs[0]?.id ?? "", structure: "empty" as const, branches: 0, items: 0 };
    const data = new Map([[output.port, output]]) as unknown as Parameters<typeof isStarved>[1];
    const result = resultsOf([move])[0];
    expect(isStarved(move, data)).toBe(true);
    expect(lookOf(move, result, isStarved(move, data))).toBe("empty");
    expect(lookOf(move, result && { ...result, status: "error" }, true)).toBe("error");
    // Before a solve nothing is known.
    expect(lookOf(move, undefined, true)).toBe("plain");
    expect(isStarved(move, new Map())).toBe(false);
    expect(emptyInputs(move, data)[0]).toBe(move.inputs[0]);
  });
});

describe("places", () => {
  const one = component("One", "One", [0, 0], ["A"], ["R"]);
  const two = component("Two", "Two", [200, 0], ["A", "B"], ["R"]);
  wire(one, 0, two, 1);
  const objects = byId([one, two]);
  const outputs = outputsOf([one, two]);
  test("wires are found with their ends, also while something is dragged", () => {
    expect([...wiresOf(objects, outputs)]).toMatchObject([{ source: one.id, target: two.id }]);
    const shifts = new Map([[two.id, [10, 5] as const]]);
    const [strung] = [...strungOf(objects, outputs, (object) => rectOf(object, shifts, false))];
    expect(strung?.a).toEqual([72, 14]);
    expect(strung?.b).toEqual([210, 38]);
  });
  test("a wire from what is not here is left out", () => {
    expect([...wiresOf(byId([two]), outputsOf([two]))]).toEqual([]);
  });
  test("grips and wires are found by where they are", () => {
    const grips = [one, two].flatMap((object) => gripsOf(object, rectOf(object, NO_SHIFTS, false)));
    expect(gripAt([74, 15], grips, 14)?.port).toBe(one.outputs[0]?.id);
    expect(gripAt([120, 15], grips, 14)).toBeUndefined();
    const strung = [...strungOf(objects, outputs, (object) => rectOf(object, NO_SHIFTS, false))];
    expect(wireAt([136, 23], strung, 6)?.to).toBe(two.inputs[1]?.id);
    expect(wireAt([136, 60], strung, 6)).toBeUndefined();
    expect(topmost([5, 5], [["a", [0, 0, 10, 10]], ["b", [0, 0, 10, 10]]])).toBe("b");
  });
});

test("the far view has a box for every object and a wire for every wire", () => {
  const { objects: list } = sampleState();
  const results = new Map(resultsOf(list).map((result) => [result.id, result]));
  const data = new Map([...results.values()].flatMap((result) => result.outputs.map((output) => [output.port, output] as const)));
  const objects = byId(list);
  const outputs = outputsOf(list);
  const order = list.map((one) => one.id);
  const far = farList({ objects, order, outputs, results, data, selection: new Set(), shifts: NO_SHIFTS, full: false });
  expect(far.groups.length + far.boxes.length).toBe(list.length);
  expect(far.wires).toHaveLength([...wiresOf(objects, outputs)].length);
  const icon = (name: string) => far.boxes.find((box) => objects.get(box.id)?.name === name)?.icon;
  expect(icon("Point")).toMatchObject({ name: "Point", forName: true });
  expect(icon("Number Slider")).toMatchObject({ forName: false });
  expect(stateOf(list).objects).toBe(list);
});

describe("small arithmetic", () => {
  test("numbers and times", () => {
    expect([0, 1 / 3, 1e20, -2.5, Number.NaN].map(numberText)).toEqual(["0", "0.333333", "1e+20", "-2.5", "NaN"]);
    expect([0.01, 0.5, 3.14159, 250.4, 61000].map(timeText)).toEqual(["<0.1 ms", "0.5 ms", "3.1 ms", "250 ms", "1 min 1 s"]);
    expect(digitsText(-12.5, 6, 3)).toBe("−012.500");
  });
  test("texts are cut and wrapped to their room", () => {
    expect(textWidth(cut("a long name", 10, 30), 10)).toBeLessThanOrEqual(30);
    expect(cut("ab", 10, 100)).toBe("ab");
    expect(wrapped("one two three", 10, 45).length).toBeGreaterThan(1);
  });
  test("colours", () => {
    expect(hex(fromHex("#12aBff", 7))).toBe("#12abff");
    expect(fromHex("nonsense")).toEqual([0, 0, 0, 255]);
    expect([inkOn([255, 250, 90, 255]), inkOn([20, 20, 20, 255])]).toEqual(["dark", "light"]);
    expect(gradientCss([{ at: 0.5, left: [0, 0, 0, 255], right: [255, 0, 0, 255] }])).toBe("linear-gradient(90deg, rgb(0 0 0 / 1) 50%, rgb(255 0 0 / 1) 50%)");
  });
  test("handles of graphs keep to their square, ends to its edge", () => {
    const bezier: GraphView = { name: "Bezier", handles: [[0, 0], [0.35, 0], [0.65, 1], [1, 1]] };
    expect(draggable(bezier)).toEqual([0, 1, 2, 3]);
    expect(draggable({ name: "Power", handles: [[0.5, 0.25], [2, 0]] })).toEqual([0]);
    expect(withHandle({ name: "Gaussian", handles: [[0.5, 1], [0.7, 0.5]] }, 0, [0.3, 0.8]).handles[1]?.[0]).toBeCloseTo(0.5);
    expect(withHandle(bezier, 0, [0.7, 2]).handles[0]).toEqual([0, 1]);
    expect(withHandle(bezier, 1, [0.7, 0.2]).handles[1]).toEqual([0.7, 0.2]);
  });
  test("wheels zoom and trackpads pan; in the other scheme wheels pan", () => {
    const wheel = { deltaX: 0, deltaY: -120, deltaMode: 0, ctrlKey: false, metaKey: false, shiftKey: false, wheelDeltaY: 120 };
    expect(wheelMeans(wheel, "grasshopper").is).toBe("zoom");
    expect(wheelMeans({ ...wheel, deltaX: 3, deltaY: 7, wheelDeltaY: -21 }, "grasshopper")).toEqual({ is: "pan", by: [-3, -7] });
    expect(wheelMeans(wheel, "figma").is).toBe("pan");
    expect(wheelMeans({ ...wheel, ctrlKey: true }, "figma").is).toBe("zoom");
  });
});

test("of many values the newest is sent, one at a time", async () => {
  const sent: number[] = [];
  let under = 0;
  const line = latest<number>(async (value) => {
    expect(++under).toBe(1);
    await new Promise((resolve) => setTimeout(resolve, 2));
    sent.push(value);
    under--;
    if (value === 0) throw new Error("refused");
  });
  for (let k = 0; k < 50; k++) line.send(k);
  await line.settled();
  expect(sent).toEqual([0, 49]);
  line.send(7);
  await line.settled();
  expect(sent).toEqual([0, 49, 7]);
});

test("objects are found by their names and by what is written on them", () => {
  const { objects } = sampleState();
  const names = (query: string) => found(objects, query).map((one) => one.name);
  expect(names("this is a panel")).toEqual(["Panel"]);
  expect(names("inputs")).toEqual(["Group"]);
  expect(names("  DIVIDE ")).toEqual(["Divide Curve"]);
  expect(names("")).toEqual([]);
});

test("an object is found by its id, or the first eight signs of it", () => {
  const objects = [...sampleState().objects];
  const [first] = objects;
  const withId = { ...first!, id: "deadbeef-0000-4000-8000-000000000001" };
  expect(found([...objects, withId], "DEADBEEF")).toEqual([withId]);
  expect(found([...objects, withId], withId.id)).toEqual([withId]);
  expect(found([withId], "dead")).toEqual([]);
});
