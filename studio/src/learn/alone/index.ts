/** A site without a server: the engine is in a worker beside the page. */

import { Waiters, type Answer, type Listener } from "../../core/connection";
import type { Ask } from "../../core/protocol/Ask";
import type { Event } from "../../core/protocol/Event";
import { addressOf } from "../../engine/link";
import type { Line, Transport } from "../transport";
import { page, word } from "../words";
import type { FromWorker, ToWorker } from "./messages";

interface Waiting<T> {
  resolve(value: T): void;
  reject(reason: Error): void;
}

export class Ways implements Transport {
  #worker: Worker | undefined;
  #last = 0;
  #opening = new Map<number, Waiting<string>>();
  #geometry = new Map<number, Waiting<ArrayBuffer>>();
  #lines = new Map<number, WorkerLine>();

  #begun(): Worker {
    if (this.#worker) return this.#worker;
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#take(data);
    // A fault of the engine ends it with the figures that it had; those that are begun later have a new one.
    worker.onerror = (event: ErrorEvent) => {
      event.preventDefault();
      worker.terminate();
      this.#worker = undefined;
      const fault = new Error(word("no-engine"));
      for (const waiting of [...this.#opening.values(), ...this.#geometry.values()]) waiting.reject(fault);
      for (const line of [...this.#lines.values()]) line.close();
      this.#opening.clear();
      this.#geometry.clear();
    };
    this.#worker = worker;
    return worker;
  }

  /** The worker loads the engine as soon as it is there. */
  prepare(): void {
    this.#begun();
  }

  send(message: ToWorker): void {
    this.#begun().postMessage(message);
  }

  /** Lets go of a definition, where the worker that has it is still there. */
  close(definition: number): void {
    this.#lines.delete(definition);
    this.#worker?.postMessage({ is: "close", definition } satisfies ToWorker);
  }

  #take(message: FromWorker): void {
    switch (message.is) {
      case "opened": {
        const waiting = this.#opening.get(message.definition);
        this.#opening.delete(message.definition);
        if (message.reason === undefined) waiting?.resolve(String(message.definition));
        else waiting?.reject(new Error(message.reason));
        return;
      }
      case "event":
        return this.#lines.get(message.definition)?.event(JSON.parse(message.text) as Event);
      case "frame":
        return this.#lines.get(message.definition)?.listener.geometry(message.bytes);
      case "geometry": {
        const waiting = this.#geometry.get(message.number);
        this.#geometry.delete(message.number);
        if (message.bytes) waiting?.resolve(message.bytes);
        else waiting?.reject(new Error(word("no-engine")));
      }
    }
  }

  open(name: string, text: string): Promise<string> {
    const definition = ++this.#last;
    return new Promise((resolve, reject) => {
      this.#opening.set(definition, { resolve, reject });
      this.send({ is: "open", definition, name, text });
    });
  }

  connect(document: string, listener: Listener): Line {
    const definition = Number(document);
    const line = new WorkerLine(this, definition, listener);
    this.#lines.set(definition, line);
    listener.state("open");
    this.send({ is: "join", definition });
    return line;
  }

  geometry(hash: string, signal: AbortSignal): Promise<ArrayBuffer> {
    const number = ++this.#last;
    return new Promise((resolve, reject) => {
      signal.addEventListener("abort", () => {
        this.#geometry.delete(number);
        reject(new DOMException("", "AbortError"));
      });
      this.#geometry.set(number, { resolve, reject });
      this.send({ is: "geometry", number, hash });
    });
  }

  async studio(name: string, text: string): Promise<string | undefined> {
    const studio = new URL(`${page.root}../studio.html`, location.href);
    return await addressOf(studio.href, name, new TextEncoder().encode(text));
  }
}

class WorkerLine implements Line {
  readonly listener: Listener;
  #ways: Ways;
  #definition: number;
  #waiters = new Waiters();

  constructor(ways: Ways, definition: number, listener: Listener) {
    this.#ways = ways;
    this.#definition = definition;
    this.listener = listener;
  }

  event(event: Event): void {
    this.listener.event(event);
    this.#waiters.take(event);
  }

  ask(ask: Ask): Promise<Answer> {
    const [seq, answer] = this.#waiters.wait();
    this.#ways.send({ is: "ask", definition: this.#definition, request: JSON.stringify({ seq, ask }) });
    return answer;
  }

  close(): void {
    this.#ways.close(this.#definition);
    this.#waiters.fail(word("no-engine"));
    this.listener.state("closed");
  }
}
