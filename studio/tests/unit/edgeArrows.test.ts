import { describe, expect, test } from "vitest";

import { edgeArrows } from "../../src/core/edgeArrows";
import type { Rect } from "../../src/core/geometry";

const lens = { x: 0, y: 0, zoom: 1 };
const size = [800, 600] as const;
const at = (x: number, y: number): Rect => [x - 5, y - 5, 10, 10];

describe("arrows at the edge", () => {
  test("point to what is out of sight, and to nothing else", () => {
    const arrows = edgeArrows([["seen", at(400, 300)], ["right", at(2000, 300)], ["above", at(400, -900)]], lens, size);
    expect(arrows.map(({ id }) => id)).toEqual(["right", "above"]);
    expect(arrows[0]?.turn).toBe(0);
    expect(arrows[1]?.turn).toBe(-90);
    for (const { at: [x, y] } of arrows) {
      expect(x).toBeGreaterThan(0);
      expect(x).toBeLessThan(800);
      expect(y).toBeGreaterThan(0);
      expect(y).toBeLessThan(600);
    }
  });

  test("that would cover each other are one that counts them", () => {
    const far = [2000, 2005, 2010].map((x, k): [string, Rect] => [String(k), at(x, 300)]);
    expect(edgeArrows(far, lens, size)).toMatchObject([{ count: 3 }]);
  });

  test("follow the lens", () => {
    expect(edgeArrows([["a", at(2000, 300)]], { x: 0, y: 0, zoom: 0.25 }, size)).toEqual([]);
  });
});
