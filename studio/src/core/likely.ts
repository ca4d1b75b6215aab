/**
 * What is likely to come next on the canvas: a Markov chain of the first order over components, counted from the wires of
 * definitions.
 */

/** How often the data of one component went into another, by their ids. */
export type Counts = Readonly<Record<string, Readonly<Record<string, number>>>>;

interface Wired {
  id: string;
  component: string;
  inputs: readonly { sources: readonly string[] }[];
  outputs: readonly { id: string }[];
}

/** More components, and more that follow one of them, are not counted: a browser keeps a table of that size. */
const MOST_COMPONENTS = 600;
const MOST_NEXT = 16;

/** The counts with the wires of a definition added. */
export function learnt(counts: Counts, objects: Iterable<Wired>): Counts {
  const all = [...objects];
  const owner = new Map(all.flatMap(({ component, outputs }) => outputs.map(({ id }) => [id, component] as const)));
  const now = new Map(Object.entries(counts).map(([from, next]) => [from, new Map(Object.entries(next))] as const));
  for (const { component, inputs } of all) {
    for (const from of inputs.flatMap(({ sources }) => sources.flatMap((source) => owner.get(source) ?? []))) {
      const next = now.get(from) ?? new Map<string, number>();
      next.set(component, (next.get(component) ?? 0) + 1);
      now.set(from, next);
    }
  }
  const kept = [...now].map(([from, next]) => [from, Object.fromEntries(first([...next], MOST_NEXT))] as const);
  const weight = ([, next]: (typeof kept)[number]) => Object.values(next).reduce((sum, count) => sum + count, 0);
  return Object.fromEntries(kept.toSorted((a, b) => weight(b) - weight(a)).slice(0, MOST_COMPONENTS));
}

function first(next: readonly (readonly [string, number])[], most: number): (readonly [string, number])[] {
  return next.toSorted((a, b) => b[1] - a[1] || (a[0] < b[0] ? -1 : 1)).slice(0, most);
}

/** What most often follows a component, the most often first. */
export function likelyAfter(counts: Counts, component: string, most = Infinity): string[] {
  return first(Object.entries(Object.hasOwn(counts, component) ? (counts[component] ?? {}) : {}), most).map(([next]) => next);
}

/** Counts as a browser kept them; what is none is left out. */
export function readCounts(found: unknown): Counts {
  const fields = (of: unknown) => (typeof of === "object" && of !== null ? Object.entries(of) : []);
  const rows = fields(found).slice(0, MOST_COMPONENTS).map(([from, next]) => {
    const sound = fields(next).filter((entry): entry is [string, number] => typeof entry[1] === "number" && entry[1] > 0 && Number.isFinite(entry[1]));
    return [from, Object.fromEntries(sound.slice(0, MOST_NEXT))] as const;
  });
  return Object.fromEntries(rows);
}
