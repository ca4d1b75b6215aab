import { expect, test } from "vitest";

import { fadeAt } from "../../src/core/density";

test("lines that are far apart are drawn whole, dense ones fade, and never vanish", () => {
  // A ball of radius 10 with four circles around it, 20 pixels a unit: they cover little of the disc.
  expect(fadeAt(4 * 2 * Math.PI * 10, 10, 20)).toBe(1);
  // The same seen from far away: half a pixel a unit.
  const far = fadeAt(4 * 2 * Math.PI * 10, 10, 0.5);
  expect(far).toBeLessThan(0.7);
  expect(fadeAt(1e9, 10, 1)).toBe(0.18);
  // Twice as near or half as many lines are as dense as each other.
  expect(fadeAt(20_000, 10, 4)).toBeCloseTo(fadeAt(10_000, 10, 2), 12);
  expect(fadeAt(0, 10, 1)).toBe(1);
  expect(fadeAt(5, 0, 1)).toBe(1);
  expect(fadeAt(Number.NaN, 1, 1)).toBe(1);
});
