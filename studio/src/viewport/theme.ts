/** The colours of the viewport, from the page's CSS variables. */

import { Vector3 } from "three";

import type { Rgba } from "../core/preview";
import type { GridColours } from "./scene/grid";

export interface Theme {
  background: Vector3;
  ground: Rgba;
  paper: Vector3;
  grid: GridColours;
  ink: Rgba;
  inkVector: Vector3;
  plaster: Rgba;
}

/** Reads the variables as an element has them; the browser resolves whatever notation they are in. */
export function readTheme(element: HTMLElement): Theme {
  const probe = document.createElement("span");
  probe.style.display = "none";
  element.append(probe);
  const colour = (name: string): Rgba => {
    probe.style.color = `var(--viewport-${name})`;
    return parseColour(getComputedStyle(probe).color);
  };
  const vector = (name: string) => {
    const [red, green, blue] = colour(name);
    return new Vector3(red / 255, green / 255, blue / 255);
  };
  const theme: Theme = {
    background: vector("background"),
    ground: colour("background"),
    paper: vector("paper"),
    grid: {
      minor: vector("grid-minor"),
      major: vector("grid-major"),
      x: vector("axis-x"),
      y: vector("axis-y"),
      z: vector("axis-z"),
    },
    ink: colour("ink"),
    inkVector: vector("ink"),
    plaster: colour("plaster"),
  };
  probe.remove();
  return theme;
}

/**
 * What browsers compute colours to: `rgb(1, 2, 3)`, `rgba(1, 2, 3, 0.5)`, `rgb(1 2 3 / 50%)`, `color(srgb 1 0.5 0)`.
 * Exported for tests.
 */
export function parseColour(text: string): Rgba {
  const scale = text.startsWith("color(") ? 255 : 1;
  const numbers = [...text.matchAll(/(?<![a-z])([\d.]+)(%?)/g)].map(([, number, percent]) => Number(number) / (percent ? 100 : 1));
  const [red = 0, green = 0, blue = 0, alpha = 1] = numbers;
  return [Math.round(red * scale), Math.round(green * scale), Math.round(blue * scale), Math.round(alpha * 255)];
}
