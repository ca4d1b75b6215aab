/** What the solver says of each object: kept beside the document, so that a result redraws its own object alone. */

import { createStore } from "zustand/vanilla";

import type { Event } from "../core/protocol/Event";
import type { OutputView } from "../core/protocol/OutputView";
import type { ResultView } from "../core/protocol/ResultView";

export interface Run {
  results: ReadonlyMap<string, ResultView>;
  /** The data of each output by the output's id. */
  outputs: ReadonlyMap<string, OutputView>;
  solution: number;
  /** How far the solve has come, while one is running. */
  progress: { done: number; total: number; name: string } | undefined;
  /** How long the last solve took. */
  milliseconds: number;
  cancelled: boolean;
}

const EMPTY: Run = {
  results: new Map(),
  outputs: new Map(),
  solution: 0,
  progress: undefined,
  milliseconds: 0,
  cancelled: false,
};

export const runStore = createStore<Run>(() => EMPTY);

/** Takes an event that speaks of a solve; others pass by. */
export function takeRun(event: Event): void {
  if (event.event === "document") {
    runStore.setState(EMPTY);
  } else if (event.event === "solving") {
    if (event.solution < runStore.getState().solution) return;
    const { solution, done, total, name } = event;
    runStore.setState({ solution, progress: { done, total, name } });
  } else if (event.event === "results") {
    runStore.setState((run) => withResults(run, event));
  }
}

/** The run after results came. Exported for tests. */
export function withResults(run: Run, event: Extract<Event, { event: "results" }>): Run {
  if (event.solution < run.solution) return run;
  const results = new Map(run.results);
  const outputs = new Map(run.outputs);
  for (const result of event.results) {
    results.set(result.id, result);
    for (const output of result.outputs) outputs.set(output.port, output);
  }
  const rest = event.finished
    ? { progress: undefined, milliseconds: event.milliseconds, cancelled: event.cancelled }
    : {};
  return { ...run, ...rest, results, outputs, solution: event.solution };
}
