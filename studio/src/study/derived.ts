/** What follows from the study and from what was chosen: axes, the selection, colours, the front. */

import { useDeferredValue, useMemo } from "react";

import { type Axis, axesOf } from "./core/axes";
import { selectedBy } from "./core/brushes";
import { colourSteps, palette, type Theme } from "./core/colours";
import { frontOf, holds, worth } from "./core/front";
import { type Goal, isGood, type Study } from "./core/rows";
import { type Chosen, useChosen } from "./store";
import { useTheme } from "./theme";

export interface Derived {
  study: Study;
  axes: readonly Axis[];
  theme: Theme;
  /** For each row whether it is selected. */
  selected: Uint8Array;
  /** The places of the selected rows. */
  places: readonly number[];
  good: Uint8Array;
  x: Axis | undefined;
  y: Axis | undefined;
  colour: Axis | undefined;
  bars: Axis | undefined;
  colours: readonly string[];
  steps: Uint8Array;
  goals: ReadonlyMap<string, Goal>;
  /** The places of the rows on the front, in the order of the first goal. */
  front: readonly number[];
  onFront: ReadonlySet<number>;
}

/** Whether there are different values. */
const varies = ({ values }: Axis) => values.some((x) => !Number.isNaN(x) && x !== values.find((y) => !Number.isNaN(y)));

function usual(axes: readonly Axis[], kind: "in" | "out", skip = 0): Axis | undefined {
  const all = axes.filter((axis) => axis.kind === kind && !axis.words);
  const moving = all.filter(varies);
  return moving[skip] ?? moving[0] ?? all[0] ?? axes[0];
}

/** The goals that were chosen, else those of the study. */
export function goalsOf(study: Study, chosen: Chosen["goals"]): ReadonlyMap<string, Goal> {
  return chosen ?? new Map((study.goals ?? []).map(({ output, goal }) => [`out.${output}`, goal]));
}

export function useDerived(study: Study): Derived {
  const theme = useTheme();
  const { columns, rows, bounds } = study;
  const axes = useMemo(() => axesOf(columns, rows), [columns, rows]);
  const good = useMemo(() => Uint8Array.from(rows, (row) => (isGood(row) ? 1 : 0)), [rows]);
  // The brush under the hand moves at once; what follows from it may come a moment later.
  const brushes = useDeferredValue(useChosen((chosen) => chosen.brushes));
  const selected = useMemo(() => selectedBy(axes, brushes, rows.length), [axes, brushes, rows.length]);
  const places = useMemo(() => [...selected.keys()].filter((row) => selected[row] === 1), [selected]);

  const keys = { x: useChosen((c) => c.x), y: useChosen((c) => c.y), colour: useChosen((c) => c.colour), bars: useChosen((c) => c.bars) };
  const axis = (key: string | undefined) => axes.find((one) => one.key === key);
  const chosenGoals = useChosen((chosen) => chosen.goals);
  const goals = useMemo(() => goalsOf(study, chosenGoals), [study.goals, chosenGoals]);
  const ofGoal = [...goals.keys()].map(axis);
  const x = axis(keys.x) ?? (goals.size > 1 ? ofGoal[0] : undefined) ?? usual(axes, "in");
  const y = axis(keys.y) ?? (goals.size > 1 ? ofGoal[1] : undefined) ?? usual(axes, "out");
  const colour = keys.colour === "" ? undefined : (axis(keys.colour) ?? usual(axes, "out", 1));
  const bars = axis(keys.bars) ?? usual(axes, "out");

  const colours = useMemo(() => palette(colour, theme), [colour, theme]);
  const steps = useMemo(() => colourSteps(colour, rows.length), [colour, rows.length]);
  const front = useMemo(() => {
    const wanted = [...goals].flatMap(([key, goal]) => {
      const found = axes.find((one) => one.key === key);
      return found ? [found.values.map((value) => worth(goal, value))] : [];
    });
    const limits = (bounds ?? []).map(({ output, bound }) => ({ bound, values: axes.find((one) => one.key === `out.${output}`)?.values }));
    const keeps = (row: number) => limits.every(({ bound, values }) => !values || holds(bound, values[row] ?? NaN));
    return wanted.length < 2 ? [] : frontOf(wanted, places.filter((row) => good[row] === 1 && keeps(row)));
  }, [axes, goals, bounds, places, good]);
  const onFront = useMemo(() => new Set(front), [front]);
  return { study, axes, theme, selected, places, good, x, y, colour, bars, colours, steps, goals, front, onFront };
}
