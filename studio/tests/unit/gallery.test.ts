import { expect, test } from "vitest";

import { gridFor } from "../../src/core/gallery";

test("frames are about square, and there is one for each", () => {
  expect(gridFor(1, [200, 100])).toEqual([1, 1]);
  expect(gridFor(2, [200, 100])).toEqual([2, 1]);
  expect(gridFor(2, [100, 200])).toEqual([1, 2]);
  expect(gridFor(9, [100, 100])).toEqual([3, 3]);
  expect(gridFor(0, [100, 100])).toEqual([1, 1]);
  for (let count = 1; count < 40; count++) {
    const [columns, rows] = gridFor(count, [260, 180]);
    expect(columns * rows).toBeGreaterThanOrEqual(count);
    expect(columns * (rows - 1)).toBeLessThan(count);
  }
});
