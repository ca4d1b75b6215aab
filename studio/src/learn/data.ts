/** What a page says of a figure: written by `crates/book/src/figure.rs`. */

export interface ControlData {
  name: string;
  label: string;
  /** A slider; a toggle has none. */
  slider: { value: number; min: number; max: number; step: number } | null;
  /** Whether a toggle is on. */
  on: boolean;
}

export interface WidgetData {
  kind: "knots" | "basis" | "comb" | "hodograph" | "matrix" | "uv" | "colours";
  object: string;
  at: string[];
  measure: string | null;
}

export interface FigureData {
  id: string;
  definition: string;
  /** The address of the definition. */
  file: string;
  view: string;
  alt: string;
  size: [number, number];
  controls: ControlData[];
  drag: string[];
  only: string[];
  colours: Record<string, string>;
  widgets: WidgetData[];
}
