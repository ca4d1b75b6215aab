/** A small drawing with its own scale. */

import { draw } from "../elements";

export const HUES = ["blue", "orange", "green", "red", "purple", "teal", "pink", "grey"] as const;
export const hue = (index: number): string => `var(--${HUES[index % HUES.length] ?? "grey"})`;

/** Draws in boxes of this many pixels; the page scales them. */
export const WIDTH = 640;
const EDGE = 22;

export class Plot {
  readonly svg: SVGSVGElement;
  readonly height: number;
  #x: (x: number) => number;
  #y: (y: number) => number;

  /** Shows a range of x and y; with `isEven` both have one scale. */
  constructor(label: string, height: number, [x0, x1]: [number, number], [y0, y1]: [number, number], isEven = false) {
    this.height = height;
    this.svg = draw("svg", { viewBox: `0 0 ${WIDTH} ${height}`, role: "img", "aria-label": label });
    const [w, h] = [WIDTH - 2 * EDGE, height - 2 * EDGE];
    let [sx, sy] = [w / (x1 - x0 || 1), h / (y1 - y0 || 1)];
    if (isEven) sx = sy = Math.min(sx, sy);
    const [mx, my] = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.#x = (x) => WIDTH / 2 + sx * (x - mx);
    this.#y = (y) => height / 2 - sy * (y - my);
  }

  place([x, y]: readonly [number, number]): [number, number] {
    return [this.#x(x), this.#y(y)];
  }

  line(points: readonly (readonly [number, number])[], attributes: Record<string, string | number>): void {
    const told = points.map((point) => this.place(point).map((x) => x.toFixed(1)).join(",")).join(" ");
    this.svg.append(draw("polyline", { points: told, fill: "none", "stroke-width": 2, ...attributes }));
  }

  dot(point: readonly [number, number], attributes: Record<string, string | number>): void {
    const [cx, cy] = this.place(point);
    this.svg.append(draw("circle", { cx, cy, r: 5, ...attributes }));
  }

  text(point: readonly [number, number], text: string, attributes: Record<string, string | number> = {}): void {
    const [x, y] = this.place(point);
    this.svg.append(draw("text", { x, y, "text-anchor": "middle", ...attributes }, text));
  }
}
