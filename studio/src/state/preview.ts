/** The geometry of each object: which is the newest, and its bytes once they are here. */

import { FrameBuffer, type Frames } from "../core/frames";
import type { Event } from "../core/protocol/Event";

/** Who has geometry: of the model, or of what is looked at closely. */
export interface GeometrySink {
  /** The objects whose geometry changed, each with the hash of it, or null where none is left. */
  changed(objects: [string, string | null][], frames: Frames): void;
  /** Everything is to be forgotten: another document is shown. */
  clear(): void;
}

interface Sinks {
  preview: GeometrySink | undefined;
  analysis: GeometrySink | undefined;
}

const sinks: Sinks = { preview: undefined, analysis: undefined };
const frames = new FrameBuffer();

export function setGeometrySink(what: keyof Sinks, next: GeometrySink | undefined): void {
  sinks[what] = next;
}

export function takePreview(event: Event): void {
  if (event.event === "document") {
    sinks.preview?.clear();
    sinks.analysis?.clear();
  } else if (event.event === "preview") {
    sinks.preview?.changed(event.objects, frames.take());
  } else if (event.event === "analysed") {
    sinks.analysis?.changed(event.objects, frames.take());
  }
}

/** Bytes that came without being fetched. */
export function takeGeometry(frame: ArrayBuffer): void {
  frames.put(frame);
}
