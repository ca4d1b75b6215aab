/** What page and worker say to each other. */

import type { Opening, Start } from "../app/files";

/** What the page can have the worker do, with what comes of it. */
export interface Calls {
  start(): Start;
  open(what: Opening): string;
  close(document: string): void;
  store(name: string, bytes: ArrayBuffer, isLocked: boolean): string;
  attach(document: string, name: string, bytes: ArrayBuffer): void;
  bytes(document: string, format: string): { name: string; bytes: ArrayBuffer };
  saved(document: string, name: string): void;
  convert(bytes: ArrayBuffer, format: string): ArrayBuffer;
  export(document: string, wishes: string): { name: string; bytes: ArrayBuffer };
  components(): string;
  component(guid: string): string | undefined;
  geometry(hash: string): ArrayBuffer;
  picture(hash: string): { bytes: ArrayBuffer; type: string };
  flush(): void;
}

export type CallName = keyof Calls;

export type ToWorker =
  | { is: "call"; number: number; name: CallName; words: unknown[] }
  /** `known` where this page had the document before it was loaded anew: what is restored are its own edits. */
  | { is: "join"; document: string; known: boolean; locked: boolean }
  | { is: "ask"; request: string; forgetsModel: boolean };

export type FromWorker =
  | { is: "done"; number: number; value: unknown }
  | { is: "failed"; number: number; reason: string }
  /** The document is open; or why it cannot be. */
  | { is: "joined"; reason?: string }
  | { is: "event"; text: string }
  | { is: "geometry"; bytes: ArrayBuffer };
