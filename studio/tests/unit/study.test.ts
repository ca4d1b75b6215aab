/** The pure parts of the page on a study. */
import { expect, test } from "vitest";

import { axesOf, label, shown } from "../../src/study/core/axes";
import { barsOf } from "../../src/study/core/bars";
import { fittedTo, moved, selectedBy, withBrush } from "../../src/study/core/brushes";
import { colourSteps, palette, STEPS } from "../../src/study/core/colours";
import { frontOf, holds, worth } from "../../src/study/core/front";
import { sorted } from "../../src/study/core/order";
import { type Answer, type Cell, type Column, isGood, merged, type Row } from "../../src/study/core/rows";

/** Numbers from 0 to 1, always the same. */
function chance(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

const columns: Column[] = [
  { name: "height", kind: "in", number: true },
  { name: "shape", kind: "in", number: false },
  { name: "Area", kind: "out", number: true },
];
const row = (point: number, cells: Cell[], status = "ok"): Row => ({ point, status, reason: "", picture: "", geometry: "", cells });
const rows = [row(0, [1, "tower", 10]), row(1, [2, "slab", null], "error"), row(2, [3, "tower", "NaN"], "not-finite"), row(3, [4, true, 40])];

test("columns are axes: numbers by their size, texts by their order, what has none beside them", () => {
  const [height, shape, area, status] = axesOf(columns, rows);
  expect(height).toMatchObject({ key: "in.height", domain: [1, 4], words: undefined });
  expect([...(height?.values ?? [])]).toEqual([1, 2, 3, 4]);
  expect(shape).toMatchObject({ words: ["slab", "tower", "true"], domain: [-0.5, 2.5] });
  expect([...(shape?.values ?? [])]).toEqual([1, 0, 1, 2]);
  expect([...(area?.values ?? [])]).toEqual([10, NaN, NaN, 40]);
  expect(status?.words).toEqual(["error", "not-finite", "ok"]);
  expect(shape && [label(shape, 1), label(shape, 0.5)]).toEqual(["tower", ""]);
});

test("a column of one value has an axis with a length; one without numbers, or with very many texts, has none", () => {
  const many = Array.from({ length: 40 }, (_, k) => row(k, [5, `word ${k}`, null]));
  const axes = axesOf(columns, many);
  expect(axes.map(({ key }) => key)).toEqual(["in.height"]);
  expect(axes[0]?.domain[0]).toBeLessThan(5);
  expect(axes[0]?.domain[1]).toBeGreaterThan(5);
});

test("brushes take rows that lie in all of them, against a filter", () => {
  const draw = chance(7);
  const all = Array.from({ length: 500 }, (_, k) => row(k, [draw() * 10, draw() < 0.5 ? "a" : "b", draw() < 0.1 ? null : draw()]));
  const axes = axesOf(columns, all);
  for (let k = 0; k < 50; k += 1) {
    const [low, high] = [draw() * 10, draw() * 10].sort((a, b) => a - b) as [number, number];
    const brushes = new Map([["in.height", [low, high] as const], ["out.Area", [0.2, 0.7] as const]]);
    const taken = selectedBy(axes, brushes, all.length);
    const wanted = all.map(({ cells: [h, , area] }) => Number((h as number) >= low && (h as number) <= high && area !== null && (area as number) >= 0.2 && (area as number) <= 0.7));
    expect([...taken]).toEqual(wanted);
  }
  expect(selectedBy(axes, new Map(), 3)).toEqual(new Uint8Array([1, 1, 1]));
});

test("a brush stays on its axis, holds whole words, and goes when it holds everything", () => {
  const [height, shape] = axesOf(columns, rows);
  if (!height || !shape) throw new Error("two axes");
  expect(fittedTo(height, [9, 2])).toEqual([2, 4]);
  expect(fittedTo(shape, [0.4, 1.2])).toEqual([0.5, 1.5]);
  expect(fittedTo(shape, [1.1, 1.2])).toEqual([1.5, 2.5]);
  expect(withBrush(new Map(), height, [2, 3]).get("in.height")).toEqual([2, 3]);
  expect(withBrush(new Map([["in.height", [2, 3]]]), height, [0, 9]).size).toBe(0);
  expect(moved(height, [2, 3], "low", 3.5)).toEqual([3, 3]);
  expect(moved(height, [2, 3], "high", 99)).toEqual([2, 4]);
  expect(moved(shape, [-0.5, 2.5], "high", 1.5)).toEqual([-0.5, 1.5]);
  expect(moved(shape, [-0.5, 0.5], "high", -0.5)).toEqual([-0.5, 0.5]);
});

test("the front has all that no other is better than, against brute force", () => {
  const draw = chance(3);
  for (let round = 0; round < 60; round += 1) {
    const count = Math.floor(draw() * 60);
    const goals = Array.from({ length: 1 + (round % 3) }, () => Float64Array.from({ length: count }, () => (draw() < 0.05 ? NaN : Math.floor(draw() * 8))));
    const points = [...Array(count).keys()].filter(() => draw() < 0.9);
    const at = (point: number) => goals.map((goal) => goal[point] ?? NaN);
    const known = points.filter((point) => !at(point).some(Number.isNaN));
    const better = (a: number[], b: number[]) => a.every((x, k) => x <= (b[k] ?? 0)) && a.some((x, k) => x < (b[k] ?? 0));
    const wanted = known.filter((point) => !known.some((other) => better(at(other), at(point))));
    expect(frontOf(goals, points).sort((a, b) => a - b)).toEqual(wanted);
  }
  expect(frontOf([], [1, 2])).toEqual([]);
  expect([worth("least", 3), worth("most", 3), worth({ near: 5 }, 3)]).toEqual([3, -3, 2]);
  expect([holds({ "at-most": 3 }, 3), holds({ "at-least": 3 }, 2), holds({ "at-most": 3 }, NaN)]).toEqual([true, false, false]);
});

test("each point with a number is in one bar, and bars touch", () => {
  const draw = chance(11);
  for (const count of [1, 2, 30, 3000]) {
    const all = Array.from({ length: count }, (_, k) => row(k, [draw() * 3 - 1, k % 2 ? "a" : "b", null]));
    const axes = axesOf(columns, all);
    const selected = Uint8Array.from(all, (_, k) => Number(k % 3 === 0));
    for (const axis of axes) {
      const bars = barsOf(axis, selected);
      expect(bars.reduce((sum, bar) => sum + bar.all, 0)).toBe(count);
      expect(bars.reduce((sum, bar) => sum + bar.selected, 0)).toBe(Math.ceil(count / 3));
      bars.forEach((bar, k) => {
        const isIn = (x: number) => x >= bar.low && (x < bar.high || (k === bars.length - 1 && x <= bar.high));
        expect(bar.all).toBe([...axis.values].filter(isIn).length);
        if (k > 0) expect(bar.low).toBe(bars[k - 1]?.high);
      });
    }
  }
});

test("colours go from the lowest to the highest value; what has none has the last", () => {
  const [height, shape, area] = axesOf(columns, rows);
  expect([...colourSteps(height, 4)]).toEqual([0, STEPS / 3, (2 * STEPS) / 3, STEPS - 1]);
  expect([...colourSteps(shape, 4)]).toEqual([1, 0, 1, 2]);
  expect([...colourSteps(area, 4)]).toEqual([0, STEPS, STEPS, STEPS - 1]);
  expect(palette(shape, "dark")).toHaveLength(3);
  expect(new Set(palette(height, "light")).size).toBe(STEPS);
  expect(palette(undefined, "light")).toHaveLength(1);
});

test("the table is in the order that is asked for, with nothing last either way", () => {
  const all = [0, 1, 2, 3];
  const by = (by: "point" | "status" | "front" | number, descending = false) => sorted(all, rows, { by, descending }, new Set([3]));
  expect(by("point", true)).toEqual([3, 2, 1, 0]);
  expect(by("front")).toEqual([3, 0, 1, 2]);
  expect(by("status")).toEqual([1, 2, 0, 3]);
  expect(by(2)).toEqual([0, 3, 2, 1]);
  expect(by(2, true)).toEqual([2, 3, 0, 1]);
});

test("points come piece by piece; a new generation begins anew; nothing new changes nothing", () => {
  const about = { generation: 1, total: 2, planned: 4, state: "running" as const, name: "s", definition: null, goals: null, bounds: null, columns, problem: null };
  const told = (point: number): Answer["rows"][number] => [point, "ok", "", "", "", [point, "a", point]];
  const first = merged(undefined, { ...about, from: 0, rows: [told(0), told(1)] });
  expect(first.rows.map(({ point }) => point)).toEqual([0, 1]);
  const second = merged(first, { ...about, total: 3, from: 2, rows: [told(2)] });
  expect(second.rows.map(({ point }) => point)).toEqual([0, 1, 2]);
  expect(second.columns).toBe(first.columns);
  expect(merged(second, { ...about, total: 3, from: 3, rows: [] })).toBe(second);
  const done = merged(second, { ...about, total: 3, from: 3, rows: [], state: "done" });
  expect([done === second, done.rows === second.rows, done.state]).toEqual([false, true, "done"]);
  const anew = merged(second, { ...about, generation: 2, total: 1, from: 0, rows: [told(7)] });
  expect(anew.rows.map(({ point }) => point)).toEqual([7]);
  expect([isGood(row(0, [])), isGood(row(0, [], "")), isGood(row(0, [], "error"))]).toEqual([true, true, false]);
});

test("numbers are shown in a few digits", () => {
  expect([0, 0.1 + 0.2, 1234567.891, -2.5e-7, 3e12, Infinity].map(shown)).toEqual(["0", "0.3", "1234567.89", "-2.500e-7", "3.000e+12", "Infinity"]);
});
