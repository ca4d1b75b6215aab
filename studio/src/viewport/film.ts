/** A short film of the model on a turntable. */

import { zipOf, type ZipFile } from "../core/zip";
import type { Viewport } from "./Viewport";

/** One turn takes so many milliseconds, */
const TURN = 8_000;
/** in so many pictures a second, */
const RATE = 30;
/** or in so many pictures altogether, where the browser makes no films. */
const PICTURES = 72;

const FORMS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

export interface Film {
  bytes: Blob;
  /** The ending of its file's name. */
  ending: "webm" | "mp4" | "zip";
}

let isFilming = false;

export function isFilmed(): boolean {
  return isFilming;
}

/** Turns the model once before the camera; nothing while another film is made. */
export async function filmOf(viewport: Viewport): Promise<Film | undefined> {
  if (isFilming) return undefined;
  isFilming = true;
  try {
    const form = typeof MediaRecorder === "undefined" ? undefined : FORMS.find((one) => MediaRecorder.isTypeSupported(one));
    return form === undefined ? await pictures(viewport) : await recorded(viewport, form);
  } finally {
    isFilming = false;
  }
}

/** As it turns: a picture is where the model is at its time, however long the one before took. */
async function recorded(viewport: Viewport, form: string): Promise<Film> {
  const canvas = document.createElement("canvas");
  viewport.paint(canvas);
  const recorder = new MediaRecorder(canvas.captureStream(RATE), { mimeType: form, videoBitsPerSecond: 12_000_000 });
  const pieces: Blob[] = [];
  recorder.addEventListener("dataavailable", ({ data }) => pieces.push(data));
  const ended = new Promise((resolve) => recorder.addEventListener("stop", resolve, { once: true }));
  recorder.start();
  const start = performance.now();
  for (let done = 0; done < 1; ) {
    await nextFrame();
    const now = Math.min((performance.now() - start) / TURN, 1);
    viewport.panes.turn((now - done) * 2 * Math.PI);
    done = now;
    viewport.paint(canvas);
  }
  recorder.stop();
  await ended;
  return { bytes: new Blob(pieces, { type: form }), ending: form.startsWith("video/mp4") ? "mp4" : "webm" };
}

/** One after the other. */
async function pictures(viewport: Viewport): Promise<Film> {
  const files: ZipFile[] = [];
  for (let k = 0; k < PICTURES; k++) {
    const picture = await viewport.picture();
    const name = `turn-${String(k + 1).padStart(2, "0")}.png`;
    if (picture) files.push({ name, bytes: new Uint8Array(await picture.arrayBuffer()) });
    viewport.panes.turn((2 * Math.PI) / PICTURES);
    await nextFrame();
  }
  return { bytes: zipOf(files), ending: "zip" };
}

/** A page that is not seen draws no frames: it goes on all the same. */
function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, 200);
    requestAnimationFrame(() => {
      clearTimeout(timer);
      resolve();
    });
  });
}
