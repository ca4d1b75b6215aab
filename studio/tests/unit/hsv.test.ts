import { describe, expect, test } from "vitest";

import { graphChoices } from "../../src/core/graph";
import { colourText, ofHsv, readColour, steppedHsv, toHsv } from "../../src/core/hsv";

describe("hue, saturation, value", () => {
  test("of known colours", () => {
    expect(toHsv([255, 0, 0, 255])).toEqual([0, 1, 1]);
    expect(toHsv([0, 255, 0, 255])).toEqual([120, 1, 1]);
    expect(toHsv([0, 0, 255, 255])).toEqual([240, 1, 1]);
    expect(toHsv([128, 128, 128, 255])[1]).toBe(0);
    expect(toHsv([0, 0, 0, 255])).toEqual([0, 0, 0]);
    expect(ofHsv([60, 1, 1])).toEqual([255, 255, 0, 255]);
    expect(ofHsv([300, 0.5, 1], 7)).toEqual([255, 128, 255, 7]);
  });

  test("there and back is the same colour", () => {
    for (let k = 0; k < 4096; k += 7) {
      const colour = [(k * 37) % 256, (k * 91) % 256, (k * 151) % 256, 255] as const;
      expect(ofHsv(toHsv(colour))).toEqual([...colour]);
    }
  });

  test("steps stay inside the square", () => {
    expect(steppedHsv([10, 0.995, 0], [1, -1])).toEqual([10, 1, 0]);
  });
});

describe("colours that are typed", () => {
  test("are read in several ways", () => {
    expect(readColour("#f80")).toEqual([255, 136, 0, 255]);
    expect(readColour("ff8800")).toEqual([255, 136, 0, 255]);
    expect(readColour("#FF880080")).toEqual([255, 136, 0, 128]);
    expect(readColour("255, 136 0", 9)).toEqual([255, 136, 0, 9]);
    expect(readColour("1;2;3;4")).toEqual([1, 2, 3, 4]);
  });

  test("are none when they are not", () => {
    for (const text of ["", "red", "#12", "1,2", "1,2,300", "1,2,3,4,5", "255", "-1,0,0"]) expect(readColour(text)).toBeUndefined();
  });

  test("are shown as they can be read again", () => {
    for (const colour of [[1, 2, 3, 255], [200, 0, 16, 0], [9, 9, 9, 128]] as const) expect(readColour(colourText(colour))).toEqual([...colour]);
  });
});

test("a menu of graphs offers what can be made, and what is there", () => {
  const known = ["Bezier", "Gaussian", "Linear", "Parabola", "Sine"];
  expect(graphChoices("")).toEqual(known);
  expect(graphChoices("Sine")).toEqual(known);
  expect(graphChoices("Perlin")).toEqual(["Bezier", "Gaussian", "Linear", "Parabola", "Perlin", "Sine"]);
});
