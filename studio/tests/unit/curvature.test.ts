import { describe, expect, it } from "vitest";

import { circlePoints } from "../../src/core/circle";
import { estimateCurvatures, principal } from "../../src/core/curvature";
import type { Point3 } from "../../src/core/preview";
import { sphere, surface, torus } from "./shapes";

describe("curvatures of meshes", () => {
  it("of a sphere are 1/r² and, seen from outside, −1/r", () => {
    const { positions, normals, indices } = sphere(5, 48, 24);
    const { gaussian, mean } = estimateCurvatures(positions, normals, indices);
    for (const value of gaussian) expect(value).toBeCloseTo(1 / 25, 3);
    for (const value of mean) expect(value).toBeCloseTo(-1 / 5, 3);
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
      expect(mean[vertex]).toBeCloseTo(-(around + 1 / minor) / 2, 2.6);
      const [greater, lesser] = [-around, -1 / minor];
      expect(principal({ gaussian, mean }, "greater")[vertex]).toBeCloseTo(greater, 1.9);
      expect(principal({ gaussian, mean }, "lesser")[vertex]).toBeCloseTo(lesser, 1.9);
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

describe("circles", () => {
  it("go once around their centre, from where they touch", () => {
    const points = circlePoints({ centre: [3, 4, 7], radius: 2, x: [0, 1, 0], y: [0, 0, 1] }, 60);
    expect(points[0]).toEqual([3, 6, 7]);
    for (const point of points) expect(Math.hypot(point[0] - 3, point[1] - 4, point[2] - 7)).toBeCloseTo(2, 12);
    points.at(-1)?.forEach((value: number, axis: number) => expect(value).toBeCloseTo((points[0] as Point3)[axis] ?? 0, 12));
  });
});
