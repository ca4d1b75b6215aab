/** The Rhino model beside the document, and which of its layers this face shows. */

import { createStore } from "zustand/vanilla";

import type { Event } from "../core/protocol/Event";
import type { ModelLayerView } from "../core/protocol/ModelLayerView";
import type { ModelObjectView } from "../core/protocol/ModelObjectView";
import type { ModelView } from "../core/protocol/ModelView";

export interface ModelStore {
  model: ModelView | undefined;
  isOn: boolean;
  /** The layers that somebody showed or hid here, by their ids; the others are as the model has them. */
  turned: ReadonlyMap<string, boolean>;
}

const NONE: ModelStore = { model: undefined, isOn: true, turned: new Map() };

export const modelStore = createStore<ModelStore>(() => NONE);

/** Takes an event that speaks of the model; others pass by. */
export function takeModel(event: Event): void {
  if (event.event !== "model") return;
  const model = event.model ?? undefined;
  const isSame = (now: ModelStore) => now.model?.name === model?.name && now.model?.layers.length === model?.layers.length;
  // Another model has other layers.
  modelStore.setState((now) => ({ model, turned: isSame(now) ? now.turned : NONE.turned }));
}

export function isLayerOn({ turned }: Pick<ModelStore, "turned">, { id, hidden }: ModelLayerView): boolean {
  return turned.get(id) ?? !hidden;
}

export function turnLayers(layers: readonly ModelLayerView[], isOn: boolean): void {
  modelStore.setState(({ turned }) => ({ turned: new Map([...turned, ...layers.map(({ id }) => [id, isOn] as const)]) }));
}

/** The layers that are shown. */
export function shownLayers(store: ModelStore): ModelLayerView[] {
  return store.isOn ? (store.model?.layers.filter((layer) => isLayerOn(store, layer)) ?? []) : [];
}

/** The object of a layer that an item of its geometry is. */
export function objectOf(layer: string, index: number): ModelObjectView | undefined {
  return modelStore.getState().model?.layers.find(({ id }) => id === layer)?.objects[index];
}
