import { describe, expect, test } from "vitest";

import { angleOf, middleOf, sectorAt, sectorPath, stepped, type Ring } from "../../src/core/radial";

const ring: Ring = { count: 8, inner: 30, outer: 100 };

describe("the ring of commands", () => {
  test("begins at the top and goes with the clock", () => {
    expect(sectorAt(ring, [0, -60])).toBe(0);
    expect(sectorAt(ring, [60, -60])).toBe(1);
    expect(sectorAt(ring, [60, 0])).toBe(2);
    expect(sectorAt(ring, [0, 60])).toBe(4);
    expect(sectorAt(ring, [-60, 0])).toBe(6);
    expect(sectorAt(ring, [-2, -60])).toBe(0);
  });

  test("has a hole, and no outer end", () => {
    expect(sectorAt(ring, [0, -10])).toBeUndefined();
    expect(sectorAt(ring, [0, -1000])).toBe(0);
    expect(sectorAt({ ...ring, count: 0 }, [0, -60])).toBeUndefined();
  });

  test("the middle of each sector is in that sector, however many there are", () => {
    for (const count of [1, 2, 3, 5, 8, 12]) {
      for (let index = 0; index < count; index++) expect(sectorAt({ ...ring, count }, middleOf({ ...ring, count }, index))).toBe(index);
    }
    expect(angleOf({ count: 4 }, 1)).toBeCloseTo(Math.PI / 2);
  });

  test("outlines hold no numbers that are none", () => {
    for (const count of [1, 2, 8, 100]) expect(sectorPath({ ...ring, count }, 0)).toMatch(/^M[-\d.,LAZ ]+$/);
  });

  test("keys go round it", () => {
    expect(stepped(3, undefined, 1)).toBe(0);
    expect(stepped(3, undefined, -1)).toBe(2);
    expect(stepped(3, 2, 1)).toBe(0);
    expect(stepped(3, 0, -1)).toBe(2);
    expect(stepped(0, undefined, 1)).toBeUndefined();
  });
});
