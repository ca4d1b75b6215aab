import { describe, expect, test } from "vitest";

import { colourAt, mirrored, preset, PRESETS, withGrip, withoutGrip } from "../../src/core/gradient";
import type { GripView } from "../../src/core/protocol/GripView";

const black: GripView["left"] = [0, 0, 0, 255];
const white: GripView["left"] = [255, 255, 255, 255];
const red: GripView["left"] = [255, 0, 0, 255];
/** Grey to the middle, where it jumps to red. */
const grips: GripView[] = [
  { at: 1, left: red, right: red },
  { at: 0, left: black, right: black },
  { at: 0.5, left: white, right: red },
];

describe("gradients", () => {
  test("have the colour of the straight line between grips", () => {
    expect(colourAt(grips, 0)).toEqual(black);
    expect(colourAt(grips, 0.25)).toEqual([128, 128, 128, 255]);
    expect(colourAt(grips, 0.499999)).toEqual(white);
    expect(colourAt(grips, 0.75)).toEqual(red);
    expect(colourAt(grips, 2)).toEqual(red);
    expect(colourAt([], 0.5)).toEqual([128, 128, 128, 255]);
  });

  test("look the same after a grip is put in", () => {
    const more = withGrip(grips, 0.2);
    expect(more).toHaveLength(4);
    for (const at of [0, 0.1, 0.2, 0.3, 0.45, 0.8]) {
      colourAt(more, at).forEach((part, k) => expect(Math.abs(part - (colourAt(grips, at)[k] ?? 0))).toBeLessThanOrEqual(2));
    }
  });

  test("keep a last grip", () => {
    expect(withoutGrip(withoutGrip(withoutGrip(grips, 0), 0), 0)).toHaveLength(1);
  });

  test("mirrored twice are the same", () => {
    expect(mirrored(mirrored(grips))).toEqual([...grips].sort((a, b) => a.at - b.at));
    expect(colourAt(mirrored(grips), 0.1)).toEqual(colourAt(grips, 0.9));
  });

  test("to begin with are sound", () => {
    for (const name of PRESETS) {
      const all = preset(name);
      expect(all.length).toBeGreaterThan(1);
      for (const grip of all) {
        expect(grip.at >= 0 && grip.at <= 1).toBe(true);
        for (const part of [...grip.left, ...grip.right]) expect(Number.isInteger(part) && part >= 0 && part <= 255).toBe(true);
      }
    }
  });
});
