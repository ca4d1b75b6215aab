/** What the canvas alone knows: gestures under way, menus and boxes that are open. Nothing of it is in the document. */

import { createStore } from "zustand/vanilla";

import type { Guide } from "../core/align";
import type { CatalogueEntry } from "../core/catalogue";
import type { Point, Rect } from "../core/geometry";
import type { Grip } from "../core/hit";
import { NO_SHIFTS, type Shifts } from "../core/places";
import type { MouseScheme } from "../core/wheel";
import type { Elastic, Target } from "./gestures/chart";

export interface MenuAt {
  pixel: Point;
  /** Whether it opens upwards from the pixel. */
  above?: boolean;
  at: Point;
  target: Target | { is: "centre"; id: string } | { is: "zoom" | "views" };
}

export interface SearchAt {
  pixel: Point;
  /** Where what is found is placed. */
  at: Point;
  /** The wire that was let go in the void. */
  from: Grip | undefined;
  /** The grips that were drawn together with it. */
  more: readonly Grip[];
}

export interface TipAt {
  pixel: Point;
  object: string;
  /** The port, or the object as a whole. */
  port: { id: string; side: "input" | "output" } | undefined;
}

/** A box about one object that is open. */
export interface EditorAt {
  object: string;
  is: "control" | "nickname" | "formula" | "expression" | "values" | "stream";
  /** The port that an expression or values are for. */
  port?: string;
  /** An index in the control, such as a gradient's grip. */
  index?: number;
}

export interface CanvasState {
  shifts: Shifts;
  /** Where copies would stand that are being dragged. */
  ghosts: readonly Rect[];
  guides: readonly Guide[];
  window: { rect: Rect; crossing: boolean } | undefined;
  wire: Elastic | undefined;
  menu: MenuAt | undefined;
  /** The pixel about which the ring of commands is open. */
  radial: Point | undefined;
  search: SearchAt | undefined;
  tip: TipAt | undefined;
  editor: EditorAt | undefined;
  /** The object whose text is edited in its place. */
  writing: string | undefined;
  /** An entry of the tabs that the next click places. */
  placing: CatalogueEntry | undefined;
  /** The component that the tabs point at. */
  pointedAt: string | undefined;
  /** The grip that the keyboard connects. */
  connecting: Grip | undefined;
  /** Whether the box that finds objects of the document is open. */
  finding: boolean;
  /** The Param Viewers that draw the tree and do not list its paths, where the document does not say. */
  drawing: ReadonlySet<string>;
  /** What was found: everything else is faint. */
  found: ReadonlySet<string> | undefined;
  /** A wire that a menu speaks of. */
  hotWire: { from: string; to: string } | undefined;
  /** The object that the keyboard is at. */
  active: string | undefined;
  /** So far away that boxes are drawn, or so near that there is room for (+) and (−). */
  distance: "far" | "usual" | "near";
  scheme: MouseScheme;
  /** Whether things that are dragged line up with others. */
  snapping: boolean;
  ribbon: boolean;
  /** Whether handles for lining up stand around a selection. */
  aligning: boolean;
  /** Whether capsules show pictures for names. */
  icons: boolean;
  /** Whether likely next components are shown. */
  likely: boolean;
  /** The tab of components that was used last. */
  tab: string | undefined;
  /** What was placed lately, the last first. */
  recent: readonly string[];
  /** What was last said for screen readers. */
  said: string;
}

const KEPT = "katydid.canvas";

interface Kept {
  scheme: MouseScheme;
  snapping: boolean;
  ribbon: boolean;
  aligning: boolean;
  icons: boolean;
  likely: boolean;
  tab: string | undefined;
  recent: readonly string[];
}

/** What of the canvas a browser remembers. Storage may be forbidden: then nothing is remembered. */
function kept(): Kept {
  const usual: Kept = { scheme: "grasshopper", snapping: true, ribbon: true, aligning: true, icons: false, likely: true, tab: undefined, recent: [] };
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
    if (typeof found !== "object" || found === null) return usual;
    const { scheme, snapping, ribbon, aligning, icons, likely, tab, recent } = found as Record<string, unknown>;
    return {
      scheme: scheme === "figma" ? "figma" : "grasshopper",
      snapping: snapping !== false,
      ribbon: ribbon !== false,
      aligning: aligning !== false,
      icons: icons === true,
      likely: likely !== false,
      tab: typeof tab === "string" ? tab : undefined,
      recent: Array.isArray(recent) ? recent.filter((one): one is string => typeof one === "string") : [],
    };
  } catch {
    return usual;
  }
}

export const canvasStore = createStore<CanvasState>(() => ({
  shifts: NO_SHIFTS,
  ghosts: [],
  guides: [],
  window: undefined,
  wire: undefined,
  menu: undefined,
  radial: undefined,
  search: undefined,
  tip: undefined,
  editor: undefined,
  writing: undefined,
  placing: undefined,
  pointedAt: undefined,
  connecting: undefined,
  finding: false,
  drawing: new Set(),
  found: undefined,
  hotWire: undefined,
  active: undefined,
  distance: "usual",
  said: "",
  ...kept(),
}));

/** Changes what a browser remembers. */
export function keep(change: Partial<Kept>): void {
  canvasStore.setState(change);
  const { scheme, snapping, ribbon, aligning, icons, likely, tab, recent } = canvasStore.getState();
  try {
    localStorage.setItem(KEPT, JSON.stringify({ scheme, snapping, ribbon, aligning, icons, likely, tab, recent }));
  } catch {
    // It holds for this page then.
  }
}

/** Tells screen readers something. The same words twice are another text, or the second time would not be heard. */
export function say(words: string): void {
  canvasStore.setState(({ said }) => ({ said: said === words ? `${words}\u00a0` : words }));
}
