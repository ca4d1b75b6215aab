/** What there is to place: the components, as `GET /api/components` lists them. */

import { ORDER } from "./ribbonOrder";

export interface CataloguePort {
  name: string;
  nick: string;
  help: string;
  kind: string;
  access: string;
  optional: boolean;
}

export interface CatalogueEntry {
  guid: string;
  name: string;
  nick: string;
  tab: string;
  panel: string;
  help: string;
  keywords: readonly string[];
  /** Whether it is a parameter that floats on the canvas. */
  floating: boolean;
  /** Whether it is kept for old files only. */
  old: boolean;
  inputs: readonly CataloguePort[];
  outputs: readonly CataloguePort[];
  variableInputs: boolean;
  variableOutputs: boolean;
}

/** Grasshopper's tabs in its own order; others follow by name. */
const TABS = [
  "Params",
  "Maths",
  "Sets",
  "Vector",
  "Curve",
  "Surface",
  "Mesh",
  "Intersect",
  "Transform",
  "Display",
];

export function tabRank(tab: string): number {
  const rank = TABS.indexOf(tab);
  return rank < 0 ? TABS.length : rank;
}

export interface Tab {
  name: string;
  panels: { name: string; entries: CatalogueEntry[] }[];
}

/** The tabs with their panels; what is old is left out. */
export function tabs(catalogue: readonly CatalogueEntry[]): Tab[] {
  const all = new Map<string, Map<string, CatalogueEntry[]>>();
  for (const entry of catalogue) {
    if (entry.old || !entry.tab) continue;
    const panels = all.get(entry.tab) ?? new Map<string, CatalogueEntry[]>();
    const panel = panels.get(entry.panel) ?? [];
    panel.push(entry);
    panels.set(entry.panel, panel);
    all.set(entry.tab, panels);
  }
  const ordered = [...all].sort(([a], [b]) => tabRank(a) - tabRank(b) || a.localeCompare(b));
  return ordered.map(([name, panels]) => ({
    name,
    panels: [...panels]
      .sort(([a], [b]) => a.localeCompare(b))
      .map(([panel, entries]) => ({
        name: panel,
        entries: entries.sort(byUse(ORDER[`${name}/${panel}`] ?? [])),
      })),
  }));
}

/** What is used most first, the rest by name. */
function byUse(order: readonly string[]): (a: CatalogueEntry, b: CatalogueEntry) => number {
  const rank = ({ name }: CatalogueEntry) => {
    const at = order.indexOf(name);
    return at < 0 ? order.length : at;
  };
  return (a, b) => rank(a) - rank(b) || a.name.localeCompare(b.name);
}

/** The ids of what popup codes and gestures place; they are Grasshopper's own. */
export const IDS = {
  panel: "59e0b89a-e487-49f8-bab8-b5bab16be14c",
  slider: "57da07bd-ecab-415d-9d86-af36d7073abc",
  scribble: "7f5c6c55-f846-4a08-9c9a-cfdc285cc6fe",
  calendar: "ab898d46-b8b3-4ed5-b28f-4f8047920262",
  clock: "f8a94819-1e2b-4d67-9100-9e983ac493cc",
  point: "fbac3e32-f100-4292-8692-77240a42fd1a",
  viewer: "72a29b54-2e48-474b-a400-d2124c4edf79",
  quickGraph: "2b69bf71-4e69-43aa-b7be-4f6ce7e45bef",
  barGraph: "e1905a16-da43-4705-bd65-41d34328c4e6",
  imageGallery: "54ab3f01-a769-4742-a7bf-cec48a1acb6f",
  pieChart: "952c2bcc-b5ec-480a-a0d7-27f016632e33",
  valueTracker: "615367b4-c9d0-4cb7-986c-cb861226136f",
} as const;

/** The component of a name, a new one before an old one. */
export function named(catalogue: readonly CatalogueEntry[], name: string): CatalogueEntry | undefined {
  const wanted = name.toLowerCase();
  const found = catalogue.filter((entry) => entry.name.toLowerCase() === wanted);
  return found.find((entry) => !entry.old) ?? found[0];
}
