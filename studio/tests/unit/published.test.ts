import { expect, test } from "vitest";

import type { ObjectView } from "../../src/core/protocol/ObjectView";
import { movedRow, publishedOf, rowsOf } from "../../src/core/published";
import { shownInputs } from "../../src/player/groups";
import { object, port } from "./make";

const slider = { is: "slider", value: 1, min: 0, max: 2, rounding: "float", digits: 1, expression: null } as const;
const [a, b, c] = ["a", "b", "c"].map((id, k) => object(id, { nickname: id.toUpperCase(), control: slider, bounds: [0, k, 9, 9] }));
const all = [a, b, c].flatMap((one) => (one ? [one] : []));
const objects = new Map(all.map((one) => [one.id, one]));
const input = (id: string, label = "", help = "") => ({ object: id, label, help });

test("what is published is shown in its order and by its labels, and what is gone is not", () => {
  const shown = shownInputs(objects, [input("c", "Breadth", "in metres"), input("gone"), input("a")]);
  expect(shown.map(({ object, label, help }) => [object.id, label, help])).toEqual([["c", "Breadth", "in metres"], ["a", "A", ""]]);
  expect(shownInputs(objects, null).map(({ label }) => label)).toEqual(["A", "B", "C"]);
  expect(shownInputs(objects, [])).toEqual([]);
});

test("rows are moved and switched, and published as they stand", () => {
  const rows = rowsOf(all, [input("c", " Breadth "), input("gone")]);
  expect(rows.map(({ object, isShown }) => [object, isShown])).toEqual([["c", true], ["a", false], ["b", false]]);
  expect(rowsOf(all, null).every(({ isShown }) => isShown)).toBe(true);
  expect(publishedOf(rows)).toEqual([input("c", "Breadth")]);
  expect(movedRow(rows, 0, 1).map(({ object }) => object)).toEqual(["a", "c", "b"]);
  expect(movedRow(rows, 2, 1)).toEqual(rows);
});

test("a control that nobody named is called by the input that it is for", () => {
  const panel: ObjectView["control"] = { is: "panel", text: "25", multiline: false, paths: false, indices: false, wrap: false, specialCodes: false, alignment: 0, colour: [0, 0, 0, 0], stream: null };
  const unnamed = (id: string, k: number) => object(id, { name: "Panel", nickname: "Panel", control: panel, bounds: [0, k, 9, 9], inputs: [port(id)], outputs: [port(id)] });
  const divide = object("d", { name: "Divide Curve", nickname: "Divide", inputs: [{ ...port("n", ["p"]), name: "Count" }] });
  const width = object("w", { name: "Number", nickname: "Width", kind: "parameter", inputs: [port("w", ["q"])], outputs: [port("w")] });
  const found = new Map([unnamed("p", 0), unnamed("q", 1), divide, width].map((one) => [one.id, one]));
  expect(shownInputs(found, null).map(({ label }) => label)).toEqual(["Count of Divide Curve", "Width"]);
  expect(shownInputs(found, [input("p", "Pieces")]).map(({ label }) => label)).toEqual(["Pieces"]);
});
