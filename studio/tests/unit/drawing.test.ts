import { describe, expect, test } from "vitest";

import { typedPoint } from "../../src/core/coordinates";
import { drawingOf, lastPoint, outline, toolsFor } from "../../src/core/drawing";
import { coordinatesIn, distance, FRAMES, pointAt } from "../../src/core/frame";
import type { Point3, Preview, PreviewPart } from "../../src/core/preview";
import { chainOf, onGrid, snapTo } from "../../src/viewport/tools/snaps";
import type { Pick } from "../../src/viewport/tools/picking";

const { xy, xz, yz } = FRAMES;

describe("construction planes", () => {
  test("have the axes that Rhino gives them", () => {
    for (const { x, y, z } of [xy, xz, yz]) {
      const cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
      expect(cross.map((value) => value + 0)).toEqual(z.map((value) => value + 0));
    }
    expect(pointAt(xz, [3, 4, 5])).toEqual([3, -5, 4]);
    expect(coordinatesIn(xz, [3, -5, 4])).toEqual([3, 4, 5]);
  });
});

describe("typed coordinates", () => {
  const typing = { frame: xy, last: [10, 20, 30] as Point3, towards: [13, 24, 30] as Point3 };
  test.each([
    ["3,4", [3, 4, 0]],
    [" 3 , 4 , 5 ", [3, 4, 5]],
    ["1/2, 2*3", [0.5, 6, 0]],
    ["r1,2", [11, 22, 30]],
    ["@1,2,3", [11, 22, 33]],
    // Three along, four up: five towards the pointer.
    ["5", [13, 24, 30]],
    ["10", [16, 28, 30]],
  ] as const)("%s", (text, point) => {
    expect(typedPoint(text, typing)).toEqual(point);
  });

  test("are on the construction plane, and with w in the world", () => {
    const front = { ...typing, frame: xz };
    expect(typedPoint("3,4", front)?.map((value) => value + 0)).toEqual([3, 0, 4]);
    expect(typedPoint("w3,4,5", front)).toEqual([3, 4, 5]);
  });

  test("may be a distance and an angle", () => {
    const [x, y, z] = typedPoint("2<90", typing) ?? [];
    expect(x).toBeCloseTo(10, 12);
    expect([y, z]).toEqual([22, 30]);
    const [u, v] = typedPoint("2<180", { ...typing, last: undefined }) ?? [];
    expect(u).toBe(-2);
    expect(v).toBeCloseTo(0, 12);
  });

  test.each(["", "a", "1,", "1,2,3,4", "1,nonsense", "w5", "r5", "1<2<3", "1/0,2"])("%s is none", (text) => {
    expect(typedPoint(text, typing)).toBeUndefined();
  });

  test("from a point before need one", () => {
    expect(typedPoint("r1,1", { frame: xy, last: undefined, towards: undefined })).toBeUndefined();
    expect(typedPoint("5", { ...typing, towards: typing.last })).toBeUndefined();
  });
});

