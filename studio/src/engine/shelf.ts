/**
 * Documents in the browser's storage: the bytes that each began with, and its journal, a row of pieces. What is written is
 * committed at once, so that it is there when the worker is ended in the middle of a solve.
 */

export interface Stored {
  id: string;
  name: string;
  /** The definition as it was read or saved; none of an empty document. */
  bytes: ArrayBuffer | undefined;
  /** The Rhino model beside it. */
  model: { name: string; bytes: ArrayBuffer } | undefined;
  /** The file that it is saved to. */
  file: string | undefined;
  isLocked: boolean;
  isChanged: boolean;
  /** When it was last worked on, in milliseconds since 1970. */
  at: number;
}

interface Piece {
  document: string;
  bytes: Uint8Array<ArrayBuffer>;
}

const NAME = "katydid";
const VERSION = 1;
/** So many documents that were never changed are kept. */
const MOST_UNCHANGED = 20;

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's storage failed"));
  });
}

export class Shelf {
  #base: IDBDatabase;

  private constructor(base: IDBDatabase) {
    this.#base = base;
  }

  static async open(): Promise<Shelf> {
    const request = indexedDB.open(NAME, VERSION);
    request.onupgradeneeded = () => {
      const base = request.result;
      base.createObjectStore("documents", { keyPath: "id" });
      base.createObjectStore("pieces", { autoIncrement: true }).createIndex("document", "document");
    };
    return new Shelf(await done(request));
  }

  get(id: string): Promise<Stored | undefined> {
    return done(this.#base.transaction("documents").objectStore("documents").get(id) as IDBRequest<Stored | undefined>);
  }

  /** All of them, the one that was worked on last first. */
  async all(): Promise<Stored[]> {
    const all = await done(this.#base.transaction("documents").objectStore("documents").getAll() as IDBRequest<Stored[]>);
    return all.sort((a, b) => b.at - a.at);
  }

  async put(stored: Stored): Promise<void> {
    const change = this.#base.transaction("documents", "readwrite");
    const put = done(change.objectStore("documents").put(stored));
    change.commit();
    await put;
  }

  async remove(id: string): Promise<void> {
    const change = this.#base.transaction(["documents", "pieces"], "readwrite");
    change.objectStore("documents").delete(id);
    await clear(change.objectStore("pieces"), id);
  }

  /** Forgets the oldest of those that are as they were saved. */
  async tidy(): Promise<void> {
    const idle = (await this.all()).filter(({ isChanged }) => !isChanged);
    for (const { id } of idle.slice(MOST_UNCHANGED)) await this.remove(id);
  }

  /** The journal of a document. */
  async journal(id: string): Promise<Uint8Array<ArrayBuffer>> {
    const pieces = await done(
      this.#base.transaction("pieces").objectStore("pieces").index("document").getAll(id) as IDBRequest<Piece[]>,
    );
    const whole = new Uint8Array(pieces.reduce((sum, { bytes }) => sum + bytes.length, 0));
    let at = 0;
    for (const { bytes } of pieces) {
      whole.set(bytes, at);
      at += bytes.length;
    }
    return whole;
  }

  /** Writes into a journal: behind what is there, or instead of it. */
  async write(id: string, writes: [boolean, Uint8Array<ArrayBuffer>][]): Promise<void> {
    const change = this.#base.transaction("pieces", "readwrite");
    const pieces = change.objectStore("pieces");
    const requests: Promise<unknown>[] = [];
    for (const [isMore, bytes] of writes) {
      if (!isMore) requests.push(clear(pieces, id));
      if (bytes.length > 0) requests.push(done(pieces.add({ document: id, bytes } satisfies Piece)));
    }
    // Only what asks nothing back can be committed at once.
    if (writes.every(([isMore]) => isMore)) change.commit();
    await Promise.all(requests);
  }
}

/** Takes all pieces of a document away. Requests of one change are done in order: those that come later stay. */
function clear(pieces: IDBObjectStore, document: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const request = pieces.index("document").getAllKeys(document);
    request.onsuccess = () => {
      for (const key of request.result) pieces.delete(key);
      resolve();
    };
    request.onerror = () => reject(request.error ?? new Error("the browser's storage failed"));
  });
}
