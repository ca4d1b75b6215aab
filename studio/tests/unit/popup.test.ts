import { describe, expect, test } from "vitest";

import { placing } from "../../src/core/initial";
import { parsePopup, type Popup } from "../../src/core/popup";
import { CATALOGUE } from "../page/sample";

function slider(text: string) {
  const popup = parsePopup(text);
  if (popup?.is !== "slider") return popup;
  const { min, value, max, rounding, digits } = popup.slider;
  return rounding === "integer" ? [min, value, max] : [min, value, max, digits];
}

describe("sliders", () => {
  test.each<[string, unknown]>([
    ["5", [0, 5, 10]],
    ["10", [0, 10, 10]],
    ["12", [0, 12, 100]],
    ["0", [0, 0, 10]],
    ["0.50", [0, 0.5, 1, 2]],
    ["4.0", [0, 4, 10, 1]],
    [".5", [0, 0.5, 1, 1]],
    ["5<10", [5, 5, 10]],
    ["0<3.5<10", [0, 3.5, 10, 1]],
    ["0 < 3 < 10", [0, 3, 10]],
    ["1..9", [1, 1, 9]],
    ["0..3..9", [0, 3, 9]],
    ["0.0..0.25..1", [0, 0.25, 1, 2]],
    ["-7..", [-10, -7, 0]],
    ["0-7", [-10, -7, 0]],
    ["0-0.7", [-1, -0.7, 0, 1]],
    ["-5<0<5", [-5, 0, 5]],
    ["10<0", [0, 10, 10]],
    ["0<50<10", [0, 10, 10]],
  ])("%s", (text, found) => expect(slider(text)).toEqual(found));

  test.each(["5<", "<", "5<5", "1e999", "5<a", "1..2..3..4", "..", "0-", "--5"])("%s is none", (text) => {
    expect(parsePopup(text)?.is).not.toBe("slider");
  });
});

describe("texts and points", () => {
  test.each<[string, Popup | undefined]>([
    ['"hello', { is: "panel", text: "hello" }],
    ['"hello"', { is: "panel", text: "hello" }],
    ["//hello there", { is: "panel", text: "hello there" }],
    ["//", { is: "panel", text: "" }],
    ["~note", { is: "scribble", text: "note" }],
    ["1,2,3", { is: "point", at: [1, 2, 3] }],
    ["1.5,-2", { is: "point", at: [1.5, -2, 0] }],
    ["{1, 2, 3}", { is: "point", at: [1, 2, 3] }],
    ["1,2,3,4", undefined],
    ["1,", undefined],
    ["circle", undefined],
    ["", undefined],
  ])("%s", (text, found) => expect(parsePopup(text)).toEqual(found));
});

describe("operators", () => {
  test.each<[string, string, string | undefined]>([
    ["+", "Addition", undefined],
    ["+5", "Addition", "5"],
    ["-7", "Subtraction", "7"],
    ["- 0.5", "Subtraction", "0.5"],
    ["*2", "Multiplication", "2"],
    ["/2", "Division", "2"],
    ["\\3", "Integer Division", "3"],
    ["%4", "Modulus", "4"],
    ["&abc", "Concatenate", "abc"],
    ["=x", "Equality", "x"],
    ["<3", "Smaller Than", "3"],
    [">", "Larger Than", undefined],
    ["pi", "Pi", undefined],
    ["2*pi", "Pi", "2"],
    ["0.5 pi", "Pi", "0.5"],
  ])("%s", (text, component, value) => {
    expect(parsePopup(text)).toMatchObject({ is: "operator", component, value });
  });

  test("what follows a sign of arithmetic is a number", () => expect(parsePopup("+abc")).toBeUndefined());
});

describe("what is placed", () => {
  test("a name with a value goes to the first input that suits it", () => {
    const popup = parsePopup("circle=5");
    expect(popup).toEqual({ is: "initialised", component: "circle", value: "5" });
    // The plane comes first, but a number is no plane.
    expect(popup && placing(popup, CATALOGUE)?.with).toEqual({ is: "values", values: [[1, "5"]] });
  });

  test("an operator takes its second operand", () => {
    const popup = parsePopup("+5");
    expect(popup && placing(popup, CATALOGUE)).toMatchObject({ name: "Addition", with: { is: "values", values: [[1, "5"]] } });
  });

  test("a component that is not there places nothing", () => {
    const popup = parsePopup("nosuch=5");
    expect(popup && placing(popup, CATALOGUE)).toBeUndefined();
  });
});
