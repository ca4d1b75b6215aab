/** What moves a result, and what was found for a wanted one, as this page knows it. */

import { createStore } from "zustand/vanilla";

import type { EffectsView } from "../core/protocol/EffectsView";
import type { InputPlace } from "../core/protocol/InputPlace";
import type { MotionView } from "../core/protocol/MotionView";
import type { Solved } from "../core/protocol/Solved";
import type { Target } from "../core/protocol/Target";
import { documentStore } from "./document";
import { ask, newGesture } from "./session";

export interface Study {
  /** The output that is looked at. */
  target: string | undefined;
  effects: EffectsView | undefined;
  /** Of which output and which solve the effects are. */
  of: { target: string; revision: number } | undefined;
  /** What is being looked for. */
  busy: "here" | "ranges" | "wanted" | undefined;
  refused: string | undefined;
  /** Inputs that are not to move for a wanted result, by their keys. */
  fixed: ReadonlySet<string>;
  solved: Solved | undefined;
  /** How places move with an input. */
  motion: { input: string; view: MotionView } | undefined;
  /** Whether computed points have handles in the view. */
  drags: boolean;
}

const EMPTY: Study = {
  target: undefined, effects: undefined, of: undefined, busy: undefined, refused: undefined, fixed: new Set(), solved: undefined,
  motion: undefined, drags: false,
};

export const studyStore = createStore<Study>(() => EMPTY);

/** What tells an input from all others. */
export function keyOf({ within, object, gene }: InputPlace): string {
  const path = [...within, object].join("/");
  return gene === null ? path : `${path}.${gene}`;
}

/** What is asked for of an output: it is in the document or the cluster that the page shows. */
export function targetOf(output: string, item: Target["item"] = null): Target {
  return { within: [...documentStore.getState().within], output, item };
}

/** Looks at another output. */
export function look(target: string | undefined): void {
  if (studyStore.getState().target === target) return;
  void ask({ ask: "endStudy" }).catch(() => {});
  studyStore.setState(({ fixed, drags }) => ({ ...EMPTY, fixed, drags, target }));
}

/** Asks what moves the output; with `ranges` over the whole ranges of all inputs too. */
export async function findEffects(ranges: boolean): Promise<void> {
  const { target } = studyStore.getState();
  if (!target) return;
  studyStore.setState({ busy: ranges ? "ranges" : "here", refused: undefined });
  const revision = documentStore.getState().revision;
  await settle(target, async () => {
    const answer = await ask({ ask: "effects", target: targetOf(target), with: null, ranges });
    return answer.event === "effects" ? { effects: answer.effects, of: { target, revision } } : {};
  });
}

/** Moves the inputs that may move until the output gives the numbers, as nearly as can be. */
export async function solveFor(numbers: number[]): Promise<void> {
  const { target } = studyStore.getState();
  if (!target) return;
  studyStore.setState({ busy: "wanted", refused: undefined });
  await settle(target, async () => {
    const wants = [{ target: targetOf(target), numbers }];
    const answer = await ask({ ask: "solveFor", wants, with: movableInputs(), quick: false, gesture: newGesture() });
    return answer.event === "solved" ? { solved: answer.solved } : {};
  });
}

async function settle(target: string, find: () => Promise<Partial<Study>>): Promise<void> {
  let found: Partial<Study>;
  try {
    found = await find();
  } catch (error) {
    found = { refused: error instanceof Error ? error.message : String(error) };
  }
  // Another output may be looked at by now.
  if (studyStore.getState().target === target) studyStore.setState({ busy: undefined, ...found });
}

/** The inputs that may move for a wanted result: none named where all may. Whole numbers never move. */
export function movableInputs(): InputPlace[] | null {
  const { effects, fixed } = studyStore.getState();
  if (!effects || fixed.size === 0) return null;
  const even = effects.here.filter(({ slope }) => slope.is !== "steps");
  const free = even.map(({ input }) => input).filter((input) => !fixed.has(keyOf(input)));
  return free.length === even.length ? null : free;
}

let asked = 0;

/** Shows how places move with an input; with none, nothing. */
export async function showMotion(input: InputPlace | undefined): Promise<void> {
  const own = ++asked;
  if (!input) return studyStore.setState({ motion: undefined });
  try {
    const answer = await ask({ ask: "motion", input });
    if (own === asked && answer.event === "motion") studyStore.setState({ motion: { input: keyOf(input), view: answer.motion } });
  } catch {
    // The refusal is on the line at the bottom already.
    if (own === asked) studyStore.setState({ motion: undefined });
  }
}
