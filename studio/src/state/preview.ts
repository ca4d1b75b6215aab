/** The geometry of each object: which is the newest, and its bytes once they are here. */

import type { Event } from "../core/protocol/Event";

/** Who draws geometry: the viewport. */
export interface PreviewSink {
  /** The objects whose geometry changed, each with the hash of it, or null where none is left. */
  changed(objects: [string, string | null][], draft: boolean): void;
  /** Bytes that came without being fetched. */
  bytes(bytes: ArrayBuffer): void;
  /** Everything is to be forgotten: another document is shown. */
  clear(): void;
}

let sink: PreviewSink | undefined;

export function setPreviewSink(next: PreviewSink | undefined): void {
  sink = next;
}

export function takePreview(event: Event): void {
  if (event.event === "document") sink?.clear();
  else if (event.event === "preview") sink?.changed(event.objects, event.draft);
}

export function takeGeometry(bytes: ArrayBuffer): void {
  sink?.bytes(bytes);
}
