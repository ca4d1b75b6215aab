/** The search box: what of the catalogue is meant by some letters, the likeliest first. */

import { tabRank, type CatalogueEntry, type CataloguePort } from "./catalogue";
import { fit } from "./kinds";

export interface Found {
  entry: CatalogueEntry;
  score: number;
}

/** The end of a wire that what is found shall take: only what has a port for it is found. */
export interface Wanted {
  /** The side of the object to be found that the wire goes to. */
  side: "input" | "output";
  kind: string;
}

/** What people type who learned other words. */
const ALIASES: Record<string, string> = {
  plus: "addition",
  add: "addition",
  minus: "subtraction",
  times: "multiplication",
  divide: "division",
  slider: "number slider",
  toggle: "boolean toggle",
  text: "panel",
  note: "panel",
  xyz: "construct point",
  pt: "point",
  crv: "curve",
  srf: "surface",
  translate: "move",
  copy: "move",
  union: "solid union",
  subtract: "solid difference",
  remap: "remap numbers",
  color: "colour",
};

function words(text: string): string[] {
  return text.toLowerCase().split(/[^\p{L}\p{N}²]+/u).filter(Boolean);
}

function initials(text: string): string {
  return words(text)
    .map((word) => word[0] ?? "")
    .join("");
}

/** Whether the letters come in this order, and how closely: the length of the stretch that holds them. */
function stretch(letters: string, text: string): number | undefined {
  let [first, at] = [-1, -1];
  for (const letter of letters) {
    at = text.indexOf(letter, at + 1);
    if (at < 0) return undefined;
    if (first < 0) first = at;
  }
  return at - first + 1;
}

/** How well a query names an entry: 0 for not at all. */
export function score(entry: CatalogueEntry, query: string): number {
  const wanted = query.trim().toLowerCase();
  if (wanted === "") return 1;
  const name = entry.name.toLowerCase();
  const nick = entry.nick.toLowerCase();
  const own = words(name);
  const best = Math.max(
    name === wanted ? 100 : 0,
    nick === wanted ? 92 : 0,
    name.startsWith(wanted) ? 84 - Math.min(name.length - wanted.length, 20) / 4 : 0,
    ALIASES[wanted] === name ? 82 : 0,
    initials(entry.name) === wanted && own.length > 1 ? 76 : 0,
    own.some((word) => word.startsWith(wanted)) ? 70 - Math.min(name.length - wanted.length, 20) / 4 : 0,
    nick.startsWith(wanted) ? 62 : 0,
    entry.keywords.some((word) => word.toLowerCase() === wanted) ? 60 : 0,
    all(words(wanted), own) ? 58 : 0,
    name.includes(wanted) ? 50 : 0,
    entry.keywords.some((word) => word.toLowerCase().startsWith(wanted)) ? 44 : 0,
    all(words(wanted), [...own, ...words(entry.panel), ...words(entry.tab)]) ? 40 : 0,
    loose(wanted, name),
    described(wanted, entry),
  );
  return best === 0 ? 0 : best - (entry.old ? 35 : 0);
}

/** Whether each word begins one of the others. */
function all(wanted: readonly string[], own: readonly string[]): boolean {
  return wanted.length > 0 && wanted.every((word) => own.some((other) => other.startsWith(word)));
}

/** Letters left out: `dvcrv` for Divide Curve. */
function loose(wanted: string, name: string): number {
  const letters = wanted.replace(/\s/g, "");
  if (letters.length < 3 || letters[0] !== name[0]) return 0;
  const length = stretch(letters, name);
  return length === undefined ? 0 : Math.max(0, 34 - (length - letters.length));
}

function described(wanted: string, entry: CatalogueEntry): number {
  if (wanted.length < 3) return 0;
  return all(words(wanted), words(entry.help)) ? 22 : 0;
}

/** The port of an entry that a wire with this data would go to or come from, and how well it fits. */
export function portFor(entry: CatalogueEntry, wanted: Wanted): { port: CataloguePort; fit: 1 | 2 } | undefined {
  let best: { port: CataloguePort; fit: 1 | 2 } | undefined;
  for (const port of wanted.side === "input" ? entry.inputs : entry.outputs) {
    const well = wanted.side === "input" ? fit(wanted.kind, port.kind) : fit(port.kind, wanted.kind);
    if (well !== 0 && well > (best?.fit ?? 0)) best = { port, fit: well };
  }
  return best;
}

/** The likeliest entries, at most `most`. */
export function search(
  catalogue: readonly CatalogueEntry[],
  query: string,
  wanted?: Wanted,
  most = 12,
): Found[] {
  const found: Found[] = [];
  for (const entry of catalogue) {
    const well = wanted ? portFor(entry, wanted) : undefined;
    if (wanted && !well) continue;
    const base = score(entry, query);
    if (base > 0) found.push({ entry, score: base + (well?.fit === 2 ? 6 : 0) });
  }
  found.sort(
    (a, b) =>
      b.score - a.score ||
      // Of a component and a parameter that are named alike the component is meant: "circ" draws a circle.
      Number(a.entry.floating) - Number(b.entry.floating) ||
      tabRank(a.entry.tab) - tabRank(b.entry.tab) ||
      a.entry.name.localeCompare(b.entry.name),
  );
  return found.slice(0, most);
}
