import { describe, expect, test } from "vitest";

import { type History, barChart, branchesOf, lineOf, numbersOf, partsOf, remember, slicesOf, told } from "../../src/core/charts";
import type { Row } from "../../src/core/protocol/Row";

const row = (text: string): Row => ({ is: "item", index: 0, text });
const path = (name: string): Row => ({ is: "path", path: name, items: 1 });

describe("data", () => {
  test("is taken apart by branches, and only numbers are numbers", () => {
    const rows = [path("{0}"), row("1.5"), row("null"), path("{1}"), path("{2}"), row("-2"), row("1e3"), row("")];
    expect(branchesOf(rows)).toEqual([["1.5", "null"], [], ["-2", "1e3", ""]]);
    expect(numbersOf(["1.5", "null", "-2", "1e3", "", "Infinity", "{1, 2, 3}"])).toEqual([1.5, -2, 1000]);
    expect(branchesOf([row("7")])).toEqual([["7"]]);
  });

  test("is told in words, and how much there is of it", () => {
    expect(told(["1", "2"])).toBe("1, 2");
    expect(told(Array.from({ length: 30 }, (_, k) => String(k)))).toMatch(/^0, 1, .*19, … \(30\)$/);
  });
});

describe("bars", () => {
  test("stand on zero, as high as their numbers, side by side", () => {
    const { bars, zero, labels } = barChart([[10, 5], [-10]], [300, 120]);
    expect(labels).toBe(true);
    // 10 pixels above and below for the values: 100 pixels for a range of 20.
    expect(zero).toBeCloseTo(60);
    expect(bars.map(({ height }) => height)).toEqual([50, 25, 50]);
    expect(bars.map(({ y }) => y)).toEqual([10, 35, 60]);
    expect(bars.map(({ x, width }) => [x, width])).toEqual([
      [0.5, 99],
      [100.5, 99],
      [200.5, 99],
    ]);
    expect(bars.map(({ branch }) => branch)).toEqual([0, 0, 1]);
  });

  test("of no numbers, zeros and very many are sound", () => {
    expect(barChart([], [100, 50]).bars).toEqual([]);
    expect(barChart([[0, 0]], [100, 50]).bars.every(({ height }) => height === 0)).toBe(true);
    const many = barChart([Array.from({ length: 1000 }, () => 1)], [100, 50]);
    expect(many.labels).toBe(false);
    expect(many.bars.reduce((sum, { width }) => sum + width, 0)).toBeCloseTo(100);
  });
});

describe("parts of a whole", () => {
  test("are numbers by size, and all else by how often it is there", () => {
    expect(partsOf(["1", "-3", "0"])).toEqual([
      { name: "1", size: 1 },
      { name: "-3", size: 3 },
    ]);
    expect(partsOf(["oak", "ash", "oak", "2"])).toEqual([
      { name: "oak", size: 2 },
      { name: "ash", size: 1 },
      { name: "2", size: 1 },
    ]);
    const many = partsOf(Array.from({ length: 100 }, () => "1"));
    expect(many).toHaveLength(24);
    expect(many.at(-1)).toEqual({ name: "…", size: 77 });
  });

  test("are slices from the top the way of clocks", () => {
    const slices = slicesOf(partsOf(["1", "1", "2"]), 100);
    expect(slices.map(({ share }) => share)).toEqual([0.25, 0.25, 0.5]);
    expect(slices.map((slice) => slice.path)).toEqual([
      "M0,0L0,-100A100,100 0 0 1 100,0Z",
      "M0,0L100,0A100,100 0 0 1 0,100Z",
      "M0,0L0,100A100,100 0 0 1 0,-100Z",
    ]);
    // In the middle of the third, which is the left half.
    expect(slices[2]?.label?.[0]).toBeCloseTo(-65);
    expect(slicesOf(partsOf(["3", "1"]), 10)[0]?.path).toBe("M0,0L0,-10A10,10 0 1 1 -10,0Z");
  });

  test("one part is a whole circle, and nothing is none", () => {
    expect(slicesOf(partsOf(["5"]), 10)[0]?.path).toBe("M0,-10A10,10 0 0 1 0,10A10,10 0 0 1 0,-10Z");
    expect(slicesOf(partsOf(["0"]), 10)).toEqual([]);
    expect(slicesOf([], 10)).toEqual([]);
  });
});

test("a tracker keeps what each value was", () => {
  const history = remember(remember(remember([], [1, 10]), [2]), [3, 30, 300]);
  expect(history).toEqual([[1, 2, 3], [10, 30], [300]]);
  const long = Array.from({ length: 250 }, (_, k) => k).reduce((history, k) => remember(history, [k]), [] as History);
  expect(long[0]).toHaveLength(200);
  expect(long[0]?.[0]).toBe(50);
});

test("a line goes from the lowest number at the bottom to the highest at the top", () => {
  expect(lineOf([2, 4, 3], [100, 10])).toEqual([
    [0, 10],
    [50, 0],
    [100, 5],
  ]);
  expect(lineOf([7], [100, 10])).toEqual([[0, 10]]);
});
