/**
 * Which geometry of each object is the newest, and how its bytes get here. Small previews come over the socket, the
 * others are fetched by their hash; what is newer stops what is older, and what is already here is not fetched.
 */

import { decodePreview, type Preview } from "../core/preview";
import type { PreviewSink } from "../state/preview";

export interface GeometryListener {
  /** New geometry of an object. */
  put(object: string, preview: Preview): void;
  /** An object has none any more. */
  drop(object: string): void;
  /** All are gone. */
  clear(): void;
  /** Geometry could not be had or read: the old stays. */
  failed(object: string, reason: string): void;
}

/** How long bytes of the socket may follow the event that announces them, in milliseconds, before they are fetched. */
const PATIENCE = 40;
/** Geometry that came before it was announced is kept up to this many bytes; the rest is fetched then. */
const MOST_EARLY = 256e6;

interface Entry {
  /** The hash of what is shown, and the geometry itself. */
  shown: string | undefined;
  preview: Preview | undefined;
  /** The hash of what is on its way. */
  wanted: string | undefined;
  stop: AbortController | undefined;
}

const NOTHING: Entry = { shown: undefined, preview: undefined, wanted: undefined, stop: undefined };

export type Fetcher = (hash: string, signal: AbortSignal) => Promise<ArrayBuffer>;

export const fetchGeometry: Fetcher = async (hash, signal) => {
  const response = await fetch(`geometry/${encodeURIComponent(hash)}`, { signal, credentials: "same-origin" });
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
  return response.arrayBuffer();
};

export class GeometryStore implements PreviewSink {
  #listeners = new Set<GeometryListener>();
  #fetch: Fetcher;
  #entries = new Map<string, Entry>();
  #early = new Map<string, Preview>();
  #earlySize = 0;

  constructor(fetcher: Fetcher = fetchGeometry) {
    this.#fetch = fetcher;
  }

  /** Tells a listener of all that is here and of what changes; gives what ends that. */
  listen(listener: GeometryListener): () => void {
    this.#listeners.add(listener);
    for (const [object, { preview }] of this.#entries) if (preview) listener.put(object, preview);
    return () => this.#listeners.delete(listener);
  }

  #tell(what: (listener: GeometryListener) => void): void {
    for (const listener of this.#listeners) what(listener);
  }

  changed(objects: [string, string | null][]): void {
    for (const [object, hash] of objects) {
      if (hash === null) this.#drop(object);
      else this.#want(object, hash);
    }
    // Nobody announces these any more: what comes over the socket comes just before its event, or just after.
    this.#forgetEarly();
  }

  bytes(bytes: ArrayBuffer): void {
    const preview = this.#read(undefined, bytes);
    if (!preview) return;
    const entry = this.#entries.get(preview.object);
    if (entry?.wanted !== undefined) {
      this.#show(preview.object, entry, entry.wanted, preview);
    } else if (this.#earlySize + preview.size <= MOST_EARLY) {
      this.#earlySize += preview.size;
      this.#early.set(preview.object, preview);
    }
  }

  clear(): void {
    for (const { stop } of this.#entries.values()) stop?.abort();
    this.#entries.clear();
    this.#forgetEarly();
    this.#tell((listener) => listener.clear());
  }

  #forgetEarly(): void {
    this.#early.clear();
    this.#earlySize = 0;
  }

  #drop(object: string): void {
    const entry = this.#entries.get(object);
    if (!entry) return;
    entry.stop?.abort();
    this.#entries.delete(object);
    if (entry.shown !== undefined) this.#tell((listener) => listener.drop(object));
  }

  #want(object: string, hash: string): void {
    const entry = this.#entries.get(object) ?? { ...NOTHING };
    this.#entries.set(object, entry);
    if (entry.wanted === hash) return;
    entry.stop?.abort();
    entry.stop = undefined;
    entry.wanted = undefined;
    if (entry.shown === hash) return;
    entry.wanted = hash;
    const early = this.#early.get(object);
    if (early) this.#show(object, entry, hash, early);
    else void this.#get(object, entry, hash);
  }

  async #get(object: string, entry: Entry, hash: string): Promise<void> {
    const stop = new AbortController();
    entry.stop = stop;
    try {
      await pause(PATIENCE);
      if (stop.signal.aborted) return;
      const preview = decodePreview(await this.#fetch(hash, stop.signal));
      if (stop.signal.aborted) return;
      if (preview.object !== object) throw new Error("it is the geometry of something else");
      this.#show(object, entry, hash, preview);
    } catch (error) {
      if (stop.signal.aborted) return;
      entry.wanted = undefined;
      this.#tell((listener) => listener.failed(object, error instanceof Error ? error.message : String(error)));
    }
  }

  #show(object: string, entry: Entry, hash: string, preview: Preview): void {
    entry.stop?.abort();
    entry.stop = undefined;
    entry.wanted = undefined;
    entry.shown = hash;
    entry.preview = preview;
    this.#tell((listener) => listener.put(object, preview));
  }

  #read(object: string | undefined, bytes: ArrayBuffer): Preview | undefined {
    try {
      return decodePreview(bytes);
    } catch (error) {
      this.#tell((listener) => listener.failed(object ?? "", error instanceof Error ? error.message : String(error)));
      return undefined;
    }
  }
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
