import { expect, test } from "vitest";

import { tabs, type CatalogueEntry } from "../../src/core/catalogue";
import { columnsOf, withRecent } from "../../src/core/ribbon";

test("panels fill the width, the fullest first", () => {
  expect(columnsOf([20, 2, 8], 500, 50, 10)).toEqual([6, 1, 2]);
  expect(columnsOf([2, 2], 2000, 50, 10)).toEqual([1, 1]);
  expect(columnsOf([20, 20], 60, 50, 10)).toEqual([1, 1]);
  expect(columnsOf([], 500, 50, 10)).toEqual([]);
  // The room that a name takes is there for buttons too, and for no others.
  expect(columnsOf([20, 2, 8], 500, 50, 10, [1, 3, 0])).toEqual([4, 3, 2]);
  expect(columnsOf([20, 20], 60, 50, 10, [2, 3])).toEqual([2, 3]);
});

test("what was placed lately stands once, the last first", () => {
  expect(withRecent(["a", "b", "c"], "b", 3)).toEqual(["b", "a", "c"]);
  expect(withRecent(["a", "b", "c"], "d", 3)).toEqual(["d", "a", "b"]);
});

test("a slider, a panel and a toggle come first among inputs", () => {
  const entry = (name: string) => ({ name, guid: name, nick: "", tab: "Params", panel: "Input", old: false }) as unknown as CatalogueEntry;
  const [params] = tabs(["Atom Data", "Boolean Toggle", "Panel", "Button", "Number Slider"].map(entry));
  expect(params?.panels[0]?.entries.map(({ name }) => name)).toEqual(["Number Slider", "Panel", "Boolean Toggle", "Button", "Atom Data"]);
});
