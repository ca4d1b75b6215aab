/** The components that can be placed. They do not change while the server runs. */

import { engine } from "#engine";
import { createStore } from "zustand/vanilla";

import type { CatalogueEntry } from "../core/catalogue";

export interface Catalogue {
  entries: readonly CatalogueEntry[];
  byId: ReadonlyMap<string, CatalogueEntry>;
  state: "none" | "asked" | "here" | "failed";
}

export const catalogueStore = createStore<Catalogue>(() => ({ entries: [], byId: new Map(), state: "none" }));

/** Fetches the catalogue, once. */
export async function loadCatalogue(): Promise<void> {
  const { state } = catalogueStore.getState();
  if (state === "asked" || state === "here") return;
  catalogueStore.setState({ state: "asked" });
  try {
    if (engine) return takeCatalogue(await engine.components());
    const answer = await fetch("api/components");
    if (!answer.ok) throw new Error(String(answer.status));
    takeCatalogue((await answer.json()) as CatalogueEntry[]);
  } catch {
    catalogueStore.setState({ state: "failed" });
  }
}

export function takeCatalogue(entries: readonly CatalogueEntry[]): void {
  const byId = new Map(entries.map((entry) => [entry.guid, entry]));
  catalogueStore.setState({ entries, byId, state: "here" });
}
