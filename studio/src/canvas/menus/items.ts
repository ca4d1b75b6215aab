/** What menus are made of. */

export type Item =
  | { is: "do"; label: string; run(): void; keys?: string; on?: boolean; off?: boolean; hover?(on: boolean): void }
  | { is: "line" }
  | { is: "more"; label: string; items: Item[] }
  | { is: "field"; label: string; value: string; take(text: string): void }
  | { is: "told"; level: string; text: string };

export const LINE: Item = { is: "line" };

/** Items without those that are not there, and without lines that part nothing. */
export function menu(...items: (Item | false | undefined)[]): Item[] {
  const there = items.filter((item): item is Item => item !== false && item !== undefined);
  return there.filter(
    (item, k) => item.is !== "line" || (k > 0 && k < there.length - 1 && there[k - 1]?.is !== "line"),
  );
}
