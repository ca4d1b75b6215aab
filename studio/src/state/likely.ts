/** What this person's definitions taught of what comes after what. It stays in this browser. */

import { createStore } from "zustand/vanilla";

import { learnt, readCounts, type Counts } from "../core/likely";
import { documentStore } from "./document";

const KEY = "katydid.likely";
/** Definitions that were learnt from are not learnt from again; so many are remembered. */
const MOST_KNOWN = 300;

interface Likely {
  counts: Counts;
  known: readonly string[];
}

function stored(): Likely {
  try {
    const found = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Record<keyof Likely, unknown>>;
    const known = Array.isArray(found.known) ? found.known.filter((name): name is string => typeof name === "string") : [];
    return { counts: readCounts(found.counts), known: known.slice(-MOST_KNOWN) };
  } catch {
    // A browser that keeps nothing, or something else wrote there.
    return { counts: {}, known: [] };
  }
}

export const likelyStore = createStore<Likely>(stored);

likelyStore.subscribe((likely) => {
  try {
    localStorage.setItem(KEY, JSON.stringify(likely));
  } catch {
    // It holds for this page then.
  }
});

/** Learns from a definition when it is opened for the first time. */
documentStore.subscribe(({ document, objects, within }, before) => {
  if (!document || document === before.document || within.length > 0 || objects.size === 0) return;
  const name = document.path ?? document.name;
  if (before.document && name === (before.document.path ?? before.document.name)) return;
  likelyStore.setState(({ counts, known }) =>
    known.includes(name) ? {} : { counts: learnt(counts, objects.values()), known: [...known, name].slice(-MOST_KNOWN) },
  );
});
