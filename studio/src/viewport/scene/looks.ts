/** Which colour a part is drawn in: by the document, its own, whether it is selected, and the display mode. */

import type { Rgba } from "../../core/preview";
import type { PartKind } from "../../core/protocol/PartKind";

export type DisplayMode = "wireframe" | "shaded" | "ghosted" | "rendered" | "technical";
export const DISPLAY_MODES: readonly DisplayMode[] = ["wireframe", "shaded", "ghosted", "rendered", "technical"];

export interface ObjectState {
  selected: boolean;
  hovered: boolean;
  hidden: boolean;
}

export interface Palette {
  /** The document's colours of previews. */
  normal: Rgba;
  selected: Rgba;
  /** Lines and points where the mode has no colours. */
  ink: Rgba;
  /** Surfaces of the rendered mode that have no colour of their own. */
  plaster: Rgba;
  /** What it is all drawn on. */
  background: Rgba;
}

/** What is shown at all. */
export interface Layers {
  edges: boolean;
  isocurves: boolean;
  points: boolean;
  controlPoints: boolean;
  texts: boolean;
}

const NONE: Rgba = [0, 0, 0, 0];
const HOVER = 0.35;
const FAINT = 150;

export function lookOf(
  kind: PartKind,
  own: Rgba | null,
  state: ObjectState,
  mode: DisplayMode,
  palette: Palette,
  layers: Layers,
): Rgba {
  if (state.hidden || !isShown(kind, mode, layers)) return NONE;
  const colour = kind === "mesh" ? surface(own, state, mode, palette) : line(kind, own, state, mode, palette);
  return state.hovered ? brighter(colour) : colour;
}

/** The colours of what stands beside the model for looking closely; lines of their own colours keep them. */
export function toolLook(kind: PartKind, own: Rgba | null, { ink, background }: Pick<Palette, "ink" | "background">): Rgba {
  const [red, green, blue] = own ?? TOOL_COLOURS[kind] ?? ink;
  return readable([red, green, blue, kind === "hull" || kind === "isocurves" ? FAINT : 255], background);
}

/** How much of a layer's own colour is seen on its surfaces and lines: the rest is the background's. */
const OF_SURFACE = 0.35;
const OF_LINE = 0.55;
const THROUGH_LAYER = 60;

/** The colours of a layer of the Rhino model: dimmed, so that what the document makes stands out before it. */
export function layerLook(kind: PartKind, layer: Rgba, mode: DisplayMode, { background }: Pick<Palette, "background">, layers: Layers): Rgba {
  if (!isShown(kind, mode, layers)) return NONE;
  const isSurface = kind === "mesh";
  const [own, share] = isSurface ? [layer, OF_SURFACE] : [readable([layer[0], layer[1], layer[2], 255], background), OF_LINE];
  const mixed = (at: 0 | 1 | 2) => Math.round(own[at] * share + background[at] * (1 - share));
  return [mixed(0), mixed(1), mixed(2), isSurface ? THROUGH_LAYER : 255];
}

const TOOL_COLOURS: Partial<Record<PartKind, Rgba>> = {
  comb: [196, 92, 16, 255],
  circles: [112, 60, 190, 255],
  arrows: [112, 60, 190, 255],
};

function isShown(kind: PartKind, mode: DisplayMode, layers: Layers): boolean {
  switch (kind) {
    case "mesh":
      return mode !== "wireframe";
    case "edges":
      return layers.edges || mode === "wireframe";
    case "isocurves":
      return mode === "wireframe" || (layers.isocurves && mode !== "rendered" && mode !== "technical");
    case "points":
      return layers.points;
    case "controlPoints":
      return layers.controlPoints;
    case "texts":
      return layers.texts;
    default:
      return true;
  }
}

function surface(own: Rgba | null, { selected }: ObjectState, mode: DisplayMode, palette: Palette): Rgba {
  if (selected) return palette.selected;
  if (own) return own;
  return mode === "rendered" ? palette.plaster : palette.normal;
}

function line(kind: PartKind, own: Rgba | null, { selected }: ObjectState, mode: DisplayMode, palette: Palette): Rgba {
  const ofSurface = kind === "edges" || kind === "isocurves";
  const plain = mode === "technical" || (mode === "rendered" && ofSurface);
  const [red, green, blue] = selected ? palette.selected : (own ?? (plain ? palette.ink : palette.normal));
  const alpha = kind === "isocurves" || (mode === "rendered" && kind === "edges") ? FAINT : 255;
  // The edges of a coloured surface are a darker shade of it.
  const shade = ofSurface && own && !selected ? 0.55 : 1;
  return readable([Math.round(red * shade), Math.round(green * shade), Math.round(blue * shade), alpha], palette.background);
}

/** How much lines and texts differ from the background at least, as WCAG 2.2 (1.4.11) has it. */
const LEAST_CONTRAST = 3;

/** A colour moved towards white or black until it is seen on the background. Exported for tests. */
export function readable(colour: Rgba, background: Rgba): Rgba {
  const ground = luminance(background);
  const towards = ground > 0.18 ? 0 : 255;
  for (let step = 0; step <= 10; step++) {
    const [red, green, blue] = colour.map((value) => Math.round(value + ((towards - value) * step) / 10));
    const moved: Rgba = [red ?? 0, green ?? 0, blue ?? 0, colour[3]];
    const own = luminance(moved);
    if ((Math.max(own, ground) + 0.05) / (Math.min(own, ground) + 0.05) >= LEAST_CONTRAST) return moved;
  }
  return colour;
}

/** The relative luminance of a colour, by WCAG. */
function luminance(colour: Rgba): number {
  const [red = 0, green = 0, blue = 0] = colour.map((value) => {
    const part = value / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function brighter([red, green, blue, alpha]: Rgba): Rgba {
  const up = (value: number) => Math.round(value + (255 - value) * HOVER);
  return [up(red), up(green), up(blue), alpha];
}
