import { describe, expect, test } from "vitest";

import { pathNumbers, treePicture } from "../../src/core/treePicture";

const paths = (...texts: string[]) => texts.map(pathNumbers);

describe("the picture of a tree", () => {
  test("reads paths", () => {
    expect(pathNumbers("{0;12;-3}")).toEqual([0, 12, -3]);
    expect(pathNumbers("{}")).toEqual([]);
  });

  test("has an end a branch, within the radius, and a twig to each", () => {
    const { twigs, leaves } = treePicture(paths("{0;0}", "{0;1}", "{0;2}", "{0;3}"), 100);
    expect(leaves).toHaveLength(4);
    expect(twigs).toHaveLength(4);
    for (const [x, y] of leaves) expect(Math.hypot(x, y)).toBeCloseTo(100);
    for (const { from } of twigs) expect(from).toEqual([0, 0]);
  });

  test("forks where paths do", () => {
    const { twigs, leaves } = treePicture(paths("{0;0;0}", "{0;0;1}", "{0;1;0}", "{0;1;1}"), 100);
    expect(leaves).toHaveLength(4);
    expect(twigs).toHaveLength(6);
    expect(twigs.filter(({ from }) => Math.hypot(...from) < 1e-9)).toHaveLength(2);
  });

  test("of one branch, of none, and of branches of different lengths is sound", () => {
    expect(treePicture(paths("{0;0;0}"), 10)).toEqual({ twigs: [], leaves: [[0, 0]] });
    expect(treePicture([], 10)).toEqual({ twigs: [], leaves: [] });
    const mixed = treePicture(paths("{0}", "{0;0}", "{0;1;4}"), 10);
    expect(mixed.leaves).toHaveLength(3);
    for (const point of [...mixed.leaves, ...mixed.twigs.flatMap(({ from, to }) => [from, to])]) {
      expect(point.every(Number.isFinite)).toBe(true);
      expect(Math.hypot(...point)).toBeLessThanOrEqual(10 + 1e-9);
    }
  });
});
