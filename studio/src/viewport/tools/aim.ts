/** What the wheel zooms about: where a ray through a pixel meets the model, else its target plane. */

import { Vector3 } from "three";

import { centre, radius } from "../../core/bounds";
import type { Viewport } from "../Viewport";

export function aim(viewport: Viewport, x: number, y: number): Vector3 {
  const { panes, model } = viewport;
  const placed = panes.at(x, y);
  const { rig } = placed.pane;
  const [u, v] = [((x - placed.left) / placed.width) * 2 - 1, 1 - ((y - placed.top) / placed.height) * 2];
  const pick = rig.pose.projection === "perspective" ? viewport.pickAt(x, y) : undefined;
  if (pick) return new Vector3(...pick.point);
  const plane = rig.onTargetPlane(u, v, placed.width / placed.height);
  const { bounds } = model;
  if (!bounds || rig.pose.projection === "parallel") return plane;
  // Beside the model, but near it: as deep as its middle, so that the wheel never gets stuck before it.
  const depth = new Vector3(...centre(bounds)).sub(rig.eye()).dot(rig.backward().negate());
  if (depth <= radius(bounds) * 0.1) return plane;
  return plane.sub(rig.eye()).multiplyScalar(depth / rig.distance()).add(rig.eye());
}
