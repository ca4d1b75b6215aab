/** Combs and osculating circles of the curves that are selected or pointed at, drawn beside the document's objects. */

import { circlePoints, circleThrough, combOf, runsOf } from "../../core/comb";
import { radius } from "../../core/bounds";
import type { Point3, Preview, PreviewPart, Rgba } from "../../core/preview";
import type { Model, ModelPart } from "../scene/model";
import type { Pick } from "./picking";

/** What tools draw has ids that no object has. */
export const TOOL = "tool:";
const COMB = `${TOOL}comb`;
const CIRCLE = `${TOOL}circle`;
/** More teeth than this are a carpet. */
const MOST_TEETH = 20_000;

export function showComb(model: Model, selection: ReadonlySet<string>, scale: number, colour: Rgba): void {
  model.drop(COMB);
  const curves = [...selection].flatMap((id) => {
    const object = model.objects.get(id);
    return (object?.parts ?? [])
      .filter(({ part }) => part.kind === "curves")
      .flatMap(({ part }) => runsOf(part.positions, part.indices))
      .map((run) => ({ run, origin: object?.preview.origin ?? ([0, 0, 0] as Point3) }));
  });
  if (curves.length === 0 || !model.bounds) return;
  // With the scale 1 a tooth is as long as its curvature: the longest gets its share of the model's size.
  const teeth = curves.map(({ run }) => combOf(run, 1));
  const longest = Math.max(...teeth.flatMap((comb) => comb.teeth.map(([foot, tip]) => length(foot, tip))), 0);
  if (!(longest > 0)) return;
  const factor = ((radius(model.bounds) || 1) * scale) / 100 / longest;
  const segments: number[] = [];
  const base = curves[0]?.origin ?? [0, 0, 0];
  for (const { run, origin } of curves) {
    if (segments.length / 6 > MOST_TEETH) break;
    const shift = origin.map((value, axis) => value - (base[axis] ?? 0)) as unknown as Point3;
    const comb = combOf(run, factor);
    for (const tooth of comb.teeth) addSegment(segments, tooth, shift);
    for (let at = 1; at < comb.tips.length; at++) {
      addSegment(segments, [comb.tips[at - 1] as Point3, comb.tips[at] as Point3], shift);
    }
  }
  put(model, COMB, segments, base, colour);
}

export function showCircle(model: Model, pick: Pick | undefined, colour: Rgba): void {
  model.drop(CIRCLE);
  const object = pick && model.objects.get(pick.object);
  if (!pick || !object || pick.part.kind !== "curves") return;
  const origin = object.preview.origin;
  const local = pick.point.map((value, axis) => value - (origin[axis] ?? 0)) as unknown as Point3;
  let nearest = Infinity;
  let found: [Point3, Point3, Point3] | undefined;
  for (const run of runsOf(pick.part.positions, pick.part.indices)) {
    for (let at = 1; at + 1 < run.length; at++) {
      const far = length(run[at] as Point3, local);
      if (far >= nearest) continue;
      nearest = far;
      found = [run[at - 1] as Point3, run[at] as Point3, run[at + 1] as Point3];
    }
  }
  const circle = found && circleThrough(...found);
  // A circle a thousand times the model is a line to the eye.
  if (!found || !circle || circle.radius > 1e3 * radius(model.bounds ?? [[0, 0, 0], [1, 1, 1]])) return;
  const points = circlePoints(circle, 128);
  const segments: number[] = [];
  for (let at = 1; at < points.length; at++) {
    addSegment(segments, [points[at - 1] as Point3, points[at] as Point3], [0, 0, 0]);
  }
  addSegment(segments, [circle.centre, found[1]], [0, 0, 0]);
  put(model, CIRCLE, segments, origin, colour);
}

function put(model: Model, id: string, segments: number[], origin: Point3, colour: Rgba): void {
  const part: PreviewPart = {
    kind: "curves", colour, width: 1, positions: Float32Array.from(segments), normals: null, colours: null,
    values: null, mean: null, indices: null, texts: [], textHeight: 0, pieces: [],
  };
  const preview: Preview = { object: id, origin, bounds: null, draft: false, parts: [part], size: 0 };
  model.put(id, preview).parts.forEach((entry: ModelPart) => model.setColour(entry, colour));
}

function addSegment(segments: number[], [from, to]: [Point3, Point3], shift: Point3): void {
  for (const point of [from, to]) point.forEach((value, axis) => segments.push(value + (shift[axis] ?? 0)));
}

function length(a: Point3, b: Point3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
