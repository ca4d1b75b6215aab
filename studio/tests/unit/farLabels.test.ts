import { describe, expect, it } from "vitest";

import type { FarBox, FarList } from "../../src/core/far";
import { placeLabels } from "../../src/core/farLabels";
import { STRUCTURE_BELOW, type Rect } from "../../src/core/geometry";
import { textWidth } from "../../src/core/text";

function box(id: string, rect: Rect, text: string, change: Partial<FarBox> = {}): FarBox {
  const label = { text, size: 11, across: "centre" as const, bold: false, lines: "one" as const };
  return { id, rect, look: "plain", colour: undefined, kind: "box", lines: [], label, strip: undefined, icon: undefined, selected: false, ...change };
}

const list = (boxes: FarBox[], groups: FarBox[] = []): FarList => ({ boxes, groups, wires: [] });
const words = (boxes: FarBox[], zoom: number, groups: FarBox[] = []) =>
  placeLabels(list(boxes, groups), zoom).map(({ lines, size }) => ({ text: lines.join("|"), pixels: size * zoom }));

describe("words of the far view", () => {
  const one = box("a", [0, 0, 70, 44], "Addition");
  it("can be read at every zoom down to that where the structure alone is left", () => {
    for (const zoom of [0.49, 0.3, 0.2, STRUCTURE_BELOW]) {
      const [shown] = words([one], zoom);
      expect(shown?.text).toBe("Addition");
      expect(shown?.pixels).toBeGreaterThanOrEqual(9 - 1e-9);
    }
    expect(words([one], 0.1)).toEqual([]);
  });
  it("stand in their box, and beside it where they are longer", () => {
    expect(placeLabels(list([one]), 0.45)[0]?.on).toBe("ground");
    expect(placeLabels(list([box("a", [0, 0, 90, 44], "Len")]), 0.45)[0]?.on).toBe("box");
  });
  it("never lie over each other, nor over another's box", () => {
    const column = Array.from({ length: 20 }, (_, k) => box(`b${k}`, [(k % 5) * 80, Math.floor(k / 5) * 50, 70, 44], "Deconstruct Brep"));
    const placed = placeLabels(list(column), 0.2);
    const rects = placed.map(({ at: [x, y], lines, size }) => [x - (lines[0]?.length ?? 0) * size * 0.25, y - size / 2, (lines[0]?.length ?? 0) * size * 0.5, size]);
    rects.forEach(([x = 0, y = 0, w = 0, h = 0], i) =>
      rects.slice(i + 1).forEach(([u = 0, v = 0, p = 0, q = 0]) => expect(x < u + p && u < x + w && y < v + q && v < y + h).toBe(false)),
    );
  });
  it("leave out letters that stand for something where it cannot be seen, and keep apart from each other", () => {
    const group = (text: string, x: number) => box(text, [x, 0, 400, 300], text, { kind: "group" });
    expect(words([], 0.1, [group("b", 0)])).toEqual([]);
    expect(words([], 0.3, [group("b", 0)])[0]?.text).toBe("b");
    // The second begins where the first ends: read together they would be one.
    const first = box("g", [0, 0, 40, 300], "Towers", { kind: "group" });
    const [placed] = placeLabels(list([], [first]), 0.1);
    const wide = textWidth("Towers", placed?.size ?? 0);
    const beside = (gap: number) => box("h", [(placed?.at[0] ?? 0) + wide + gap, 0, 39, 300], "Walls", { kind: "group" });
    expect(words([], 0.1, [first, beside(-20)]).map(({ text }) => text)).toEqual(["Towers"]);
    expect(words([], 0.1, [first, beside(200)])).toHaveLength(2);
  });
  it("say the value of a slider where there is no room for its name", () => {
    const slider = box("s", [0, 0, 120, 40], "Number Slider 12.5");
    slider.label = { ...(slider.label as NonNullable<FarBox["label"]>), short: "12.5" };
    expect(words([slider], 0.3)[0]?.text).toBe("12.5");
  });
  it("show the first lines of a panel, messages on their band, and headings from farthest away", () => {
    const panel = box("p", [0, 0, 300, 120], "first\nsecond\nthird\nfourth");
    if (panel.label) panel.label.lines = "many";
    expect(words([panel], 0.2)[0]?.text).toBe("first|second");
    expect(words([box("m", [0, 0, 80, 60], "Rotate", { strip: "Degrees" })], 0.3).map(({ text }) => text)).toContain("Degrees");
    expect(words([], 0.04, [box("g", [0, 0, 900, 600], "Towers", { kind: "group" })])[0]?.text).toBe("Towers");
  });
  it("of a group go above it where a panel is read, and no words lie over those of a panel", () => {
    const panel = box("p", [0, 0, 300, 40], "Figure 26: the domain of a curve", { colour: "#ff0" });
    if (panel.label) panel.label.lines = "many";
    const group = box("g", [-10, -10, 400, 300], "Curve domain", { kind: "group" });
    const placed = placeLabels(list([panel], [group]), 0.3);
    expect(placed.map(({ box }) => box.id).sort()).toEqual(["g", "p"]);
    expect(placed.find(({ box }) => box.id === "g")?.at[1]).toBeLessThan(-10);
    // A scribble on the panel has no other place.
    const scribble = box("s", [0, 10, 200, 30], "a remark", { kind: "text" });
    expect(words([panel, scribble], 0.3).map(({ text }) => text)).toEqual(["a remark"]);
  });
  it("do not go beyond the end of everything, which is the end of the window when all is shown", () => {
    const group = box("g", [2900, 0, 100, 300], "The last of all outputs", { kind: "group" });
    const first = box("f", [0, 0, 100, 300], "Inputs", { kind: "group" });
    for (const zoom of [0.1, 0.3]) {
      const placed = placeLabels(list([], [first, group]), zoom);
      expect(placed).toHaveLength(2);
      for (const { lines, size, at, box: { rect } } of placed) {
        expect(at[0] + textWidth(lines[0] ?? "", size)).toBeLessThanOrEqual(3000 + 1e-6);
        expect(at[0]).toBeLessThanOrEqual(rect[0] + 6);
      }
    }
  });
  it("over a slider that is lower than they are leave a gap beside the number", () => {
    const low = box("s", [0, 0, 120, 10], "Count 10");
    low.label = { ...(low.label as NonNullable<FarBox["label"]>), short: "10" };
    expect(placeLabels(list([low]), 0.3)[0]).toMatchObject({ lines: ["10"], on: "over" });
    expect(placeLabels(list([{ ...low, rect: [0, 0, 120, 60] }]), 0.3)[0]).toMatchObject({ on: "box" });
  });
  it("of a group stand where no object is, if there is such a place", () => {
    const group = box("g", [0, 0, 400, 300], "Waves", { kind: "group" });
    const slider = box("s", [10, 10, 200, 20], "");
    slider.label = undefined;
    expect(placeLabels(list([], [group]), 0.3)[0]?.at[1]).toBeGreaterThan(0);
    expect(placeLabels(list([slider], [group]), 0.3)[0]?.at[1]).toBeLessThan(0);
  });
});
