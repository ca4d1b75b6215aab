import { describe, expect, test } from "vitest";

import { boxPlace } from "../../src/core/boxPlace";
import { meets } from "../../src/core/geometry";

const room = [800, 600] as const;
const size = [300, 200] as const;

describe("a box about an object", () => {
  test("opens below it, above it where there is no room, beside it where there is none either", () => {
    expect(boxPlace([100, 100, 80, 20], size, room)).toEqual([100, 128]);
    expect(boxPlace([100, 560, 80, 20], size, room)).toEqual([100, 352]);
    expect(boxPlace([20, 150, 80, 400], size, room)).toEqual([108, 150]);
    expect(boxPlace([700, 150, 80, 400], size, room)).toEqual([392, 150]);
  });

  test("never covers it while it can be helped, and always begins in the window", () => {
    for (let x = -100; x < 900; x += 90) {
      for (let y = -100; y < 700; y += 70) {
        const rect = [x, y, 120, 40] as const;
        const [left, top] = boxPlace(rect, size, room);
        expect(left >= 8 && top >= 8 && left + 300 <= 800 && top + 200 <= 600).toBe(true);
        expect(meets([left, top, ...size], rect)).toBe(false);
      }
    }
  });
});
