import { Vector3 } from "three";
import { describe, expect, it } from "vitest";

import { cornersOf } from "../../src/core/bounds";
import type { Bounds, Point3 } from "../../src/core/preview";
import { CameraRig, USUAL_HEIGHT, type Pose } from "../../src/viewport/camera";
import { VIEW_NAMES, gridPlane, poseOf, viewOf } from "../../src/viewport/views";

const BOX: Bounds = [[10, 20, 0], [14, 22, 8]];

/** Where a point is in the view, −1 to 1. */
function seen(rig: CameraRig, point: Point3, aspect = 1.5, origin: Point3 = [0, 0, 0], bounds: Bounds | null = BOX): Vector3 {
  return new Vector3(point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]).project(
    rig.camera(origin, bounds, aspect),
  );
}

describe("the camera", () => {
  it.each(VIEW_NAMES)("shows all of a box from %s after zoom extents, and fills the view", (name) => {
    const rig = new CameraRig(poseOf(name));
    rig.fit([BOX], 1.5);
    const places = cornersOf(BOX).map((corner) => seen(rig, corner));
    for (const { x, y, z } of places) {
      expect(Math.max(Math.abs(x), Math.abs(y), Math.abs(z))).toBeLessThanOrEqual(1);
    }
    expect(Math.max(...places.map(({ x, y }) => Math.max(Math.abs(x), Math.abs(y))))).toBeCloseTo(1 / 1.1, 1);
  });

  it("shows a point alone in a view of the usual size, near the origin and far from it", () => {
    for (const at of [[0, 0, 0], [5, 5, 0], [4e6, -3e6, 12]] as Point3[]) {
      const rig = new CameraRig(poseOf("perspective"));
      rig.fit([[at, at]], 1.5);
      expect(rig.pose.height).toBe(USUAL_HEIGHT);
      expect(rig.pose.target).toEqual(at);
    }
  });

  it("draws a point alone also a little before where it is, as points and lines are drawn", () => {
    const rig = new CameraRig(poseOf("perspective"));
    const at: Point3 = [5, 5, 0];
    rig.fit([[at, at]], 1.5);
    const before = new Vector3(...at).lerp(rig.eye(), 0.003).toArray();
    expect(Math.abs(seen(rig, before, 1.5, [0, 0, 0], [at, at]).z)).toBeLessThan(1);
  });

  it("knows when what is shown is framed: not when it grew out of the view or shrank to a speck", () => {
    const scaled = (by: number): Bounds => [BOX[0], BOX[1].map((high, axis) => BOX[0][axis as 0] + (high - BOX[0][axis as 0]) * by) as unknown as Point3];
    for (const name of VIEW_NAMES) {
      const rig = new CameraRig(poseOf(name));
      rig.fit([BOX], 1.5);
      expect(rig.frames([BOX], 1.5)).toBe(true);
      expect(rig.frames([scaled(0.8)], 1.5)).toBe(true);
      expect(rig.frames([scaled(1.6)], 1.5)).toBe(false);
      expect(rig.frames([scaled(0.1)], 1.5)).toBe(false);
    }
  });

  it("looks as Rhino does: x to the right in Top and Front, y to the right in Right, z up", () => {
    const right = (name: "top" | "front" | "right") => new CameraRig(poseOf(name)).right().toArray();
    const up = (name: "top" | "front" | "right") => new CameraRig(poseOf(name)).up().toArray();
    const near = (got: number[], expected: number[]) => got.forEach((v, at) => expect(v).toBeCloseTo(expected[at] ?? 0, 12));
    near(right("top"), [1, 0, 0]);
    near(up("top"), [0, 1, 0]);
    near(right("front"), [1, 0, 0]);
    near(up("front"), [0, 0, 1]);
    near(right("right"), [0, 1, 0]);
    near(up("right"), [0, 0, 1]);
  });

  it.each(["perspective", "parallel"] as const)("keeps the place under the pointer while it zooms (%s)", (projection) => {
    const pose: Pose = { ...poseOf("perspective"), projection, height: 40, target: [12, 21, 4] };
    const rig = new CameraRig(pose);
    const point: Point3 = [13, 21.5, 7];
    const before = seen(rig, point);
    rig.zoomAbout(new Vector3(...point), 0.4);
    const after = seen(rig, point);
    expect(after.x).toBeCloseTo(before.x, 9);
    expect(after.y).toBeCloseTo(before.y, 9);
  });

  it.each(["perspective", "parallel"] as const)("pans by whole pixels at the target (%s)", (projection) => {
    const rig = new CameraRig({ ...poseOf("perspective"), projection, target: [12, 21, 4], height: 30 });
    rig.pan(40, -25, 400);
    const { x, y } = seen(rig, [12, 21, 4], 2);
    expect(x).toBeCloseTo(40 / 400, 9);
    expect(y).toBeCloseTo(25 / 200, 9);
  });

  it.each(["perspective", "parallel"] as const)("sends rays through the place they are asked for (%s)", (projection) => {
    const rig = new CameraRig({ ...poseOf("perspective"), projection, target: [12, 21, 4], height: 30 });
    const { origin, direction } = rig.ray(0.3, -0.7, 1.5);
    const point = origin.addScaledVector(direction, rig.distance() * (projection === "parallel" ? 100 : 1));
    const { x, y } = seen(rig, point.toArray());
    expect(x).toBeCloseTo(0.3, 6);
    expect(y).toBeCloseTo(-0.7, 6);
  });

  it("does not turn over the poles and stays sharp far away from the origin", () => {
    const rig = new CameraRig(poseOf("perspective"));
    rig.orbit(0, 10);
    expect(rig.pose.elevation).toBe(Math.PI / 2);
    const far: Bounds = [[1e8, 1e8, 0], [1e8 + 1, 1e8 + 1, 1]];
    rig.fit([far], 1);
    const origin: Point3 = [1e8, 1e8, 0];
    const [a, b] = [seen(rig, [1e8, 1e8, 0], 1, origin, far), seen(rig, [1e8 + 1e-3, 1e8, 0], 1, origin, far)];
    expect(Math.abs(a.x - b.x)).toBeGreaterThan(1e-4);
  });

  it("fits a single point, and sees it", () => {
    const rig = new CameraRig(poseOf("perspective"));
    const point: Bounds = [[5, 5, 5], [5, 5, 5]];
    rig.fit([point], 1);
    const { x, y, z } = seen(rig, [5, 5, 5], 1, [5, 5, 5], point);
    expect([x, y].every((value) => Math.abs(value) < 1e-6) && Math.abs(z) <= 1).toBe(true);
  });
});

describe("views", () => {
  it("are known by their names, and have grids in their planes", () => {
    for (const name of VIEW_NAMES) if (name !== "perspective") expect(viewOf(poseOf(name))).toBe(name);
    expect(viewOf(poseOf("perspective"))).toBeUndefined();
    expect(VIEW_NAMES.map((name) => gridPlane(poseOf(name)))).toEqual(["xy", "xy", "xy", "xz", "xz", "yz", "yz"]);
  });
});
