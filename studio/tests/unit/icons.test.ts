import { readFileSync } from "node:fs";
import { expect, test } from "vitest";

import { drawingOf, pictureOf } from "../../src/icons";
import { layers, place, turn, flip, ink, type Drawing } from "../../src/icons/piece";
import { line, part, path, pointOf, type Cubic } from "../../src/icons/lines";
import { word } from "../../src/icons/letters";
import { listed } from "../../icons/components";
import { sheet } from "../../icons/sheet";

const components = listed();
const current = components.filter(({ old }) => !old);
const pictured = (one: (typeof components)[number]) => drawingOf(one.id, one.name, one);
const label = ({ tab, panel, name }: (typeof components)[number]) => `${tab} / ${panel} / ${name}`;
const written = (drawing: Drawing) => JSON.stringify(layers(drawing));

test("the pages of help list the components", () => {
  expect(current.length).toBeGreaterThan(800);
  expect(components.length - current.length).toBeGreaterThan(40);
  expect(new Set(components.map(({ id }) => id)).size).toBe(components.length);
});

test("every component has a picture of its own", () => {
  expect(components.filter((one) => !pictured(one)).map(label)).toEqual([]);
});

test("no picture is the same as another in its tab", () => {
  const seen = new Map<string, string>();
  const twice: string[] = [];
  for (const one of current) {
    const drawing = pictured(one);
    if (!drawing) continue;
    const key = `${one.tab} ${written(drawing)}`;
    const other = seen.get(key);
    if (other !== undefined) twice.push(`${other} = ${label(one)}`);
    seen.set(key, label(one));
  }
  expect(twice).toEqual([]);
});

test("nothing is drawn outside of a picture", () => {
  const outside: string[] = [];
  for (const one of components) {
    for (const [, d] of layers(pictured(one) ?? [])) {
      const numbers = ends(d);
      if (numbers.some(([x, y]) => !(x >= -0.5 && x <= 24.5 && y >= -0.5 && y <= 24.5))) outside.push(`${label(one)}: ${d}`);
    }
  }
  expect(outside).toEqual([]);
});

/** Where the pieces of a path end. */
function ends(d: string): [number, number][] {
  let y = 0;
  let x = 0;
  return [...d.matchAll(/([A-Z])([^A-Z]*)/g)].flatMap(([, command = "", rest = ""]): [number, number][] => {
    const numbers = (rest.match(/-?\d*\.?\d+/g) ?? []).map(Number);
    if (command === "Z") return [];
    if (command === "H") x = numbers.at(-1) ?? x;
    else if (command === "V") y = numbers.at(-1) ?? y;
    else [x = 0, y = 0] = numbers.slice(-2);
    return [[x, y]];
  });
}

test("old components have the picture of the new ones with a folded corner", () => {
  const of = (old: boolean) => drawingOf("ffffffff", old ? "Line [OBSOLETE]" : "Line", { tab: "Curve", panel: "Primitive", old });
  expect(layers(of(true) ?? []).map(([tone]) => tone)).toContain("hotFill");
  expect(written(of(true) ?? [])).not.toBe(written(of(false) ?? []));
});

test("what is not in the tabs has the picture of its name, or the one for what is not known", () => {
  const unknown = pictureOf("x", "Kangaroo solver of an add-on", undefined);
  expect(pictureOf("x", "Scribble", undefined)).not.toEqual(unknown);
  expect(pictureOf("x", "Divide Curve", undefined)).toEqual(pictureOf("y", "Divide Curve", { tab: "Curve", panel: "Division", old: false }));
});

test("paths are moved, scaled, turned and flipped", () => {
  expect(layers(place(ink("M0 0H4V2Z"), 10, 5, 2))).toEqual([["ink", "M10 5L18 5L18 9Z"]]);
  expect(layers(turn(ink("M12 2A3 3 0 0 1 15 5"), 90))).toEqual([["ink", "M22 12A3 3 0 0 1 19 15"]]);
  expect(layers(flip(ink("M2 2A3 3 0 0 1 5 5")))).toEqual([["ink", "M22 2A3 3 0 0 0 19 5"]]);
});

test("a part of a curve lies on it", () => {
  const curve: Cubic = [[0, 0], [10, 0], [0, 20], [20, 20]];
  const [start, , , end] = part(curve, 0.25, 0.75);
  expect(start[0]).toBeCloseTo(pointOf(curve, 0.25)[0]);
  expect(end[1]).toBeCloseTo(pointOf(curve, 0.75)[1]);
  expect(path(curve)).toBe("M0 0C10 0 0 20 20 20");
});

test("words stand about their middle", () => {
  const xs = layers(word("HH", 12, 12, 6)).flatMap(([, d]) => ends(d).map(([x]) => x));
  expect((Math.min(...xs) + Math.max(...xs)) / 2).toBeCloseTo(12, 1);
  expect(line(1, 2, 3.333, 4)).toBe("M1 2L3.35 4");
});

test("the sheet in the documents is up to date: npm run icons", () => {
  for (const [name, text] of sheet()) {
    const written = readFileSync(new URL(`../../../docs/${name}`, import.meta.url), "utf8");
    expect(written === text, name).toBe(true);
  }
});
