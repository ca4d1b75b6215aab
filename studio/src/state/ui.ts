/** What this face alone knows: what is selected, pointed at, and how things are looked at. */

import { createStore } from "zustand/vanilla";

export interface Ui {
  /** The ids of the selected objects. */
  selection: ReadonlySet<string>;
  /** The object under the pointer, on the canvas or in the viewport. */
  hovered: string | undefined;
  /** Full names or nicknames on capsules. */
  fullNames: boolean;
  /** Milliseconds below each capsule. */
  profiler: boolean;
}

export const uiStore = createStore<Ui>(() => ({
  selection: new Set(),
  hovered: undefined,
  fullNames: false,
  profiler: false,
}));

export function select(ids: Iterable<string>): void {
  uiStore.setState({ selection: new Set(ids) });
}
