import { describe, expect, test } from "vitest";

import { angleAbout, GRIPS, imageOf, mapOf, moving, scaling, turning } from "../../src/core/gumball";
import type { Point3 } from "../../src/core/preview";

const near = (point: Point3, expected: Point3) => point.forEach((value, axis) => expect(value).toBeCloseTo(expected[axis] ?? NaN, 12));

describe("maps of the gumball", () => {
  test("a quarter turn goes from x to y, from y to z, from z to x", () => {
    const [x, y, z]: Point3[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    near(imageOf(turning([0, 0, 0], 2, Math.PI / 2), x!), y!);
    near(imageOf(turning([0, 0, 0], 0, Math.PI / 2), y!), z!);
    near(imageOf(turning([0, 0, 0], 1, Math.PI / 2), z!), x!);
  });

  test("a turn and a scale leave their middle where it is", () => {
    const middle: Point3 = [3, -4, 5];
    near(imageOf(turning(middle, 1, 0.7), middle), middle);
    near(imageOf(scaling(middle, [2, 3, 0.5]), middle), middle);
    near(imageOf(scaling(middle, [2, 3, 0.5]), [4, -3, 7]), [5, -1, 6]);
    near(imageOf(turning(middle, 2, Math.PI), [5, -4, 9]), [1, -4, 9]);
  });

  test("angles are counted against the axis, whatever the height of the points", () => {
    expect(angleAbout([1, 1, 1], 2, [3, 1, 9], [1, 5, -2])).toBeCloseTo(Math.PI / 2, 12);
    expect(angleAbout([1, 1, 1], 2, [3, 1, 9], [1, -5, -2])).toBeCloseTo(-Math.PI / 2, 12);
    expect(angleAbout([0, 0, 0], 0, [7, 1, 0], [0, 0, 2])).toBeCloseTo(Math.PI / 2, 12);
  });

  test("amounts are lengths, degrees and factors", () => {
    const middle: Point3 = [1, 0, 0];
    near(imageOf(mapOf({ does: "move", axis: 2 }, middle, 4), [1, 2, 3]), [1, 2, 7]);
    near(imageOf(mapOf({ does: "turn", axis: 2 }, middle, 90), [2, 0, 0]), [1, 1, 0]);
    near(imageOf(mapOf({ does: "scale", axis: 0 }, middle, 3), [2, 2, 2]), [4, 2, 2]);
    near(imageOf(mapOf({ does: "scale", axis: 0 }, middle, 3, true), [2, 2, 2]), [4, 6, 6]);
    near(imageOf(moving([1, 2, 3]), [1, 1, 1]), [2, 3, 4]);
  });

  test("each axis has three grips, and one is free", () => {
    expect(GRIPS).toHaveLength(10);
  });
});
