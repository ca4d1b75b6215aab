import { expect, test } from "vitest";

import { alike, inOrder } from "../../src/core/alike";
import type { Grip } from "../../src/core/hit";
import type { PortView } from "../../src/core/protocol/PortView";
import { component, control } from "../page/make";

const slider = () => control("Number Slider", [0, 0, 180, 20], { is: "slider", value: 1, min: 0, max: 10, rounding: "float", digits: 2, expression: null });
const circle = () => component("Circle CNR", "Circle", [0, 0], ["Center: Point", "Normal: Vector", "Radius: Number"], ["Circle: Curve"]);
const cone = () => component("Cone", "Cone", [0, 0], ["Base: Plane", "Radius: Number", "Length: Number"], ["Cone: Surface", "Tip: Point"]);
const at = (ports: readonly PortView[], k: number) => ports[k] as PortView;

test("ports of one name go along, and the only one that there is", () => {
  const [a, b] = [circle(), cone()];
  expect(alike(a, at(a.inputs, 2), b, "input")?.name).toBe("Radius");
  expect(alike(a, at(a.inputs, 0), b, "input")).toBeUndefined();
  const [s, r] = [slider(), slider()];
  expect(alike(s, at(s.outputs, 0), r, "output")?.id).toBe(r.id);
  expect(alike(b, at(b.outputs, 1), a, "output")?.name).toBe("Circle");
});

test("an input that does not take what the first one takes does not go along", () => {
  const [a, flat] = [circle(), component("Area", "Area", [0, 0], ["Geometry: Geometry"], ["Area: Number", "Centroid: Point"])];
  expect(alike(a, at(a.inputs, 2), flat, "input")).toBeUndefined();
  expect(alike(a, at(a.inputs, 0), flat, "input")?.name).toBe("Geometry");
});

test("ports of one place go along where a component stands twice and its ports were named anew", () => {
  const [a, b] = [circle(), circle()];
  at(b.inputs, 2).name = "R";
  b.component = a.component;
  expect(alike(a, at(a.inputs, 2), b, "input")?.name).toBe("R");
});

test("wires that are drawn at once are read from top to bottom", () => {
  const grip = (port: string, x: number, y: number): Grip => ({ port, object: port, side: "output", at: [x, y] });
  expect(inOrder([grip("c", 0, 30), grip("b", 9, 20), grip("a", 4, 20)]).map(({ port }) => port)).toEqual(["a", "b", "c"]);
});
