/** How the model is looked at: what the toolbar changes and shows. */

import { createStore } from "zustand/vanilla";

import type { Projection } from "./camera";
import type { DisplayMode, Layers } from "./scene/looks";
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

export const settingsStore = createStore<ViewportSettings>(() => ({
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
}));

export const viewportStore = createStore<ViewportState>(() => ({
  view: undefined,
  projection: "perspective",
  legend: undefined,
  pointed: undefined,
  notice: undefined,
  texts: { all: 0, shown: 0 },
}));
