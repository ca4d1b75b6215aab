import { describe, expect, test } from "vitest";

import { learnt, likelyAfter, readCounts } from "../../src/core/likely";

/** An object with one output named after it, which reads others. */
const object = (id: string, component: string, ...sources: string[]) => ({ id, component, inputs: [{ sources }], outputs: [{ id }] });

describe("likely next components", () => {
  const first = [object("a", "point"), object("b", "line", "a"), object("c", "line", "a"), object("d", "circle", "a"), object("e", "divide", "b", "d")];

  test("are counted by wires, the most frequent first", () => {
    const counts = learnt({}, first);
    expect(counts).toEqual({ point: { line: 2, circle: 1 }, line: { divide: 1 }, circle: { divide: 1 } });
    expect(likelyAfter(counts, "point")).toEqual(["line", "circle"]);
    expect(likelyAfter(counts, "point", 1)).toEqual(["line"]);
  });

  test("of several definitions add up", () => {
    const more = learnt(learnt({}, first), [object("p", "point"), object("q", "circle", "p", "p"), object("r", "circle", "p")]);
    expect(more.point).toEqual({ line: 2, circle: 4 });
    expect(likelyAfter(more, "point")).toEqual(["circle", "line"]);
  });

  test("do not come of wires from nowhere, nor of names that every object has", () => {
    expect(learnt({}, [object("a", "line", "gone")])).toEqual({});
    expect(likelyAfter({}, "constructor")).toEqual([]);
    expect(likelyAfter({}, "__proto__")).toEqual([]);
  });

  test("are kept within bounds, the rare ones are let go", () => {
    const many = Array.from({ length: 40 }, (_, k) => object(`t${k}`, `to${k}`, ...Array.from({ length: k + 1 }, () => "a")));
    const counts = learnt({}, [object("a", "from"), ...many]);
    expect(Object.keys(counts.from ?? {})).toHaveLength(16);
    expect(likelyAfter(counts, "from", 2)).toEqual(["to39", "to38"]);
    const wide = Array.from({ length: 900 }, (_, k) => [object(`f${k}`, `from${k}`), object(`g${k}`, "to", `f${k}`)]).flat();
    expect(Object.keys(learnt({}, wide))).toHaveLength(600);
  });

  test("are read from what a browser kept, whatever that is", () => {
    for (const found of [undefined, null, 3, "x", [], { a: 1 }]) expect(likelyAfter(readCounts(found), "a")).toEqual([]);
    expect(readCounts({ a: { b: 2, c: "x", d: -1, e: Infinity } })).toEqual({ a: { b: 2 } });
  });
});
