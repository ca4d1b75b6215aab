/** How the model is looked at: what the toolbar changes and shows. */

import { createStore } from "zustand/vanilla";

import type { Projection } from "./camera";
import { DISPLAY_MODES, type DisplayMode, type Layers } from "./scene/looks";
import type { Layout, ViewName } from "./views";

export type Analysis = "none" | "gaussian" | "mean" | "zebra";
export const ANALYSES: readonly Analysis[] = ["none", "gaussian", "mean", "zebra"];

export interface Shown extends Layers {
  grid: boolean;
}

export interface ViewportSettings {
  mode: DisplayMode;
  layout: Layout;
  shown: Shown;
  analysis: Analysis;
  /** The range of false colours as it was typed; else it fits the model. */
  range: readonly [number, number] | undefined;
  stripes: number;
  /** Zebra stripes that stand upright. */
  across: boolean;
  comb: boolean;
  /** How long the comb's longest tooth is, in hundredths of the model's size. */
  combScale: number;
  circle: boolean;
  trackpad: boolean;
  snap: boolean;
}

/** What the viewport says of itself. */
export interface ViewportState {
  /** The view that the active pane is turned to, where it has a name. */
  view: ViewName | undefined;
  projection: Projection;
  /** The range of the false colours shown, and whether the numbers are the kernel's own. */
  legend: { range: readonly [number, number]; exact: boolean } | undefined;
  /** The item under the pointer. */
  pointed: { object: string; path: string; index: number; x: number; y: number } | undefined;
  /** Why there is less to see than there is. */
  notice: string | undefined;
  /** How many texts there are in view, and how many of them are shown. */
  texts: { all: number; shown: number };
}

const USUAL: ViewportSettings = {
  mode: "shaded",
  layout: "one",
  shown: { grid: true, edges: true, isocurves: true, points: true, controlPoints: true, texts: true },
  analysis: "none",
  range: undefined,
  stripes: 6,
  across: false,
  comb: false,
  combScale: 20,
  circle: false,
  trackpad: false,
  snap: true,
};

const KEY = "katydid.viewport";

/** What this person likes, from what the browser kept; what is missing or makes no sense is as usual. Exported for tests. */
export function readSettings(text: string | null): ViewportSettings {
  let found: Record<string, unknown> = {};
  try {
    const parsed: unknown = JSON.parse(text ?? "{}");
    if (typeof parsed === "object" && parsed !== null) found = parsed as Record<string, unknown>;
  } catch {
    // Something else wrote there: as usual.
  }
  const flag = (value: unknown, usual: boolean) => (typeof value === "boolean" ? value : usual);
  const kept = (typeof found.shown === "object" && found.shown !== null ? found.shown : {}) as Record<string, unknown>;
  const shown = Object.fromEntries(Object.entries(USUAL.shown).map(([name, usual]) => [name, flag(kept[name], usual)]));
  return {
    ...USUAL,
    mode: DISPLAY_MODES.find((mode) => mode === found.mode) ?? USUAL.mode,
    shown: shown as unknown as Shown,
    trackpad: flag(found.trackpad, USUAL.trackpad),
    snap: flag(found.snap, USUAL.snap),
  };
}

function stored(): string | null {
  try {
    return typeof localStorage === "undefined" ? null : localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export const settingsStore = createStore<ViewportSettings>(() => readSettings(stored()));

settingsStore.subscribe(({ mode, shown, trackpad, snap }) => {
  try {
    localStorage.setItem(KEY, JSON.stringify({ mode, shown, trackpad, snap }));
  } catch {
    // A browser that keeps nothing still works.
  }
});

export const viewportStore = createStore<ViewportState>(() => ({
  view: undefined,
  projection: "perspective",
  legend: undefined,
  pointed: undefined,
  notice: undefined,
  texts: { all: 0, shown: 0 },
}));
