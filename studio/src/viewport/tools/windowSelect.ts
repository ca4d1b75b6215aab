/** Which objects a window holds: all of each from left to right, any of each from right to left, as in Rhino. */

import { Matrix4 } from "three";

import { holds, segmentTouches, triangleTouches, type Rectangle } from "../../core/screen";
import type { Point3 } from "../../core/preview";
import type { Model, ModelPart } from "../scene/model";
import type { PickView } from "./picking";

export function inWindow(model: Model, view: PickView, box: Rectangle, crossing: boolean): string[] {
  const found: string[] = [];
  for (const { id, parts, preview } of model.objects.values()) {
    const shown = parts.filter(({ slot }) => model.table.get(slot)[3] > 0);
    if (shown.length === 0) continue;
    const test = (entry: ModelPart) => partInWindow(entry, preview.origin, model.origin, view, box, crossing);
    if (crossing ? shown.some(test) : shown.every(test)) found.push(id);
  }
  return found;
}

function partInWindow(
  { part }: ModelPart, origin: Point3, base: Point3, { camera, width, height }: PickView, box: Rectangle, crossing: boolean,
): boolean {
  const e = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
    .multiply(new Matrix4().makeTranslation(origin[0] - base[0], origin[1] - base[1], origin[2] - base[2])).elements;
  const { positions, indices, kind } = part;
  const count = positions.length / 3;
  const places = new Float64Array(count * 2);
  for (let at = 0; at < count; at++) {
    const [x, y, z] = [positions[at * 3]!, positions[at * 3 + 1]!, positions[at * 3 + 2]!];
    const w = e[3]! * x + e[7]! * y + e[11]! * z + e[15]!;
    // Behind the eye nothing is in a window: NaN compares with nothing.
    const u = w > 0 ? ((e[0]! * x + e[4]! * y + e[8]! * z + e[12]!) / w + 1) * 0.5 * width : NaN;
    const v = w > 0 ? (1 - (e[1]! * x + e[5]! * y + e[9]! * z + e[13]!) / w) * 0.5 * height : NaN;
    places[at * 2] = u;
    places[at * 2 + 1] = v;
    const isInside = holds(box, u, v);
    if (isInside && crossing) return true;
    if (!isInside && !crossing) return false;
  }
  if (!crossing) return true;
  const corners = kind === "mesh" ? 3 : kind === "points" || kind === "controlPoints" || kind === "texts" ? 1 : 2;
  if (corners === 1) return false;
  const used = indices?.length ?? count;
  for (let at = 0; at + corners <= used; at += corners) {
    const [a, b] = [(indices ? indices[at]! : at) * 2, (indices ? indices[at + 1]! : at + 1) * 2];
    const [ax, ay, bx, by] = [places[a]!, places[a + 1]!, places[b]!, places[b + 1]!];
    if (corners === 2) {
      if (segmentTouches(box, ax, ay, bx, by)) return true;
      continue;
    }
    const c = (indices ? indices[at + 2]! : at + 2) * 2;
    if (triangleTouches(box, ax, ay, bx, by, places[c]!, places[c + 1]!)) return true;
  }
  return false;
}
