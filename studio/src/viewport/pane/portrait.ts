/** A small picture of the viewport, taken when the page is left. */

import { documentStore } from "../../state/document";
import { keepPicture } from "../../state/pictures";
import { viewportStore } from "../settings";
import type { Viewport } from "../Viewport";

const WIDTH = 320;
const HEIGHT = 200;

/** Keeps a picture for the start page whenever the page is left; gives what ends that. */
export function portray(viewport: Viewport, host: HTMLElement): () => void {
  const leave = () => {
    const { document } = documentStore.getState();
    const of = document?.path ?? document?.name;
    if (!of || viewportStore.getState().isEmpty) return;
    // What the card has drawn can be read until the page draws anew.
    viewport.draw();
    const picture = reduced([...host.querySelectorAll("canvas")]);
    if (picture) keepPicture(of, picture);
  };
  addEventListener("pagehide", leave);
  return () => removeEventListener("pagehide", leave);
}

/** The middle of some canvases that lie over each other, small. */
function reduced(sheets: readonly HTMLCanvasElement[]): string | undefined {
  const small = document.createElement("canvas");
  [small.width, small.height] = [WIDTH, HEIGHT];
  const context = small.getContext("2d");
  if (!context) return undefined;
  for (const { width, height } of sheets) if (width === 0 || height === 0) return undefined;
  for (const sheet of sheets) {
    const scale = Math.max(WIDTH / sheet.width, HEIGHT / sheet.height);
    const [w, h] = [sheet.width * scale, sheet.height * scale];
    context.drawImage(sheet, (WIDTH - w) / 2, (HEIGHT - h) / 2, w, h);
  }
  return small.toDataURL("image/webp", 0.82);
}
