/** Lists of things that people give names: views of the canvas, cameras. Each name is there once. */

export interface Named {
  name: string;
}

/** The most that a document has: what is kept in a browser must stay small. */
const MOST = 100;

/** The list with one more; one of the same name is replaced. */
export function withNamed<N extends Named>(list: readonly N[], one: N): N[] {
  const at = list.findIndex(({ name }) => name === one.name);
  if (at >= 0) return list.map((old, k) => (k === at ? one : old));
  return [...list, one].slice(-MOST);
}

/** The list with one under another name; a name that another has, and an empty one, changes nothing. */
export function renamed<N extends Named>(list: readonly N[], from: string, to: string): N[] {
  const name = to.trim();
  if (name === "" || list.some((one) => one.name === name)) return [...list];
  return list.map((one) => (one.name === from ? { ...one, name } : one));
}

export function without<N extends Named>(list: readonly N[], name: string): N[] {
  return list.filter((one) => one.name !== name);
}

/** The first numbered name that is not there yet. */
export function freshName(list: readonly Named[], numbered: (number: number) => string): string {
  for (let number = 1; ; number++) {
    const name = numbered(number);
    if (!list.some((one) => one.name === name)) return name;
  }
}

/** What a text holds that was kept; what makes no sense in it is left out. */
export function readNamed<N extends Named>(text: string | null, read: (value: unknown) => N | undefined): N[] {
  let found: unknown;
  try {
    found = JSON.parse(text ?? "[]");
  } catch {
    return [];
  }
  return Array.isArray(found) ? found.flatMap((one: unknown) => read(one) ?? []).slice(0, MOST) : [];
}
