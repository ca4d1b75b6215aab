/** How the model is looked at: what the toolbar changes and shows. */

import { createStore, type StoreApi } from "zustand/vanilla";

import type { Point3 } from "../core/preview";
import type { Projection } from "./camera";
import { DISPLAY_MODES, type DisplayMode, type Layers } from "./scene/looks";
import type { Layout, ViewName } from "./views";

/** The colours of surfaces: Gaussian and mean curvature, the greater and the lesser of the principal ones, stripes. */
export type Analysis = "none" | "gaussian" | "mean" | "greater" | "lesser" | "zebra";
export const ANALYSES: readonly Analysis[] = ["none", "gaussian", "mean", "greater", "lesser", "zebra"];

export interface Shown extends Layers {
  grid: boolean;
}

/** A plane that cuts the view: what lies before it, along its normal, is not drawn. */
export interface Section {
  isOn: boolean;
  /** A unit vector. */
  normal: Point3;
  /** How far along the normal the plane is from the origin; undefined until it is put somewhere: through the middle. */
  at: number | undefined;
}

/** Which objects are shown: all that preview, of them the selected ones, or none. */
export const PREVIEWS = ["all", "selected", "none"] as const;
export type Previews = (typeof PREVIEWS)[number];

/** What a point that is drawn goes to, besides the grid. */
export interface Snaps {
  end: boolean;
  mid: boolean;
  near: boolean;
}

export interface ViewportSettings {
  mode: DisplayMode;
  previews: Previews;
  layout: Layout;
  shown: Shown;
  analysis: Analysis;
  /** The range of false colours as it was typed; else it fits the model. */
  range: readonly [number, number] | undefined;
  stripes: number;
  /** Zebra stripes that stand upright. */
  across: boolean;
  /** Whether all that is shown is looked at, or what is selected. */
  ofAll: boolean;
  comb: boolean;
  /** How long the comb's longest tooth is about, in hundredths of the size of what is looked at. */
  combScale: number;
  /** Teeth in each span. */
  combTeeth: number;
  /** Whether isocurves of surfaces have combs. */
  combSurfaces: boolean;
  /** The osculating circle under the pointer. */
  circle: boolean;
  /** So many circles along each curve. */
  circles: number;
  /** Control polygons and nets. */
  controls: boolean;
  /** So many isocurves between two knots. */
  isocurves: number;
  /** Isocurves along u in red and along v in green. */
  directions: boolean;
  section: Section;
  trackpad: boolean;
  /** Whether the view turns by itself. */
  turntable: boolean;
  snap: boolean;
  /** Handles that move, turn and scale what the selected parameters keep. */
  gumball: boolean;
  snaps: Snaps;
}

/** What the viewport says of itself. */
export interface ViewportState {
  /** Whether nothing of the document is seen, wherever one looks. */
  isEmpty: boolean;
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
  previews: "all",
  layout: "one",
  shown: { grid: true, edges: true, isocurves: true, points: true, controlPoints: true, texts: true },
  analysis: "none",
  range: undefined,
  stripes: 6,
  across: false,
  ofAll: false,
  comb: false,
  combScale: 20,
  combTeeth: 12,
  combSurfaces: false,
  circle: false,
  circles: 0,
  controls: false,
  isocurves: 0,
  directions: false,
  section: { isOn: false, normal: [0, 1, 0], at: undefined },
  trackpad: false,
  turntable: false,
  snap: true,
  gumball: true,
  snaps: { end: true, mid: true, near: false },
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
    gumball: flag(found.gumball, USUAL.gumball),
  };
}

function stored(): string | null {
  try {
    return typeof localStorage === "undefined" ? null : localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

/** Settings of a viewport that keeps nothing: as usual. */
export const freshSettings = (): StoreApi<ViewportSettings> => createStore<ViewportSettings>(() => USUAL);

export const settingsStore = createStore<ViewportSettings>(() => readSettings(stored()));

settingsStore.subscribe(({ mode, shown, trackpad, snap, gumball }) => {
  try {
    localStorage.setItem(KEY, JSON.stringify({ mode, shown, trackpad, snap, gumball }));
  } catch {
    // A browser that keeps nothing still works.
  }
});

/** Where a viewport says what it shows. */
export const freshState = (): StoreApi<ViewportState> =>
  createStore<ViewportState>(() => ({
    view: undefined,
    projection: "perspective",
    legend: undefined,
    pointed: undefined,
    notice: undefined,
    texts: { all: 0, shown: 0 },
    isEmpty: true,
  }));

export const viewportStore = freshState();
