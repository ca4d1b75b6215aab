import { describe, expect, it } from "vitest";

import { circleThrough, combOf, runsOf } from "../../src/core/comb";
import { estimateCurvatures } from "../../src/core/curvature";
import type { Point3 } from "../../src/core/preview";
import { sphere, surface, torus } from "./shapes";

describe("curvatures of meshes", () => {
  it("of a sphere are 1/r² and 1/r", () => {
    const { positions, normals, indices } = sphere(5, 48, 24);
    const { gaussian, mean } = estimateCurvatures(positions, normals, indices);
    for (const value of gaussian) expect(value).toBeCloseTo(1 / 25, 3);
    for (const value of mean) expect(value).toBeCloseTo(1 / 5, 3);
  });

  it("of a torus are the closed forms", () => {
    const [major, minor, columns, rows] = [10, 3, 160, 96];
    const { positions, normals, indices } = torus(major, minor, columns, rows);
    const { gaussian, mean } = estimateCurvatures(positions, normals, indices);
    for (let row = 0; row <= rows; row++) {
      const cosine = Math.cos((row / rows) * 2 * Math.PI);
      const around = cosine / (major + minor * cosine);
      const vertex = row * (columns + 1) + 40;
      expect(gaussian[vertex]).toBeCloseTo(around / minor, 2.6);
      expect(mean[vertex]).toBeCloseTo((around + 1 / minor) / 2, 2.6);
    }
  });

  it("of a saddle are negative, of a plane nothing, and of bytes for normals nearly the same", () => {
    const saddle = surface(40, 40, (u, v) => {
      const [x, y] = [u - 0.5, v - 0.5];
      const length = Math.hypot(2 * x, 2 * y, 1);
      return { point: [x, y, x * x - y * y], normal: [(-2 * x) / length, (2 * y) / length, 1 / length] };
    });
    const middle = 20 * 41 + 20;
    const { gaussian, mean } = estimateCurvatures(saddle.positions, saddle.normals, saddle.indices);
    expect(gaussian[middle]).toBeCloseTo(-4, 1);
    expect(mean[middle]).toBeCloseTo(0, 2);
    const flat = surface(4, 4, (u, v) => ({ point: [u, v, 0], normal: [0, 0, 1] }));
    const none = estimateCurvatures(flat.positions, Int8Array.from(flat.normals, (value) => value * 127), flat.indices);
    expect(none.gaussian.every((value) => Math.abs(value) < 1e-9)).toBe(true);
  });

  it("are numbers where triangles have no area, no normals or the wrong winding", () => {
    const positions = Float32Array.from([0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0]);
    const normals = new Float32Array(18);
    const { gaussian, mean } = estimateCurvatures(positions, normals, null);
    expect([...gaussian, ...mean].every(Number.isFinite)).toBe(true);
    const { positions: p, normals: n, indices } = sphere(1, 24, 12);
    const other = estimateCurvatures(p, n, indices.slice().reverse());
    expect([...other.gaussian].every((value) => Math.abs(value - 1) < 0.05)).toBe(true);
  });
});

describe("how curves bend", () => {
  const helix = (count: number): Point3[] =>
    Array.from({ length: count + 1 }, (_, at) => {
      const angle = (at / count) * 4 * Math.PI;
      return [2 * Math.cos(angle), 2 * Math.sin(angle), angle];
    });

  it("a circle through three points is the circle, however they are spaced", () => {
    const on = (angle: number): Point3 => [3 + 2 * Math.cos(angle), 4 + 2 * Math.sin(angle), 7];
    const circle = circleThrough(on(0), on(0.1), on(1.9));
    expect(circle?.radius).toBeCloseTo(2, 10);
    circle?.centre.forEach((value, axis) => expect(value).toBeCloseTo([3, 4, 7][axis] ?? 0, 10));
  });

  it("a comb of a helix is as long as its curvature a/(a²+b²) and points away from the axis", () => {
    const { teeth } = combOf(helix(400), 5);
    const [foot, tip] = teeth[200] as [Point3, Point3];
    expect(Math.hypot(tip[0] - foot[0], tip[1] - foot[1], tip[2] - foot[2])).toBeCloseTo((5 * 2) / 5, 3);
    expect(Math.hypot(tip[0], tip[1])).toBeGreaterThan(Math.hypot(foot[0], foot[1]));
  });

  it("a line has no circle, and a comb without length", () => {
    expect(circleThrough([0, 0, 0], [1, 1, 1], [2, 2, 2])).toBeUndefined();
    expect(circleThrough([0, 0, 0], [0, 0, 0], [0, 0, 0])).toBeUndefined();
    const { teeth } = combOf([[0, 0, 0], [1, 0, 0], [2, 0, 0]], 10);
    expect(teeth).toEqual([[[1, 0, 0], [1, 0, 0]]]);
  });

  it("segments that follow each other are one run", () => {
    const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5, 6, 6, 6]);
    expect(runsOf(positions, null).map((run) => run.length)).toEqual([3, 2]);
    const shared = Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]);
    expect(runsOf(shared, Uint16Array.from([0, 1, 1, 2])).map((run) => run.length)).toEqual([3]);
  });
});
