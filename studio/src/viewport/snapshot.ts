/** What is on a canvas that was just drawn on: as a picture, and pixel by pixel. */

import type { Rgba } from "../core/preview";
import type { TextLayer } from "./overlay/texts";

/** The canvas with its texts, as PNG. */
export function pngOf(canvas: HTMLCanvasElement, texts: TextLayer, ratio: number): Promise<Blob | null> {
  const copy = document.createElement("canvas");
  if (!paintOn(copy, canvas, texts, ratio)) return Promise.resolve(null);
  return new Promise((resolve) => copy.toBlob(resolve, "image/png"));
}

/** Paints the canvas with its texts on another one, which takes its size; gives whether it could. */
export function paintOn(copy: HTMLCanvasElement, canvas: HTMLCanvasElement, texts: TextLayer, ratio: number): boolean {
  if (copy.width !== canvas.width || copy.height !== canvas.height) {
    copy.width = canvas.width;
    copy.height = canvas.height;
  }
  const flat = copy.getContext("2d");
  if (!flat) return false;
  flat.setTransform(1, 0, 0, 1, 0, 0);
  flat.clearRect(0, 0, copy.width, copy.height);
  flat.drawImage(canvas, 0, 0);
  flat.scale(ratio, ratio);
  texts.paint(flat);
  return true;
}

/** The colour of a pixel, from the top left. Waits for the graphics card. */
export function pixelOf(gl: WebGLRenderingContext | WebGL2RenderingContext, ratio: number, x: number, y: number): Rgba {
  const bytes = new Uint8Array(4);
  const [column, row] = [Math.floor(x * ratio), gl.canvas.height - 1 - Math.floor(y * ratio)];
  gl.readPixels(column, row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return [bytes[0] ?? 0, bytes[1] ?? 0, bytes[2] ?? 0, bytes[3] ?? 0];
}
