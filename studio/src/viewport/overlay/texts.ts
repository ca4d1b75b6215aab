/** Texts of the model as elements over the picture: they can be read aloud, and are sharp at every size. */

import { Vector3, type Camera } from "three";

import type { Rgba } from "../../core/preview";
import type { Model } from "../scene/model";

/** More than this at once slow the page down: the nearest are shown. */
const MOST = 300;
const USUAL = 13;
const SMALLEST = 5;
const GREATEST = 160;

export interface TextView {
  camera: Camera;
  /** Of the pane in the element, in pixels. */
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface PlacedText {
  text: string;
  x: number;
  y: number;
  depth: number;
  size: number;
  colour: Rgba;
}

export class TextLayer {
  readonly element: HTMLElement;
  #spans: HTMLElement[] = [];
  #shown: PlacedText[] = [];

  readonly #usual: number;

  /** `usual` is the size of texts that have none of their own, in pixels. */
  constructor(parent: HTMLElement, usual: number = USUAL) {
    this.#usual = usual;
    this.element = document.createElement("div");
    this.element.className = "viewport-texts";
    parent.append(this.element);
  }

  /** Shows the texts of all panes; gives how many there are, and how many are shown. */
  show(model: Model, views: readonly TextView[]): { all: number; shown: number } {
    const placed = views.flatMap((view) => placeTexts(model, view, this.#usual));
    const shown = placed.length > MOST ? placed.sort((a, b) => a.depth - b.depth).slice(0, MOST) : placed;
    while (this.#spans.length < shown.length) {
      const span = document.createElement("span");
      this.#spans.push(span);
      this.element.append(span);
    }
    while (this.#spans.length > shown.length) this.#spans.pop()?.remove();
    shown.forEach((text, at) => {
      const span = this.#spans[at] as HTMLElement;
      if (span.textContent !== text.text) span.textContent = text.text;
      span.style.transform = `translate(${text.x.toFixed(1)}px, ${text.y.toFixed(1)}px) translateY(-100%)`;
      span.style.fontSize = `${text.size.toFixed(1)}px`;
      span.style.color = cssColour(text.colour);
    });
    this.#shown = shown;
    return { all: placed.length, shown: shown.length };
  }

  /** Writes the texts that are shown on a picture. */
  paint(picture: CanvasRenderingContext2D): void {
    const { fontFamily } = getComputedStyle(this.element);
    picture.textBaseline = "bottom";
    for (const { text, x, y, size, colour } of this.#shown) {
      picture.font = `${size}px ${fontFamily}`;
      picture.fillStyle = cssColour(colour);
      picture.fillText(text, x, y);
    }
  }

  dispose(): void {
    this.element.remove();
  }
}

/** Where the texts of the model are in a pane. */
export function placeTexts(model: Model, { camera, left, top, width, height }: TextView, usual: number = USUAL): PlacedText[] {
  const placed: PlacedText[] = [];
  const point = new Vector3();
  for (const { preview, parts } of model.objects.values()) {
    for (const { part, slot } of parts) {
      const colour = model.table.get(slot);
      if (part.kind !== "texts" || colour[3] === 0) continue;
      part.texts.forEach((text, at) => {
        point.fromArray(part.positions, at * 3);
        point.set(
          point.x + preview.origin[0] - model.origin[0],
          point.y + preview.origin[1] - model.origin[1],
          point.z + preview.origin[2] - model.origin[2],
        );
        const eye = point.clone().applyMatrix4(camera.matrixWorldInverse);
        const { x, y, z } = point.project(camera);
        if (Math.abs(x) > 1.05 || Math.abs(y) > 1.05 || Math.abs(z) > 1) return;
        const size = part.textHeight > 0 ? part.textHeight * pixelsAUnit(camera, eye.z, height) : usual;
        if (size < SMALLEST) return;
        placed.push({
          text,
          x: left + (x + 1) * 0.5 * width,
          y: top + (1 - y) * 0.5 * height,
          depth: z,
          size: Math.min(size, GREATEST),
          colour,
        });
      });
    }
  }
  return placed;
}

function pixelsAUnit(camera: Camera, depth: number, height: number): number {
  const [scale, isParallel] = [camera.projectionMatrix.elements[5] ?? 1, camera.projectionMatrix.elements[15] === 1];
  return (scale * height * 0.5) / (isParallel ? 1 : Math.max(-depth, 1e-9));
}

function cssColour([red, green, blue, alpha]: Rgba): string {
  return `rgb(${red} ${green} ${blue} / ${alpha / 255})`;
}
