/** The front of several goals (Pareto): the points that no other is better than. */

import type { Bound, Goal } from "./rows";

/** What a number is worth; less is better. */
export function worth(goal: Goal, x: number): number {
  if (goal === "least") return x;
  return goal === "most" ? -x : Math.abs(x - goal.near);
}

/** Whether a number is on the right side. */
export function holds(bound: Bound, x: number): boolean {
  return "at-most" in bound ? x <= bound["at-most"] : x >= bound["at-least"];
}

/**
 * The places of the points that no other is better than: as good in every goal and better in one. `goals` has a list of numbers
 * for each goal, less being better, with an entry for each point; points with NaN in one are none.
 */
export function frontOf(goals: readonly Float64Array[], points: readonly number[]): number[] {
  const [first] = goals;
  if (!first) return [];
  const at = (goal: Float64Array, point: number) => goal[point] ?? NaN;
  const known = points.filter((point) => goals.every((goal) => !Number.isNaN(at(goal, point))));
  // In this order nobody is better than who comes before: what is on the front stays there.
  known.sort((a, b) => {
    for (const goal of goals) {
      const difference = at(goal, a) - at(goal, b);
      if (difference !== 0) return difference;
    }
    return a - b;
  });
  const better = (a: number, b: number) => goals.every((goal) => at(goal, a) <= at(goal, b)) && goals.some((goal) => at(goal, a) < at(goal, b));
  const front: number[] = [];
  for (const point of known) if (!front.some((other) => better(other, point))) front.push(point);
  return front;
}
