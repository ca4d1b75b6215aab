/** Why a document shows nothing: what it lacks of a Rhino model, and what hides the rest. */

import type { ObjectView } from "./protocol/ObjectView";
import type { ResultView } from "./protocol/ResultView";

type Objects = ReadonlyMap<string, ObjectView>;
type Results = ReadonlyMap<string, ResultView>;

/** What parameters refer to in a Rhino model that is not here, by the type of geometry. */
export interface ModelNeeds {
  /** How many of each type: `Curve` 1, `Surface` 2. */
  kinds: ReadonlyMap<string, number>;
  /** The objects that refer to it. */
  objects: readonly string[];
  /** Whether a model is here and lacks them. */
  isWrongModel: boolean;
}

export function modelNeeds(objects: Objects, results: Results): ModelNeeds | undefined {
  const kinds = new Map<string, number>();
  const needing: string[] = [];
  let isWrongModel = false;
  for (const { id, lacks = [] } of results.values()) {
    if (!objects.has(id) || lacks.length === 0) continue;
    for (const { kind, objects: count, hasModel } of lacks) {
      kinds.set(kind, (kinds.get(kind) ?? 0) + Math.max(count, 1));
      isWrongModel ||= hasModel;
    }
    needing.push(id);
  }
  return needing.length > 0 ? { kinds, objects: needing, isWrongModel } : undefined;
}

export type Nothing =
  | { is: "off" }
  /** The previews of these objects are off. */
  | { is: "hidden"; objects: string[] }
  /** So many objects could show something, and have no data. */
  | { is: "null"; count: number }
  | { is: "numbers" };

/** Why nothing is seen where nothing is; undefined where there is nothing to wonder about. */
export function whyNothing(objects: Objects, previews: "all" | "selected" | "none"): Nothing | undefined {
  const all = [...objects.values()].filter(({ disabled }) => !disabled);
  const shapes = all.filter((object) => object.previews);
  if (!all.some(({ kind }) => kind === "component" || kind === "cluster" || kind === "parameter")) return undefined;
  if (shapes.length === 0) return { is: "numbers" };
  if (previews === "none") return { is: "off" };
  const hidden = shapes.filter((object) => object.hidden);
  if (hidden.length === shapes.length) return { is: "hidden", objects: hidden.map(({ id }) => id) };
  return previews === "all" ? { is: "null", count: shapes.length - hidden.length } : undefined;
}