describe("drawings", () => {
  const [a, b, c]: [Point3, Point3, Point3] = [[0, 0, 0], [3, 4, 0], [3, 0, 0]];

  test("need as many points as they need", () => {
    expect((["point", "line", "circle", "rectangle", "polyline", "interpolated"] as const).map(lastPoint)).toEqual([1, 2, 2, 2, Infinity, Infinity]);
    expect(drawingOf("line", [a], xy)).toBeUndefined();
    expect(drawingOf("line", [a, a], xy)).toBeUndefined();
    expect(drawingOf("circle", [a, [0, 0, 7]], xy)).toBeUndefined();
    expect(drawingOf("rectangle", [a, c], xy)).toBeUndefined();
  });

  test("are what their points say", () => {
    const plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };
    expect(drawingOf("circle", [a, b], xy)).toEqual({ is: "circle", plane, radius: 5 });
    expect(drawingOf("rectangle", [a, [-2, 4, 0]], xy)).toEqual({ is: "rectangle", plane, size: [-2, 4] });
    expect(drawingOf("polyline", [a, b, c], xy, true)).toEqual({ is: "polyline", points: [a, b, c, a] });
    expect(drawingOf("polyline", [a, b], xy, true)).toEqual({ is: "polyline", points: [a, b] });
    expect(drawingOf("interpolated", [a, b, c], xy, true)).toEqual({ is: "interpolated", points: [a, b, c], closed: true });
  });

  test("of planes and vectors keep directions", () => {
    expect(drawingOf("vector", [c, b], xy)).toEqual({ is: "vector", along: [0, 4, 0] });
    expect(drawingOf("vector", [b, b], xy)).toBeUndefined();
    expect(drawingOf("plane", [c, b], xy)).toEqual({ is: "plane", plane: { origin: [3, 0, 0], x: [0, 4, 0], y: [-4, 0, 0] } });
    // On the front plane y is up where x is to the right.
    const front = JSON.stringify(drawingOf("plane", [a, c], xz));
    expect(JSON.parse(front)).toMatchObject({ plane: { x: [3, 0, 0], y: [0, 0, 3] } });
    expect(drawingOf("plane", [a, [0, 0, 4]], xy)).toBeUndefined();
    expect([toolsFor("Plane"), toolsFor("Vector"), lastPoint("plane")]).toEqual([["plane"], ["vector"], 2]);
  });

  test("lie in the plane of the view", () => {
    expect(drawingOf("rectangle", [a, [2, 9, 5]], xz)).toMatchObject({ size: [2, 5] });
    for (const point of outline("circle", [[1, 2, 3], [4, 2, 7]], xz)) {
      expect(distance(point, [1, 2, 3])).toBeCloseTo(5, 12);
      expect(point[1]).toBe(2);
    }
  });

  test("that are interpolated pass through their points", () => {
    const line = outline("interpolated", [a, b, c], xy);
    for (const point of [a, b, c]) expect(Math.min(...line.map((each) => distance(each, point)))).toBeLessThan(1e-12);
    // Points on a line give that line.
    const straight = outline("interpolated", [[0, 0, 0], [1, 1, 0], [5, 5, 0]], xy);
    for (const [x, y] of straight) expect(x).toBeCloseTo(y, 12);
  });

  test("are those of the input's type", () => {
    expect(toolsFor("Point")).toEqual(["point"]);
    expect(toolsFor("Curve")).not.toContain("point");
    expect(toolsFor("Mesh")).toEqual([]);
  });
});

describe("snaps", () => {
  const origin: Point3 = [100, 0, 0];
  /** Two items: a bent line of lengths 4 and 2, and a straight one. */
  const part = {
    kind: "curves",
    positions: Float32Array.from([0, 0, 0, 4, 0, 0, 4, 0, 0, 4, 2, 0, 9, 9, 0, 9, 8, 0]),
    indices: null,
    pieces: [{ output: 0, path: "{0}", index: 0, start: 0, count: 4 }, { output: 0, path: "{0}", index: 1, start: 4, count: 2 }],
  } as unknown as PreviewPart;
  const preview = { origin } as Preview;
  const pick = (point: Point3, at: number): Pick => ({ object: "o", part, piece: part.pieces[at], point });
  const all = { end: true, mid: true, near: true };
  const far = (from: Point3) => (point: Point3) => distance(from, point) * 10;

  test("find the points of the item that was hit", () => {
    expect(chainOf(pick([101, 0, 0], 0), preview)).toEqual([[100, 0, 0], [104, 0, 0], [104, 2, 0]]);
    expect(chainOf(pick([109, 8.5, 0], 1), preview)).toEqual([[109, 9, 0], [109, 8, 0]]);
  });

  test("go to the end, the middle by length, or where it is nearest", () => {
    const to = (point: Point3, on = all) => snapTo(pick(point, 0), preview, on, far(point));
    expect(to([100.5, 0, 0])).toEqual({ name: "end", point: [100, 0, 0] });
    expect(to([104, 1.9, 0])).toEqual({ name: "end", point: [104, 2, 0] });
    expect(to([103.2, 0, 0])).toEqual({ name: "mid", point: [103, 0, 0] });
    expect(to([101.6, 0, 0])).toEqual({ name: "near", point: [101.6, 0, 0] });
    expect(to([100.5, 0, 0], { ...all, end: false })).toEqual({ name: "near", point: [100.5, 0, 0] });
    expect(to([101.6, 0, 0], { ...all, near: false })).toBeUndefined();
  });

  test("go to the grid of the plane", () => {
    expect(onGrid([1.26, 7, 2.71], xz, 0.01)).toEqual({ name: "grid", point: [1.3, 7, 2.7] });
  });
});
