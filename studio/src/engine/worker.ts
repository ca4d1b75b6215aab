/** The worker: the engine, the document that is shown, and the browser's storage. */

import { init, raw, type RawDocument } from "katydid-engine";

import type { Start } from "../app/files";
import type { Calls, CallName, FromWorker, ToWorker } from "./calls";
import { Shelf, type Stored } from "./shelf";

/** What the journal has waiting is written after so long. */
const SOON = 160;
/** Another window has a document where it does not let go of it in so many milliseconds. */
const LOCK_WAIT = 2000;

const host = globalThis as unknown as { postMessage(message: FromWorker, transfer?: Transferable[]): void; katydidProgress?: (event: string) => void };
const post = (message: FromWorker, ...transfer: Transferable[]) => host.postMessage(message, transfer);
host.katydidProgress = (text) => post({ is: "event", text });

const ready = init();
const shelf = Shelf.open();
// Who does not wait for these yet hears of it when they do.
ready.catch(() => undefined);
shelf.catch(() => undefined);

/** The document that is shown. */
let shown: { id: string; document: RawDocument; stored: Stored; isKept: boolean } | undefined;
let isPlanned = false;
/** What is being written: a solve that is ended with its worker must not take it along. */
let written: Promise<void> = Promise.resolve();
let timer: ReturnType<typeof setTimeout> | undefined;

const reasonOf = (error: unknown) => (error instanceof Error ? error.message : String(error));

/** Bytes with a buffer of their own. */
function own(bytes: Uint8Array): ArrayBuffer {
  return bytes.slice().buffer as ArrayBuffer;
}

/** Sends what there is to tell, and writes what there is to write. */
function flush(): void {
  if (!shown) return;
  for (const message of shown.document.take()) {
    if (typeof message === "string") post({ is: "event", text: message });
    else {
      const bytes = own(message);
      post({ is: "geometry", bytes }, bytes);
    }
  }
  const writes = shown.document.takeWritten() as [boolean, Uint8Array<ArrayBuffer>][];
  if (!shown.isKept) return;
  if (writes.length > 0) {
    const { id } = shown;
    const before = written;
    written = Promise.all([shelf, before]).then(([shelf]) => shelf.write(id, writes)).catch(complain);
  }
  const { stored, document } = shown;
  const [name, isChanged] = [document.name(), document.isChanged()];
  if (stored.name !== name || stored.isChanged !== isChanged) {
    Object.assign(stored, { name, isChanged, at: Date.now() });
    const record = { ...stored };
    void shelf.then((shelf) => shelf.put(record)).catch(complain);
  }
}

function complain(error: unknown): void {
  const notice = { event: "notice", level: "warning", text: `edits are not kept: ${reasonOf(error)}` };
  post({ is: "event", text: JSON.stringify(notice) });
}

/** A fault of the engine ends it: the page hears of it as of any error that nobody catches. */
function fatal(error: unknown): void {
  setTimeout(() => {
    throw error;
  });
}

/** Does what is due once all requests that have come are carried out. */
function plan(): void {
  if (!shown) return;
  if (timer === undefined) {
    timer = setTimeout(() => {
      timer = undefined;
      shown?.document.tick();
      flush();
    }, SOON);
  }
  if (isPlanned || !shown.document.isDue()) return;
  isPlanned = true;
  setTimeout(() => {
    written
      .then(() => {
        isPlanned = false;
        if (!shown?.document.isDue()) return;
        shown.document.work();
        flush();
        plan();
      })
      .catch(fatal);
  }, 0);
}

/**
 * Lets nobody else write the journal of a document, as long as this worker is there; `false` where another does. A page that
 * is loaded anew waits for the worker of the page before to let go.
 */
function lock(id: string): Promise<boolean> {
  return new Promise((resolve) => {
    const held = () => {
      resolve(true);
      return new Promise<never>(() => undefined);
    };
    navigator.locks.request(`katydid ${id}`, { signal: AbortSignal.timeout(LOCK_WAIT) }, held).catch(() => resolve(false));
  });
}

async function join(id: string, known: boolean, locked: boolean): Promise<void> {
  await ready;
  const stored = await (await shelf).get(id);
  if (!stored) throw new Error("there is no such document in this browser");
  const isKept = shown?.id === id ? shown.isKept : await lock(id);
  const journal = await (await shelf).journal(id);
  const bytes = stored.bytes && new Uint8Array(stored.bytes);
  shown?.document.free();
  const document = new raw.Document(stored.name, bytes, journal, stored.isLocked || locked);
  if (stored.file !== undefined) document.isKeptIn(stored.file);
  if (known) document.keepRestored();
  if (stored.model) document.attach(stored.model.name, new Uint8Array(stored.model.bytes));
  shown = { id, document, stored, isKept };
  document.join();
  flush();
  if (!isKept) complain("another window has this document open");
  else await (await shelf).put({ ...stored, at: Date.now() });
  plan();
}

