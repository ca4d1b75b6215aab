/** The page's end: calls to the worker, and a line that speaks the protocol as the socket does. */

import type { DownloadFormat, ExportFormat, Opening, Start } from "../app/files";
import type { CatalogueEntry } from "../core/catalogue";
import { Refusal, Waiters, type Answer, type Line, type Listener } from "../core/connection";
import type { Ask } from "../core/protocol/Ask";
import type { Event } from "../core/protocol/Event";
import { t } from "../i18n";
import type { CallName, Calls, FromWorker, ToWorker } from "./calls";
import { keep, keepAgain } from "./keep";
import { addressOf, textOf } from "./link";
import type { Engine, Kept } from "./types";

/** A solve that does not end so long after it was cancelled is ended with its worker. */
const PATIENCE = 1500;

interface Waiting {
  resolve(value: unknown): void;
  reject(reason: Error): void;
}

export class Client implements Engine {
  #worker: Worker | undefined;
  #number = 0;
  #waiting = new Map<number, Waiting>();
  #line: WorkerLine | undefined;

  constructor() {
    addEventListener("pagehide", () => void this.call("flush").catch(() => undefined));
  }

  #begun(): Worker {
    if (this.#worker) return this.#worker;
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#take(data);
    // A fault of the engine ends it: a new one has the document as it was kept.
    worker.onerror = (event: ErrorEvent) => {
      event.preventDefault();
      this.#end(t("engine.failed"));
      this.#line?.broken(t("engine.failed"));
    };
    this.#worker = worker;
    return worker;
  }

  /** Ends the worker; who waits for it is told why. */
  #end(reason: string): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    for (const waiting of this.#waiting.values()) waiting.reject(new Error(reason));
    this.#waiting.clear();
  }

  #take(message: FromWorker): void {
    if (message.is === "done" || message.is === "failed") {
      const waiting = this.#waiting.get(message.number);
      this.#waiting.delete(message.number);
      if (message.is === "done") waiting?.resolve(message.value);
      else waiting?.reject(new Error(message.reason));
    } else this.#line?.take(message);
  }

  send(message: ToWorker, transfer: Transferable[] = []): void {
    this.#begun().postMessage(message, transfer);
  }

  call<N extends CallName>(name: N, ...words: Parameters<Calls[N]>): Promise<ReturnType<Calls[N]>> {
    const number = ++this.#number;
    return new Promise((resolve, reject) => {
      this.#waiting.set(number, { resolve: resolve as (value: unknown) => void, reject });
      this.send({ is: "call", number, name, words });
    });
  }

  connect(document: string, listener: Listener): Line {
    this.#line?.close();
    const line = new WorkerLine(this, document, listener, (reason) => this.#end(reason));
    this.#line = line;
    return line;
  }

  start(): Promise<Start> {
    return this.call("start");
  }

  open(what: Opening): Promise<string> {
    return this.call("open", what);
  }

  close(document: string): Promise<void> {
    return this.call("close", document);
  }

  portrait(gallery: string): string {
    return `./portraits/${encodeURIComponent(gallery)}.png`;
  }

  async upload(file: File, document: string | undefined, isLocked: boolean): Promise<string> {
    const bytes = await file.arrayBuffer();
    if (!file.name.toLowerCase().endsWith(".3dm")) return await this.call("store", file.name, bytes, isLocked);
    if (document === undefined) throw new Error(t("drop.modelFirst"));
    await this.call("attach", document, file.name, bytes);
    return document;
  }

  async bytes(document: string, format: DownloadFormat): Promise<Kept> {
    const { name, bytes } = await this.call("bytes", document, format);
    return { name, bytes: new Uint8Array(bytes) };
  }

  async text(file: File): Promise<string> {
    return new TextDecoder().decode(await this.call("convert", await file.arrayBuffer(), "ghx"));
  }

  async export(document: string, wishes: { format: ExportFormat; objects?: string; canvas?: boolean }): Promise<Kept> {
    const { name, bytes } = await this.call("export", document, JSON.stringify(wishes));
    return { name, bytes: new Uint8Array(bytes) };
  }

  async components(): Promise<CatalogueEntry[]> {
    return JSON.parse(await this.call("components")) as CatalogueEntry[];
  }

  async help(component: string): Promise<unknown> {
    const found = await this.call("component", component);
    if (found === undefined) throw new Error(t("help.failed"));
    return JSON.parse(found);
  }

  geometry(hash: string): Promise<ArrayBuffer> {
    return this.call("geometry", hash);
  }

  async picture(hash: string): Promise<string> {
    const { bytes, type } = await this.call("picture", hash);
    return URL.createObjectURL(new Blob([bytes], { type }));
  }

  async save(document: string, format: DownloadFormat): Promise<void> {
    const { name, bytes } = await this.bytes(document, format);
    const kept = await keep(document, name, bytes);
    if (kept !== undefined) await this.call("saved", document, kept);
  }

  /** Saves a document where it was saved before. */
  async saveAgain(document: string, name: string): Promise<void> {
    const format = /\.(gh|ghx|kd)$/i.exec(name)?.[1]?.toLowerCase() as DownloadFormat | undefined;
    const { bytes } = await this.bytes(document, format ?? "gh");
    await keepAgain(document, bytes);
    await this.call("saved", document, name);
  }

  async link(document: string): Promise<string> {
    const { name, bytes } = await this.bytes(document, "kd");
    return await addressOf(location.href, name, bytes);
  }

  async openLink(): Promise<string | undefined> {
    const found = await textOf(location.hash);
    return found && (await this.call("store", found.name, found.bytes.buffer, false));
  }
}

