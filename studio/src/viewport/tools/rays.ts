/** Where rays through the pointer meet the planes and lines that things are dragged along. */

import { Plane, Vector3 } from "three";

import type { Point3 } from "../../core/preview";
import type { PlacedPane } from "../panes";
import { gridPlane } from "../views";

/** The ray through a place of the canvas, in model coordinates. */
function rayAt({ pane, left, top, width, height }: PlacedPane, x: number, y: number) {
  return pane.rig.ray(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2, width / height);
}

/** Where a point comes to under the pointer when it may only move along a unit direction; undefined seen along it. */
export function draggedAlong(placed: PlacedPane, from: Point3, along: Point3, x: number, y: number): Point3 | undefined {
  const { origin, direction } = rayAt(placed, x, y);
  const far = nearestAlong(new Vector3(...from), new Vector3(...along), origin, direction);
  return far === undefined ? undefined : new Vector3(...from).addScaledVector(new Vector3(...along), far).toArray();
}

/** Where a point comes to under the pointer: in the plane of the view's grid through it, or upright to that plane. */
export function dragged(placed: PlacedPane, from: Point3, x: number, y: number, upright: boolean): Point3 | undefined {
  const { origin, direction } = rayAt(placed, x, y);
  const plane = gridPlane(placed.pane.rig.pose);
  const across = new Vector3().setComponent(plane === "xy" ? 2 : plane === "xz" ? 1 : 0, 1);
  const start = new Vector3(...from);
  if (!upright) return meet(origin, direction, across, start)?.toArray();
  // Upright: in the plane through the line across that faces the eye most.
  const side = across.clone().cross(direction);
  if (side.length() < 1e-6) return undefined;
  const facing = side.cross(across).normalize();
  const met = meet(origin, direction, facing, start);
  return met && start.addScaledVector(across, met.sub(start).dot(across)).toArray();
}

/** Where the pointer meets the plane through a point, upright to a unit direction; undefined where that is seen edge on. */
export function draggedAcross(placed: PlacedPane, through: Point3, upright: Point3, x: number, y: number): Point3 | undefined {
  const { origin, direction } = rayAt(placed, x, y);
  return meet(origin, direction, new Vector3(...upright), new Vector3(...through))?.toArray();
}

function meet(origin: Vector3, direction: Vector3, normal: Vector3, through: Vector3): Vector3 | undefined {
  // A plane seen along itself is met anywhere, or nowhere.
  if (Math.abs(direction.dot(normal)) < 1e-4) return undefined;
  const plane = new Plane().setFromNormalAndCoplanarPoint(normal, through);
  const along = -plane.distanceToPoint(origin) / direction.dot(normal);
  return along > 0 ? origin.clone().addScaledVector(direction, along) : undefined;
}

/** Where a line through a point comes nearest to a ray, along its unit direction. Exported for tests. */
export function nearestAlong(from: Vector3, along: Vector3, origin: Vector3, direction: Vector3): number | undefined {
  const cosine = along.dot(direction) / direction.length();
  const squared = 1 - cosine * cosine;
  if (squared < 1e-4) return undefined;
  const off = origin.clone().sub(from);
  const unit = direction.clone().normalize();
  return (off.dot(along) - off.dot(unit) * cosine) / squared;
}
