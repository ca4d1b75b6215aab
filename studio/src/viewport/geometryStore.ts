/**
 * Which geometry of each object is the newest, and how its bytes get here. Small previews come over the socket, the
 * others are fetched by their hash; what is newer stops what is older, and what is already here is not fetched.
 */

import { engine } from "#engine";

import { placeOf, type Framed, type Frames } from "../core/frames";
import { decodePreview, type Preview } from "../core/preview";
import type { GeometrySink } from "../state/preview";

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

/** As many are fetched at a time: a browser has six connections to a server, and refuses thousands of requests at once. */
const MOST_FETCHES = 6;
/** While many more wait, what was fetched is shown together after so many milliseconds: not a picture for each of them. */
const TOGETHER = 250;

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
  if (engine) return engine.geometry(hash);
  const response = await fetch(`geometry/${encodeURIComponent(hash)}`, { signal, credentials: "same-origin" });
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
  return response.arrayBuffer();
};

export class GeometryStore implements GeometrySink {
  #listeners = new Set<GeometryListener>();
  #fetch: Fetcher;
  #entries = new Map<string, Entry>();
  #fetches = 0;
  /** Those who wait for their turn to fetch. */
  #line: (() => void)[] = [];
  /** What was fetched and is not shown yet. */
  #fetched: (() => void)[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;

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

  changed(objects: [string, string | null][], frames: Frames): void {
    for (const [object, hash] of objects) {
      if (hash === null) this.#drop(object);
      else this.#want(object, hash, frames.get(hash));
    }
  }

  clear(): void {
    for (const { stop } of this.#entries.values()) stop?.abort();
    this.#entries.clear();
    this.#tell((listener) => listener.clear());
  }

  #drop(object: string): void {
    const entry = this.#entries.get(object);
    if (!entry) return;
    entry.stop?.abort();
    this.#entries.delete(object);
    if (entry.shown !== undefined) this.#tell((listener) => listener.drop(object));
  }

  #want(object: string, hash: string, framed: Framed | undefined): void {
    const entry = this.#entries.get(object) ?? { ...NOTHING };
    this.#entries.set(object, entry);
    if (entry.wanted === hash) return;
    entry.stop?.abort();
    entry.stop = undefined;
    entry.wanted = undefined;
    if (entry.shown === hash) return;
    entry.wanted = hash;
    if (framed) this.#take(object, entry, hash, () => decodePreview(...placeOf(framed)));
    else void this.#get(object, entry, hash);
  }

  async #get(object: string, entry: Entry, hash: string): Promise<void> {
    const stop = new AbortController();
    entry.stop = stop;
    try {
      const bytes = await this.#inTurn(stop.signal, () => this.#fetch(hash, stop.signal));
      if (!bytes) return;
      this.#fetched.push(() => {
        if (!stop.signal.aborted) this.#take(object, entry, hash, () => decodePreview(bytes));
      });
      if (this.#line.length <= MOST_FETCHES) this.#showFetched();
      else this.#timer ??= setTimeout(() => this.#showFetched(), TOGETHER);
    } catch (error) {
      if (!stop.signal.aborted) this.#fail(object, entry, error);
    }
  }

  #showFetched(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    for (const show of this.#fetched.splice(0)) show();
  }

  /** Fetches when it is its turn; nothing where it was stopped meanwhile. */
  async #inTurn<T>(signal: AbortSignal, fetch: () => Promise<T>): Promise<T | undefined> {
    while (this.#fetches >= MOST_FETCHES) await new Promise<void>((go) => this.#line.push(go));
    this.#fetches += 1;
    try {
      return signal.aborted ? undefined : await fetch();
    } finally {
      this.#fetches -= 1;
      this.#line.shift()?.();
    }
  }

  /** Shows what was read, or says why it cannot be. */
  #take(object: string, entry: Entry, hash: string, read: () => Preview): void {
    let preview: Preview;
    try {
      preview = read();
      if (preview.object !== object) throw new Error("it is the geometry of something else");
    } catch (error) {
      return this.#fail(object, entry, error);
    }
    this.#show(object, entry, hash, preview);
  }

  #fail(object: string, entry: Entry, error: unknown): void {
    entry.wanted = undefined;
    this.#tell((listener) => listener.failed(object, error instanceof Error ? error.message : String(error)));
  }

  #show(object: string, entry: Entry, hash: string, preview: Preview): void {
    entry.stop?.abort();
    entry.stop = undefined;
    entry.wanted = undefined;
    entry.shown = hash;
    entry.preview = preview;
    this.#tell((listener) => listener.put(object, preview));
  }
}
