import { expect, test } from "vitest";

import { movedRow, publishedOf, rowsOf } from "../../src/core/published";
import { shownInputs } from "../../src/player/groups";
import { object } from "./make";

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