/** A document that is stored, as it stands, whether it is shown or not. */
async function withDocument<T>(id: string, use: (document: RawDocument) => T): Promise<T> {
  if (shown?.id === id) return use(shown.document);
  const stored = await (await shelf).get(id);
  if (!stored) throw new Error("there is no such document in this browser");
  const journal = await (await shelf).journal(id);
  const document = new raw.Document(stored.name, stored.bytes && new Uint8Array(stored.bytes), journal, false);
  try {
    return use(document);
  } finally {
    document.free();
  }
}

function stem(name: string): string {
  return name.replace(/\.(gh|ghx|kd)$/i, "") || "definition";
}

async function store(name: string, bytes: ArrayBuffer | undefined, isLocked: boolean): Promise<string> {
  const id = crypto.randomUUID();
  const changes = await shelf;
  await changes.put({ id, name, bytes, model: undefined, file: undefined, isLocked, isChanged: false, at: Date.now() });
  await changes.tidy();
  return id;
}

/** Keeps the Rhino model beside a document, or forgets it. */
async function keepModel(id: string, model: Stored["model"]): Promise<void> {
  const stored = shown?.id === id ? shown.stored : await (await shelf).get(id);
  if (!stored) throw new Error("there is no such document in this browser");
  stored.model = model;
  await (await shelf).put({ ...stored });
}

type Answers = { [name in CallName]: (...words: Parameters<Calls[name]>) => Promise<ReturnType<Calls[name]>> | ReturnType<Calls[name]> };

const answers: Answers = {
  async start(): Promise<Start> {
    const open = (await (await shelf).all()).map(({ id, name, isChanged }) => ({ id, name, changed: isChanged }));
    return { recent: [], gallery: JSON.parse(raw.gallery()) as Start["gallery"], open, version: raw.version(), local: false };
  },
  async open(what) {
    if ("gallery" in what) {
      const text = raw.galleryText(what.gallery);
      const listed = (JSON.parse(raw.gallery()) as Start["gallery"]).find(({ id }) => id === what.gallery);
      if (!text || !listed) throw new Error("there is no such definition in the gallery");
      return await store(listed.name, own(text), false);
    }
    if ("new" in what) return await store("", undefined, false);
    throw new Error("a page has no files of its own: drop the file on it");
  },
  async close(document) {
    await (await shelf).remove(document);
  },
  async store(name, bytes, isLocked) {
    // What cannot be read is not stored.
    raw.convert(new Uint8Array(bytes), "gh");
    return await store(stem(name), bytes, isLocked);
  },
  async attach(id, name, bytes) {
    const isShown = shown?.id === id;
    if (isShown) shown?.document.attach(name, new Uint8Array(bytes));
    await keepModel(id, { name, bytes });
  },
  bytes: (id, format) =>
    withDocument(id, (document) => ({ name: `${stem(document.name())}.${format}`, bytes: own(document.bytes(format)) })),
  async saved(id, name) {
    if (shown?.id !== id) return;
    shown.document.flush();
    const extension = /\.(gh|ghx|kd)$/i.exec(name)?.[1]?.toLowerCase() ?? "gh";
    Object.assign(shown.stored, { bytes: own(shown.document.bytes(extension)), file: name, isLocked: false });
    shown.document.saved(name);
    const record = { ...shown.stored, name, isChanged: false, at: Date.now() };
    await (await shelf).put(record);
  },
  convert: (bytes, format) => own(raw.convert(new Uint8Array(bytes), format)),
  export: (id, wishes) =>
    withDocument(id, (document) => {
      const { format } = JSON.parse(wishes) as { format: string };
      return { name: `${stem(document.name())}.${format}`, bytes: own(document.export(wishes)) };
    }),
  components: () => raw.components(),
  component: (guid) => raw.component(guid),
  geometry(hash) {
    const found = shown?.document.geometry(hash);
    if (!found) throw new Error("there is no such geometry");
    return own(found);
  },
  picture(hash) {
    const found = shown?.document.picture(hash);
    if (!found) throw new Error("there is no such picture");
    return { bytes: own(found[0]), type: found[1] };
  },
  flush() {
    shown?.document.flush();
  },
};

async function answer(number: number, name: CallName, words: unknown[]): Promise<void> {
  try {
    await ready;
    const call = answers[name] as (...words: unknown[]) => unknown;
    const value = await call(...words);
    post({ is: "done", number, value });
  } catch (error) {
    post({ is: "failed", number, reason: reasonOf(error) });
    if (error instanceof WebAssembly.RuntimeError) return fatal(error);
  }
  flush();
  plan();
}

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  switch (data.is) {
    case "call":
      return void answer(data.number, data.name, data.words);
    case "join":
      return void join(data.document, data.known, data.locked).then(
        () => post({ is: "joined" }),
        (error: unknown) => post({ is: "joined", reason: reasonOf(error) }),
      );
    case "ask":
      shown?.document.ask(data.request);
      if (shown && data.forgetsModel) void keepModel(shown.id, undefined).catch(complain);
      flush();
      plan();
  }
});
