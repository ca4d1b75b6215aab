/** The point of what is shown that is nearest to the pointer: an end, a corner, a point of its own. */

import { Matrix4 } from "three";

import type { Point3 } from "../../core/preview";
import { dot } from "../../core/section";
import { isBefore, nearestVertex, type SeenVertex } from "../../core/vertices";
import type { Model } from "../scene/model";
import { isOfDocument } from "./beside";
import type { PickView } from "./picking";

/** The nearest within so many pixels of a place of the pane. */
export function vertexAt(model: Model, { camera, width, height }: PickView, x: number, y: number, reach: number): Point3 | undefined {
  const view = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  let best: { seen: SeenVertex; point: Point3 } | undefined;
  for (const { id, preview, parts } of model.objects.values()) {
    if (!isOfDocument(id)) continue;
    const [ox, oy, oz] = preview.origin;
    const [dx, dy, dz] = [ox - model.origin[0], oy - model.origin[1], oz - model.origin[2]];
    const project = view.clone().multiply(new Matrix4().makeTranslation(dx, dy, dz)).elements;
    for (const { part, slot } of parts) {
      if (part.kind === "texts" || model.table.get(slot)[3] === 0) continue;
      const seen = nearestVertex(part.positions, project, [width, height], [x, y], reach);
      if (!seen || (best && !isBefore(seen, best.seen))) continue;
      const at = (axis: number) => part.positions[seen.index * 3 + axis] ?? 0;
      const point: Point3 = [ox + at(0), oy + at(1), oz + at(2)];
      const { section } = model;
      if (!section || dot(point, section.normal) <= section.at) best = { seen, point };
    }
  }
  return best?.point;
}
