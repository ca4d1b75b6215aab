/** The layers of the Rhino model that are shown: their geometry, and the colours that they have in the picture. */

import type { Rgba } from "../core/preview";
import { modelStore, shownLayers, type ModelStore } from "../state/model";
import { GeometryStore } from "./geometryStore";

/** The geometry of layers by their ids. What is hidden is not fetched. */
export const layerGeometry = new GeometryStore();

let known: ReadonlySet<string> = new Set();

function follow(store: ModelStore): void {
  const shown = shownLayers(store);
  const ids = new Set(shown.map(({ id }) => id));
  const gone = [...known].filter((id) => !ids.has(id));
  known = ids;
  layerGeometry.changed([...gone.map((id): [string, null] => [id, null]), ...shown.map(({ id, geometry }): [string, string | null] => [id, geometry])], new Map());
}

modelStore.subscribe(follow);
follow(modelStore.getState());

/** The colours of all layers. The same map as long as the model is the same. */
export function layerColours({ model }: ModelStore): ReadonlyMap<string, Rgba> {
  if (!model) return NONE;
  const found = colours.get(model) ?? new Map(model.layers.map(({ id, colour }) => [id, colour]));
  colours.set(model, found);
  return found;
}

const NONE: ReadonlyMap<string, Rgba> = new Map();
const colours = new WeakMap<object, ReadonlyMap<string, Rgba>>();
