import { expect, test } from "vitest";

import { readSettings } from "../../src/app/settings";
import { place } from "../../src/app/place";
import { isNamed } from "../../src/app/files";
import { shownTime } from "../../src/app/Status";
import { modelNeeds, whyNothing } from "../../src/core/needs";
import { listed } from "../../src/app/Telling";
import { fromHex, toHex } from "../../src/core/colour";
import { t } from "../../src/i18n";
import { inputGroups, playable } from "../../src/player/groups";
import { moved, startOf } from "../../src/player/reset";
import { object, port } from "./make";

test("settings that make no sense are as usual", () => {
  expect(readSettings("nonsense").theme).toBe("system");
  expect(readSettings('{"theme":"dark","split":7,"side":"kitchen"}')).toMatchObject({ theme: "dark", split: 0.85, side: undefined });
  expect(readSettings("null").panes).toBe("both");
});

test("the address says what is shown", () => {
  expect(place("?document=7&player")).toEqual({ document: "7", player: true });
  expect(place("")).toEqual({ document: undefined, player: false });
});

test("files are known by the ends of their names", () => {
  expect(isNamed("A.GHX", [".gh", ".ghx"])).toBe(true);
  expect(isNamed("a.gh.txt", [".gh"])).toBe(false);
});

test("colours and times are written for people", () => {
  expect(toHex(fromHex("#0a80ff", 7))).toBe("#0a80ff");
  expect(fromHex("red")).toEqual([0, 0, 0, 255]);
  expect([shownTime(0.2), shownTime(12.4), shownTime(2345)]).toEqual(["< 1 ms", "12 ms", "2.3 s"]);
  expect(t("outline.count", { n: 3 })).toBe("3 objects");
  expect(t("canvas.data.count", { items: 130, branches: 1 })).toBe("130 items in 1 branch");
  expect(t("canvas.data.count", { items: 1, branches: 2 })).toBe("1 item in 2 branches");
});

test("what a definition needs of a Rhino model is counted by type", () => {
  const lacking = (id: string, ...lacks: { kind: string; objects: number; hasModel: boolean }[]) => ({ id, messages: [], outputs: [], panel: null, lacks });
  const objects = new Map([
    ["a", object("a", { kind: "parameter", inputs: [{ ...port("a"), kind: "Curve" }] })],
    ["b", object("b", { kind: "parameter", inputs: [{ ...port("b"), kind: "Surface" }] })],
    ["c", object("c")],
  ]);
  const results = new Map([
    ["a", lacking("a", { kind: "Curve", objects: 1, hasModel: false })],
    // One object may need things in several inputs, and a model as a whole counts as one.
    ["b", lacking("b", { kind: "Surface", objects: 5, hasModel: true }, { kind: "Curve", objects: 2, hasModel: false })],
    ["c", { ...lacking("c"), messages: [{ level: "warning", text: "Needs the Rhino model" }] }],
    ["gone", lacking("gone", { kind: "Mesh", objects: 9, hasModel: false })],
  ] as [string, unknown][]) as unknown as Parameters<typeof modelNeeds>[1];
  const found = modelNeeds(objects, results);
  expect(found?.objects).toEqual(["a", "b"]);
  expect(found && listed(found)).toBe("3 curves and 5 surfaces");
  expect(found?.isWrongModel).toBe(true);
  expect(modelNeeds(objects, new Map())).toBeUndefined();
});

test("why nothing is seen is known", () => {
  const shape = object("s", { previews: true });
  const of = (...list: ReturnType<typeof object>[]) => new Map(list.map((one) => [one.id, one]));
  expect(whyNothing(of(), "all")).toBeUndefined();
  expect(whyNothing(of(object("n")), "all")).toEqual({ is: "numbers" });
  expect(whyNothing(of(shape), "none")).toEqual({ is: "off" });
  expect(whyNothing(of({ ...shape, hidden: true }), "all")).toEqual({ is: "hidden", objects: ["s"] });
  expect(whyNothing(of(shape, object("t", { previews: true, hidden: true })), "all")).toEqual({ is: "null", count: 1 });
});

test("a visitor moves free controls, from top to bottom", () => {
  const slider = { is: "slider" as const, value: 1, min: 0, max: 2, rounding: "float" as const, digits: 1, expression: null };
  const low = object("low", { bounds: [0, 90, 10, 10], control: slider });
  const high = object("high", { bounds: [0, 10, 10, 10], control: slider });
  const wired = object("wired", { inputs: [port("wired", ["x"])], control: { is: "toggle", on: true } });
  const off = object("off", { control: slider, disabled: true });
  expect(playable([low, wired, high, off]).map(({ id }) => id)).toEqual(["high", "low"]);
});

test("inputs stand under the labels of their groups; a panel that nothing reads is a remark", () => {
  const slider = (value: number) => ({ is: "slider" as const, value, min: 0, max: 9, rounding: "float" as const, digits: 1, expression: null });
  const group = { is: "group", label: "Tower", colour: [0, 0, 0, 255], border: "box", members: ["in"] } as unknown as NonNullable<ReturnType<typeof object>["control"]>;
  const panel = { is: "panel", text: "note" } as unknown as NonNullable<ReturnType<typeof object>["control"]>;
  const list = [
    object("in", { control: slider(2), bounds: [0, 50, 9, 9] }),
    object("out", { control: slider(3) }),
    object("note", { control: panel }),
    object("g", { kind: "group", control: group }),
  ];
  const objects = new Map(list.map((one) => [one.id, one]));
  expect(inputGroups(objects).map(({ label, inputs }) => [label, inputs.map(({ object }) => object.id)])).toEqual([["", ["out"]], ["Tower", ["in"]]]);
  const start = startOf(list);
  expect(moved(start, list)).toEqual([]);
  expect(moved(start, [object("in", { control: slider(5) })])).toEqual([["in", { is: "number", value: 2 }]]);
});
