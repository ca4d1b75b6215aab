/** What the session found where the viewport looks closely: in numbers; what is drawn of it is geometry like all other. */

import { createStore } from "zustand/vanilla";

import type { CombMeasure } from "../core/protocol/CombMeasure";
import type { Event } from "../core/protocol/Event";
import type { Probed } from "../core/protocol/Probed";

export interface Findings {
  comb: CombMeasure | null;
  /** What there was too much of. */
  leftOut: readonly string[];
  /** The answers to the round of questions with this number. */
  round: number;
  probes: readonly (Probed | null)[];
}

const NOTHING: Findings = { comb: null, leftOut: [], round: 0, probes: [] };

export const analysisStore = createStore<Findings>(() => NOTHING);

/** Takes an event that speaks of an analysis; others pass by. */
export function takeAnalysis(event: Event): void {
  if (event.event === "document") analysisStore.setState(NOTHING);
  else if (event.event === "analysed") analysisStore.setState({ comb: event.comb, leftOut: event.leftOut });
  else if (event.event === "probed") analysisStore.setState({ round: event.round, probes: event.probes });
}
