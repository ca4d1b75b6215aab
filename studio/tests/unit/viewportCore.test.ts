import { describe, expect, it } from "vitest";

import { boundsOfPositions, centre, radius, union } from "../../src/core/bounds";
import { colourAt, colourRamp, shortNumber, usefulRange } from "../../src/core/falseColour";
import { gridSteps, snap } from "../../src/core/gridSteps";
import { parsePoint, pointText, rowsText, withPoint } from "../../src/core/pointText";
import { nearestOnSegment, rectangle, segmentTouches, triangleTouches } from "../../src/core/screen";

describe("boxes", () => {
  it("of positions far away keep their size", () => {
    const box = boundsOfPositions(Float32Array.from([0, 0, 0, 0.25, 1, 2]), [1e9, 0, 0]);
    expect(box).toEqual([[1e9, 0, 0], [1e9 + 0.25, 1, 2]]);
    expect(boundsOfPositions(new Float32Array(), [0, 0, 0])).toBeNull();
  });

  it("unite, and nothing adds nothing", () => {
    const [a, b] = [[[0, 0, 0], [1, 1, 1]], [[-1, 2, 0], [0, 3, 0]]] as const;
    expect(union(a, b)).toEqual([[-1, 0, 0], [1, 3, 1]]);
    expect(union(a, null)).toBe(a);
    expect(centre([[-1, 0, 2], [1, 4, 2]])).toEqual([0, 2, 2]);
    expect(radius([[0, 0, 0], [3, 4, 0]])).toBe(2.5);
  });
});

describe("false colours", () => {
  it("go from blue to red and stay inside", () => {
    expect(colourAt(-1)).toEqual(colourAt(0));
    expect(colourAt(2)).toEqual(colourAt(1));
    const ramp = colourRamp(256);
    expect([...ramp.slice(0, 3)]).toEqual([38, 70, 196]);
    expect([...ramp.slice(-4, -1)]).toEqual([206, 54, 46]);
  });

  it("have a range without outliers", () => {
    const numbers = Float32Array.from({ length: 1000 }, (_, at) => at / 1000);
    numbers[5] = 1e20;
    const [low, high] = usefulRange([numbers]) ?? [NaN, NaN];
    expect(low).toBeGreaterThanOrEqual(0);
    expect(high).toBeLessThan(1.01);
    expect(usefulRange([])).toBeUndefined();
    expect(usefulRange([Float32Array.from([NaN, Infinity])])).toBeUndefined();
    expect(usefulRange([Float32Array.from([NaN, 1, 2, -Infinity])])).toEqual([1, 2]);
  });

  it("show the same number in the middle of the map, without the noise of rounding", () => {
    const [low, high] = usefulRange([Float32Array.from([0.2, 0.2000001, 0.1999999])]) ?? [0, 0];
    expect((0.2 - low) / (high - low)).toBeCloseTo(0.5, 3);
  });

  it("have legends in few digits", () => {
    expect([0, 0.0401234, 123456, 1e-9, -2.5].map(shortNumber)).toEqual(["0", "0.04012", "123500", "1.00e-9", "-2.5"]);
  });
});

describe("the grid", () => {
  it("has lines apart enough to be seen", () => {
    for (let exponent = -6; exponent < 6; exponent += 0.1) {
      const pixel = 10 ** exponent;
      const { minor, major, strength } = gridSteps(pixel);
      expect(minor / pixel).toBeGreaterThanOrEqual(7 - 1e-9);
      expect(minor / pixel).toBeLessThanOrEqual(70 + 1e-6);
      expect(major).toBeCloseTo(minor * 10, 10);
      expect(strength).toBeGreaterThan(0);
      expect(strength).toBeLessThanOrEqual(1);
    }
  });

  it("snaps without adding digits", () => {
    expect(snap(0.29999, 0.1)).toBe(0.3);
    expect(snap(-1234.4, 10)).toBe(-1230);
  });
});

describe("points as text", () => {
  it("are read as Grasshopper writes them", () => {
    expect(parsePoint("{1, 2.5, -3}")).toEqual([1, 2.5, -3]);
    expect(parsePoint("1,2,.5")).toEqual([1, 2, 0.5]);
    expect(parsePoint(" { 1e3 , -2E-2 , 0 } ")).toEqual([1000, -0.02, 0]);
    for (const bad of ["", "{1,2}", "{1,2,x}", "{1,2,1e999}", "{0;1}", "1,2,3,4"]) expect(parsePoint(bad)).toBeUndefined();
    expect(parsePoint(pointText([0.1, -2, 3e-7]))).toEqual([0.1, -2, 3e-7]);
  });

  it("change in their own row alone", () => {
    const rows = [
      { is: "path", path: "{0}", items: 2 } as const,
      { is: "item", index: 0, text: "{0, 0, 0}" } as const,
      { is: "item", index: 1, text: "{1, 1, 1}" } as const,
      { is: "path", path: "{1}", items: 1 } as const,
      { is: "item", index: 0, text: "{2, 2, 2}" } as const,
    ];
    expect(rowsText(withPoint(rows, 4, [9, 9, 9]))).toBe("{0}\n{0, 0, 0}\n{1, 1, 1}\n{1}\n{9, 9, 9}");
  });
});

describe("the screen", () => {
  const box = rectangle(30, 20, 10, 10);

  it("finds the nearest place of a segment", () => {
    expect(nearestOnSegment(5, 5, 0, 0, 10, 0)).toEqual([0.5, 25]);
    expect(nearestOnSegment(-3, 4, 0, 0, 10, 0)).toEqual([0, 25]);
    expect(nearestOnSegment(3, 4, 0, 0, 0, 0)).toEqual([0, 25]);
  });

  it("knows what a window crosses", () => {
    expect(box).toEqual({ left: 10, top: 10, right: 30, bottom: 20 });
    expect(segmentTouches(box, 0, 15, 40, 15)).toBe(true);
    expect(segmentTouches(box, 12, 12, 13, 13)).toBe(true);
    expect(segmentTouches(box, 0, 0, 9, 40)).toBe(false);
    expect(segmentTouches(box, 0, 25, 40, 25)).toBe(false);
    expect(triangleTouches(box, 0, 0, 100, 0, 0, 100)).toBe(true);
    expect(triangleTouches(box, 50, 50, 60, 50, 50, 60)).toBe(false);
    // Its box touches, it does not.
    expect(triangleTouches(box, 0, 18, 0, 100, 60, 100)).toBe(false);
  });
});
