/** What is known of the study, and what the person chose. */

import { useStore } from "zustand";
import { createStore } from "zustand/vanilla";

import type { Axis } from "./core/axes";
import { type Brushes, type Range, withBrush } from "./core/brushes";
import type { Sort } from "./core/order";
import { type Answer, type Goal, merged, type Study } from "./core/rows";

export interface Chosen {
  study: Study | undefined;
  /** Why nothing can be asked of the server. */
  lost: string | undefined;
  brushes: Brushes;
  /** Keys of axes; what is usual where none is chosen. */
  x: string | undefined;
  y: string | undefined;
  /** Empty for one colour. */
  colour: string | undefined;
  bars: string | undefined;
  /** What is to be small or large, by the keys of axes; the study's own where nothing was chosen. */
  goals: ReadonlyMap<string, Goal> | undefined;
  /** The point that is looked at. */
  point: number | undefined;
  sort: Sort;
}

export const store = createStore<Chosen>(() => ({
  study: undefined,
  lost: undefined,
  brushes: new Map(),
  x: undefined,
  y: undefined,
  colour: undefined,
  bars: undefined,
  goals: undefined,
  point: undefined,
  sort: { by: "point", descending: false },
}));

export const set = (changes: Partial<Chosen>) => store.setState(changes);

export const useChosen = <T>(pick: (chosen: Chosen) => T): T => useStore(store, pick);

export function receive(answer: Answer): void {
  const study = merged(store.getState().study, answer);
  store.setState({ study, lost: undefined });
}

export function brush(axis: Axis, range: Range | undefined): void {
  store.setState(({ brushes }) => ({ brushes: withBrush(brushes, axis, range) }));
}

export const clearBrushes = () => set({ brushes: new Map() });

/** Looks at a point; at none where it is looked at already. */
export function look(point: number): void {
  store.setState((chosen) => ({ point: chosen.point === point ? undefined : point }));
}
