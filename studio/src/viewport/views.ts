/** The views that have names, and how panes share the canvas. */

import { CameraRig, USUAL_HEIGHT, wrap, type Pose } from "./camera";

export type ViewName = "perspective" | "top" | "bottom" | "front" | "back" | "left" | "right";

const QUARTER = Math.PI / 2;

/** Which way each looks: Front looks along +y with x to the right, as in Rhino. */
const DIRECTIONS: Record<ViewName, { azimuth: number; elevation: number }> = {
  perspective: { azimuth: -QUARTER - Math.PI / 6, elevation: Math.PI / 6 },
  top: { azimuth: -QUARTER, elevation: QUARTER },
  bottom: { azimuth: -QUARTER, elevation: -QUARTER },
  front: { azimuth: -QUARTER, elevation: 0 },
  back: { azimuth: QUARTER, elevation: 0 },
  left: { azimuth: Math.PI, elevation: 0 },
  right: { azimuth: 0, elevation: 0 },
};

export const VIEW_NAMES = Object.keys(DIRECTIONS) as ViewName[];

export function poseOf(view: ViewName, like?: Pose): Pose {
  const { azimuth, elevation } = DIRECTIONS[view];
  const projection = view === "perspective" ? "perspective" : "parallel";
  return { target: like?.target ?? [0, 0, 0], height: like?.height ?? USUAL_HEIGHT, azimuth, elevation, projection };
}

/** The planes that grids lie in: that of the view where it looks along an axis, else the ground. */
export type GridPlane = "xy" | "xz" | "yz";

export function gridPlane({ azimuth, elevation, projection }: Pose): GridPlane {
  if (projection !== "parallel" || Math.abs(elevation) > 1e-6) return "xy";
  const quarters = azimuth / QUARTER;
  if (Math.abs(quarters - Math.round(quarters)) > 1e-6) return "xy";
  return Math.round(quarters) % 2 === 0 ? "yz" : "xz";
}

/** The name of the view that a pose is turned to, if any. */
export function viewOf(pose: Pose): ViewName | undefined {
  const level = Math.abs(Math.abs(pose.elevation) - QUARTER) < 1e-6 ? "any" : pose.azimuth;
  return VIEW_NAMES.find((name) => {
    const { azimuth, elevation } = DIRECTIONS[name];
    if (name === "perspective" || Math.abs(elevation - pose.elevation) > 1e-6) return false;
    return level === "any" || Math.abs(wrap(azimuth - level)) < 1e-6;
  });
}

/** A part of the canvas, in fractions of it from the top left, with its own camera. */
export interface Pane {
  title: ViewName;
  rig: CameraRig;
  left: number;
  top: number;
  width: number;
  height: number;
}

export type Layout = "one" | "four";

/** Rhino's four views: Top and Perspective above, Front and Right below. */
export function fourPanes(rigs: Record<"top" | "perspective" | "front" | "right", CameraRig>): Pane[] {
  const half = { width: 0.5, height: 0.5 };
  return [
    { title: "top", rig: rigs.top, left: 0, top: 0, ...half },
    { title: "perspective", rig: rigs.perspective, left: 0.5, top: 0, ...half },
    { title: "front", rig: rigs.front, left: 0, top: 0.5, ...half },
    { title: "right", rig: rigs.right, left: 0.5, top: 0.5, ...half },
  ];
}
