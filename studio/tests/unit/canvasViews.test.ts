import { describe, expect, test } from "vitest";

import { beside, lensOf, readViews, viewOf } from "../../src/core/canvasViews";
import { freshName, renamed, withNamed, without } from "../../src/core/named";
import { toCanvas } from "../../src/core/geometry";

const lens = { x: -300, y: 40, zoom: 0.5 };
const size = [800, 600] as const;

describe("named views", () => {
  test("show the same place in a window of any size", () => {
    const view = viewOf("Truss", lens, size, ["c"]);
    expect(lensOf(view, size)).toEqual(lens);
    const other = lensOf(view, [1000, 200]);
    expect(toCanvas(other, [500, 100])).toEqual(view.centre);
    expect(other.zoom).toBe(0.5);
  });

  test("have one name each", () => {
    const a = viewOf("A", lens, size, []);
    const b = viewOf("B", lens, size, []);
    const list = withNamed(withNamed(withNamed([], a), b), { ...a, zoom: 2 });
    expect(list.map(({ name, zoom }) => [name, zoom])).toEqual([["A", 2], ["B", 0.5]]);
    expect(renamed(list, "A", " C ").map(({ name }) => name)).toEqual(["C", "B"]);
    expect(renamed(list, "A", "B")).toEqual(list);
    expect(renamed(list, "A", " ")).toEqual(list);
    expect(without(list, "A").map(({ name }) => name)).toEqual(["B"]);
    expect(freshName(list, (n) => "AB"[n - 1] ?? "Z")).toBe("Z");
  });

  test("are gone through in a round", () => {
    const list = ["A", "B"].map((name) => viewOf(name, lens, size, []));
    expect(beside(list, undefined, 1)?.name).toBe("A");
    expect(beside(list, undefined, -1)?.name).toBe("B");
    expect(beside(list, "B", 1)?.name).toBe("A");
    expect(beside(list, "A", -1)?.name).toBe("B");
    expect(beside([], "A", 1)).toBeUndefined();
  });

  test("come back from what was kept, and nothing else does", () => {
    const list = [viewOf("A", lens, size, ["c"])];
    expect(readViews(JSON.stringify(list))).toEqual(list);
    for (const text of [null, "", "{", "7", "{}", '[1,null,{"name":"x"},{"name":"","zoom":1,"centre":[0,0]}]', '[{"name":"x","zoom":1,"centre":[0,"y"]}]']) {
      expect(readViews(text)).toEqual([]);
    }
    expect(readViews('[{"name":"x","zoom":1e9,"centre":[0,0],"within":[3]}]')).toEqual([{ name: "x", zoom: 5, centre: [0, 0], within: [] }]);
  });
});
