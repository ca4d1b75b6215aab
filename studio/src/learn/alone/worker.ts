/** The worker of a page of the book: the engine with the definitions of its figures. Nothing of them is kept. */

import { init, raw, type RawDocument } from "katydid-engine";

import type { FromWorker, ToWorker } from "./messages";

const host = globalThis as unknown as { postMessage(message: FromWorker, transfer?: Transferable[]): void };
const post = (message: FromWorker, ...transfer: Transferable[]) => host.postMessage(message, transfer);

const ready = init();
// Who does not wait for it yet hears of it when they do.
ready.catch(() => undefined);

const open = new Map<number, RawDocument>();
let isPlanned = false;

/** Bytes with a buffer of their own. */
const own = (bytes: Uint8Array) => bytes.slice().buffer as ArrayBuffer;

/** Sends what a definition has to tell. */
function tell(definition: number, document: RawDocument): void {
  for (const message of document.take()) {
    if (typeof message === "string") post({ is: "event", definition, text: message });
    else {
      const bytes = own(message);
      post({ is: "frame", definition, bytes }, bytes);
    }
  }
  // A journal of the edits is for documents that are kept.
  document.takeWritten();
}

/** Solves what is due once all requests that have come are carried out. */
function plan(): void {
  if (isPlanned || ![...open.values()].some((document) => document.isDue())) return;
  isPlanned = true;
  setTimeout(() => {
    isPlanned = false;
    for (const [definition, document] of open) {
      if (!document.isDue()) continue;
      document.work();
      tell(definition, document);
    }
    plan();
  }, 0);
}

async function begin(definition: number, name: string, text: string): Promise<void> {
  await ready;
  open.set(definition, new raw.Document(name, new TextEncoder().encode(text), new Uint8Array(), false));
}

function use(definition: number, what: (document: RawDocument) => void): void {
  const document = open.get(definition);
  if (!document) return;
  what(document);
  tell(definition, document);
  plan();
}

/** The first of the definitions that has it. */
function geometry(hash: string): ArrayBuffer | undefined {
  for (const document of open.values()) {
    const found = document.geometry(hash);
    if (found) return own(found);
  }
  return undefined;
}

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  switch (data.is) {
    case "open": {
      const { definition } = data;
      return void begin(definition, data.name, data.text).then(
        () => post({ is: "opened", definition }),
        (error: unknown) => post({ is: "opened", definition, reason: error instanceof Error ? error.message : String(error) }),
      );
    }
    case "join":
      return use(data.definition, (document) => document.join());
    case "ask":
      return use(data.definition, (document) => document.ask(data.request));
    case "geometry": {
      const bytes = geometry(data.hash);
      return bytes ? post({ is: "geometry", number: data.number, bytes }, bytes) : post({ is: "geometry", number: data.number });
    }
    case "close":
      open.get(data.definition)?.free();
      open.delete(data.definition);
  }
});
