import { describe, expect, test } from "vitest";

import { evaluate } from "../../src/core/arithmetic";
import { afterKey, limitsAbout, position, snapped, sliderText, typed, valueAt, type Slider } from "../../src/core/slider";

const slider = (change: Partial<Slider> = {}): Slider => ({
  is: "slider",
  value: 3,
  min: 0,
  max: 10,
  rounding: "float",
  digits: 2,
  expression: null,
  ...change,
});

describe("which numbers there are", () => {
  test.each<[Partial<Slider>, number, number]>([
    [{}, 3.14159, 3.14],
    [{}, 0.1 + 0.2, 0.3],
    [{ digits: 0 }, 3.6, 4],
    [{ rounding: "integer" }, 3.5, 4],
    [{ rounding: "even" }, 5.1, 6],
    [{ rounding: "odd" }, 4.1, 5],
    [{ rounding: "odd" }, 10, 9],
    [{ rounding: "odd" }, 0, 1],
    [{ rounding: "even", min: 1, max: 9 }, 9, 8],
    [{ rounding: "even", min: 1, max: 9 }, 0, 2],
    [{ rounding: "even", min: -9 }, -7.2, -8],
    [{}, 11, 10],
    [{}, -4, 0],
    [{}, Number.NaN, 0],
    [{ min: 10, max: 0 }, 4.444, 4.44],
    [{ rounding: "even", min: 3, max: 3.5 }, 3.2, 3.2],
  ])("%j at %d gives %d", (change, value, found) => expect(snapped(slider(change), value)).toBe(found));

  test("every number of a slider is its own nearest", () => {
    for (const rounding of ["float", "integer", "even", "odd"] as const) {
      const one = slider({ rounding, min: -7.3, max: 11.9 });
      for (let k = 0; k <= 200; k++) {
        const value = valueAt(one, k / 200);
        expect(snapped(one, value)).toBe(value);
        expect(value).toBeGreaterThanOrEqual(one.min);
        expect(value).toBeLessThanOrEqual(one.max);
      }
    }
  });
});

test("a place gives a value, and the value the place", () => {
  const one = slider({ min: -5, max: 15, digits: 6 });
  for (const at of [0, 0.25, 0.5, 0.8, 1]) expect(position(one, valueAt(one, at))).toBeCloseTo(at, 6);
  expect(position(slider({ min: 2, max: 2 }), 2)).toBe(0.5);
});

test("a number is shown with the digits of its slider", () => {
  expect(sliderText(slider(), 3)).toBe("3.00");
  expect(sliderText(slider({ rounding: "integer" }), 3)).toBe("3");
});

test("keys go as ARIA says", () => {
  const one = slider({ rounding: "integer" });
  const go = (key: string, shift = false) => afterKey(one, 3, key, shift);
  expect([go("ArrowRight"), go("ArrowDown"), go("PageUp"), go("Home"), go("End"), go("x")]).toEqual([4, 2, 4, 0, 10, undefined]);
  expect(go("ArrowRight", true)).toBe(10);
  expect(afterKey(slider({ rounding: "even" }), 4, "ArrowRight", false)).toBe(6);
});

test("a number that is typed may be a formula, and beyond the limits moves them", () => {
  expect(typed(slider(), "3/4*2")?.value).toBe(1.5);
  expect(typed(slider(), "1,5")?.value).toBe(1.5);
  expect(typed(slider(), "x*2")?.value).toBe(6);
  expect(typed(slider(), "25")).toMatchObject({ value: 25, min: 0, max: 25 });
  expect(typed(slider(), "abc")).toBeUndefined();
  expect(typed(slider(), "1/0")).toBeUndefined();
});

test("limits about a value are powers of ten", () => {
  expect(limitsAbout(1000, true)).toEqual([0, 1000]);
  expect(limitsAbout(1001, true)).toEqual([0, 10000]);
  expect(limitsAbout(-3, true)).toEqual([-10, 0]);
  expect(limitsAbout(0.2, false)).toEqual([0, 1]);
});

describe("arithmetic", () => {
  test.each<[string, number | undefined]>([
    ["1+2*3", 7],
    ["(1+2)*3", 9],
    ["2^3^2", 512],
    ["-2^2", -4],
    ["2^-1", 0.5],
    ["7%4", 3],
    ["1.5e3", 1500],
    ["2*pi", 2 * Math.PI],
    ["sqrt(16)", 4],
    ["sin(pi/2)", 1],
    ["", undefined],
    ["1+", undefined],
    ["(1", undefined],
    ["1 2", undefined],
    ["foo(1)", undefined],
    ["constructor", undefined],
    ["toString(1)", undefined],
    ["1/0", undefined],
    ["2+$", undefined],
  ])("%s", (text, value) => {
    if (value === undefined) expect(evaluate(text)).toBeUndefined();
    else expect(evaluate(text)).toBeCloseTo(value, 12);
  });

  test("formulas that never end are refused", () => {
    const [deep, signs, powers] = [`${"(".repeat(5000)}1${")".repeat(5000)}`, `${"-".repeat(5000)}1`, `2${"^2".repeat(5000)}`];
    expect([deep, signs, powers].map((text) => evaluate(text))).toEqual([undefined, undefined, undefined]);
  });
});
