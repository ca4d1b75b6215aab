import { describe, expect, test } from "vitest";

import { curveBounds, curvePoint, reach, wireCurve, wireDistance, wireLook, wireMeets, wirePath } from "../../src/core/wires";
import type { Point } from "../../src/core/geometry";
import { inside } from "../../src/core/geometry";

const ENDS: [Point, Point][] = [
  [[0, 0], [100, 0]],
  [[0, 0], [100, 300]],
  [[0, 0], [-200, 40]],
  [[0, 0], [0, 0]],
  [[5, 5], [6, -700]],
];

describe("curves", () => {
  test.each(ENDS)("from %j to %j leave to the right and come in from the left", (a, b) => {
    const curve = wireCurve(a, b);
    expect(reach(a, b)).toBeGreaterThanOrEqual(8);
    expect(curve[1][1]).toBe(a[1]);
    expect(curve[2][1]).toBe(b[1]);
    expect(curve[1][0]).toBeGreaterThan(a[0]);
    expect(curve[2][0]).toBeLessThan(b[0]);
    expect(curvePoint(curve, 0)).toEqual(a);
    expect(curvePoint(curve, 1)).toEqual(b);
  });

  test.each(ENDS)("from %j to %j lie in their bounds, and the distance of their points is small", (a, b) => {
    const curve = wireCurve(a, b);
    const bounds = curveBounds(curve);
    for (let k = 0; k <= 20; k++) {
      const [x, y] = curvePoint(curve, k / 20);
      expect(inside([x, y, 0, 0], [bounds[0] - 1e-9, bounds[1] - 1e-9, bounds[2] + 2e-9, bounds[3] + 2e-9])).toBe(true);
      expect(wireDistance([x, y], a, b)).toBeLessThan(1);
      expect(wireMeets([x - 1, y - 1, 2, 2], a, b)).toBe(true);
    }
  });

  test("a level wire is a straight line", () => {
    expect(wirePath([0, 0], [100, 0])).toBe("M0,0 C50,0 50,0 100,0");
    expect(wireDistance([50, 7], [0, 0], [100, 0])).toBeCloseTo(7, 6);
    expect(wireMeets([0, 20, 10, 10], [0, 0], [100, 0])).toBe(false);
  });
});

describe("looks", () => {
  test("one line for an item, two for a list, two broken ones for a tree, orange for nothing", () => {
    expect(wireLook("item", "normal", false)).toMatchObject({ gap: 0, dashed: false, colour: "plain" });
    expect(wireLook("list", "normal", false)).toMatchObject({ gap: 2, dashed: false });
    expect(wireLook("tree", "normal", false)).toMatchObject({ gap: 2, dashed: true });
    expect(wireLook("empty", "normal", false)).toMatchObject({ gap: 0, colour: "empty" });
    expect(wireLook(undefined, "normal", false).colour).toBe("empty");
  });

  test("a hidden wire is drawn while an end of it is selected", () => {
    expect(wireLook("item", "hidden", false).wireless).toBe(true);
    expect(wireLook("item", "hidden", true)).toMatchObject({ wireless: false, colour: "selected" });
    expect(wireLook("item", "faint", false).opacity).toBeLessThan(1);
    expect(wireLook("item", "faint", true).opacity).toBe(1);
  });
});
