/** What is on a canvas that was just drawn on: as a picture, and pixel by pixel. */

import type { Rgba } from "../core/preview";
import type { TextLayer } from "./overlay/texts";

/** The canvas with its texts, as PNG. */
export function pngOf(canvas: HTMLCanvasElement, texts: TextLayer, ratio: number): Promise<Blob | null> {
  const copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height;
  const flat = copy.getContext("2d");
  if (!flat) return Promise.resolve(null);
  flat.drawImage(canvas, 0, 0);
  flat.scale(ratio, ratio);
  texts.paint(flat);
  return new Promise((resolve) => copy.toBlob(resolve, "image/png"));
}

/** The colour of a pixel, from the top left. Waits for the graphics card. */
export function pixelOf(gl: WebGLRenderingContext | WebGL2RenderingContext, ratio: number, x: number, y: number): Rgba {
  const bytes = new Uint8Array(4);
  const [column, row] = [Math.floor(x * ratio), gl.canvas.height - 1 - Math.floor(y * ratio)];
  gl.readPixels(column, row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return [bytes[0] ?? 0, bytes[1] ?? 0, bytes[2] ?? 0, bytes[3] ?? 0];
}
