/** How much of each panel of the tabs is shown. */

/** Rows of buttons in a panel. */
export const ROWS = 2;

/**
 * How many columns of buttons each panel has, so that they fill the width: as many as its name is wide at first, then one
 * more for the panel that has most components for each of its columns. Panels of which all is shown get no more.
 */
export function columnsOf(
  counts: readonly number[],
  width: number,
  button: number,
  frame: number,
  least: readonly number[] = [],
): number[] {
  const columns = counts.map((_, k) => Math.max(1, least[k] ?? 1));
  const has = (k: number) => columns[k] ?? 1;
  const crowd = (k: number) => ((counts[k] ?? 0) > has(k) * ROWS ? (counts[k] ?? 0) / has(k) : 0);
  let rest = width - counts.length * frame - button * columns.reduce((sum, one) => sum + one, 0);
  while (rest >= button) {
    const next = counts.reduce((best, _, k) => (crowd(k) > crowd(best) ? k : best), 0);
    if (counts.length === 0 || crowd(next) === 0) break;
    columns[next] = has(next) + 1;
    rest -= button;
  }
  return columns;
}

/** What was placed lately, with one more at the front; each once, at most so many. */
export function withRecent(recent: readonly string[], component: string, most: number): string[] {
  return [component, ...recent.filter((one) => one !== component)].slice(0, most);
}
