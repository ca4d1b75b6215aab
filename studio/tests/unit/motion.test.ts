import { describe, expect, it } from "vitest";

import { arrowLines } from "../../src/core/motion";
import { slopeText } from "../../src/panels/Effects";
import { placesOf } from "../../src/viewport/tools/heldPoints";

describe("arrows", () => {
  it("have the scale of the fastest, with a head", () => {
    const lines = arrowLines([{ at: [1, 0, 0], by: [2, 0, 0] }, { at: [0, 1, 0], by: [0, 1, 0] }], 100, [0, 0, 0]);
    // Three lines each: a shaft and two halves of a head.
    expect(lines.length).toBe(2 * 3 * 6);
    expect(lines.slice(0, 6)).toEqual([1, 0, 0, 13, 0, 0]);
    expect(lines.slice(18, 24)).toEqual([0, 1, 0, 0, 7, 0]);
    // The head ends at the tip, and begins a quarter before it.
    expect(lines.slice(6, 12)).toEqual([10, -1.5, 0, 13, 0, 0]);
  });

  it("are none where nothing moves, and those that hardly move are left out", () => {
    expect(arrowLines([{ at: [0, 0, 0], by: [0, 0, 0] }], 1, [0, 0, 0])).toEqual([]);
    const two = arrowLines([{ at: [0, 0, 0], by: [0, 0, 1] }, { at: [0, 0, 0], by: [0, 0, 1e-6] }], 1, [0, 0, 0]);
    expect(two.length).toBe(18);
    expect(two.every(Number.isFinite)).toBe(true);
  });
});

it("items are named by their branch and place", () => {
  expect(placesOf([
    { is: "path", path: "{0;1}", items: 1 }, { is: "item", index: 0, text: "a" },
    { is: "path", path: "{0;2}", items: 2 }, { is: "item", index: 0, text: "b" }, { is: "item", index: 1, text: "c" },
  ])).toEqual([undefined, { path: "{0;1}", index: 0 }, undefined, { path: "{0;2}", index: 0 }, { path: "{0;2}", index: 1 }]);
});

it("slopes are told in words", () => {
  expect(slopeText({ is: "even", by: { value: 36.0000001, error: 1e-9 } })).toBe("36 ± 1e-9");
  expect(slopeText({ is: "corner", left: { value: -1, error: 0 }, right: null })).toBe("-1 ± 0 to the left, – to the right");
  expect(slopeText({ is: "steps", step: 1, down: null, up: 2.5 })).toBe("– for a step down, 2.5 for a step up");
  expect(slopeText({ is: "jump" })).toBe("jumps here");
});
