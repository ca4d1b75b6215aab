/** False colours: the numbers at the positions of every surface, and the range they are coloured over. */

import { estimateCurvatures } from "../core/curvature";
import { usefulRange } from "../core/falseColour";
import type { PreviewPart } from "../core/preview";
import type { Model } from "./scene/model";
import type { Analysis } from "./settings";

export interface Coloured {
  range: readonly [number, number];
  /** Whether all numbers are the kernel's own. */
  exact: boolean;
}

/** The curvatures of a part, found once. */
const estimated = new WeakMap<PreviewPart, { gaussian: Float32Array; mean: Float32Array }>();

/** Gives each surface its numbers; undefined where nothing has any. */
export function colourSurfaces(model: Model, analysis: Analysis): Coloured | undefined {
  const all: Float32Array[] = [];
  let exact = true;
  for (const { parts } of model.objects.values()) {
    for (const entry of parts) {
      if (entry.part.kind !== "mesh") continue;
      const found = numbersOf(entry.part, analysis);
      model.setValues(entry, found?.values ?? null);
      if (!found || model.table.get(entry.slot)[3] === 0) continue;
      all.push(found.values);
      exact &&= found.exact;
    }
  }
  const range = usefulRange(all);
  return range && { range, exact };
}

function numbersOf(part: PreviewPart, analysis: Analysis): { values: Float32Array; exact: boolean } | undefined {
  if (analysis !== "gaussian" && analysis !== "mean") return undefined;
  if (analysis === "gaussian" && part.values) return { values: part.values, exact: true };
  if (!part.normals) return undefined;
  let curvatures = estimated.get(part);
  if (!curvatures) {
    curvatures = estimateCurvatures(part.positions, part.normals, part.indices);
    estimated.set(part, curvatures);
  }
  return { values: curvatures[analysis], exact: false };
}