/** The line to the document that is shown. */
class WorkerLine implements Line {
  #client: Client;
  #document: string;
  #listener: Listener;
  #waiters = new Waiters();
  #end: (reason: string) => void;
  #isOpen = false;
  #isClosed = false;
  #path: string | null = null;
  #patience: ReturnType<typeof setTimeout> | undefined;

  constructor(client: Client, document: string, listener: Listener, end: (reason: string) => void) {
    this.#client = client;
    this.#document = document;
    this.#listener = listener;
    this.#end = end;
    this.#join(false);
  }

  #join(locked: boolean): void {
    this.#listener.state("joining");
    const key = `katydid.had.${this.#document}`;
    const known = locked || sessionStorage.getItem(key) !== null;
    sessionStorage.setItem(key, "");
    this.#client.send({ is: "join", document: this.#document, known, locked });
  }

  take(message: FromWorker): void {
    if (this.#isClosed) return;
    if (message.is === "joined") {
      this.#isOpen = message.reason === undefined;
      this.#listener.state(this.#isOpen ? "open" : "closed");
      if (message.reason !== undefined) this.#tell("error", message.reason);
    } else if (message.is === "event") {
      const event = JSON.parse(message.text) as Event;
      if (event.event === "document") this.#path = event.document.path ?? null;
      if (event.event === "patch" && event.document) this.#path = event.document.path ?? null;
      this.#listener.event(event);
      this.#waiters.take(event);
    } else if (message.is === "geometry") this.#listener.geometry(message.bytes);
  }

  #tell(level: string, text: string): void {
    this.#listener.event({ event: "notice", level, text });
  }

  async ask(ask: Ask): Promise<Answer> {
    if (!this.#isOpen) throw new Refusal(t("line.lost"));
    if (ask.ask === "save") return await this.#save();
    const [seq, answer] = this.#waiters.wait();
    this.#client.send({ is: "ask", request: JSON.stringify({ seq, ask }), forgetsModel: ask.ask === "detachModel" });
    if (ask.ask === "cancel") this.#watch(answer);
    return await answer;
  }

  async #save(): Promise<Answer> {
    if (this.#path === null) throw new Refusal(t("saveAs.hint"));
    try {
      await this.#client.saveAgain(this.#document, this.#path);
    } catch (error) {
      throw new Refusal(error instanceof Error ? error.message : String(error));
    }
    return { event: "done", seq: 0, revision: 0, made: [] };
  }

  /** The worker hears nothing while it solves: a solve that goes on is ended with it, and the document joined anew. */
  #watch(answer: Promise<Answer>): void {
    clearTimeout(this.#patience);
    this.#patience = setTimeout(() => {
      this.#end(t("status.cancelled"));
      this.broken(t("status.cancelled"));
    }, PATIENCE);
    const heard = () => clearTimeout(this.#patience);
    answer.then(heard, heard);
  }

  /** The worker is gone: a new one has the document as it was kept, and solves nothing until somebody says so. */
  broken(reason: string): void {
    if (this.#isClosed) return;
    const wasOpen = this.#isOpen;
    this.#isOpen = false;
    this.#waiters.fail(reason);
    this.#tell("error", reason);
    // What breaks the engine when it is opened would do so again.
    if (!wasOpen) return this.#listener.state("closed");
    this.#listener.state("lost");
    this.#join(true);
  }

  close(): void {
    this.#isClosed = true;
    this.#waiters.fail(t("line.lost"));
    this.#listener.state("closed");
  }
}
