/** The wire to the session: requests out, events and geometry in, joined again when it breaks. */

import type { Ask } from "./protocol/Ask";
import type { Event } from "./protocol/Event";
import type { Request } from "./protocol/Request";

export type ConnectionState = "joining" | "open" | "lost" | "closed";

/** What a request came to. */
export type Answer = Extract<Event, { event: "done" | "rows" | "pictures" | "copied" | "scripts" | "explained" | "nurbs" }>;

/** A request that the session refused, with its reason. */
export class Refusal extends Error {}

export interface Listener {
  event(event: Event): void;
  geometry(bytes: ArrayBuffer): void;
  state(state: ConnectionState): void;
}

interface Waiting {
  resolve(answer: Answer): void;
  reject(reason: Error): void;
}

const FIRST_WAIT = 250;
const LONGEST_WAIT = 5000;

export class Connection {
  #url: string;
  #listener: Listener;
  #socket: WebSocket | undefined;
  #seq = 0;
  #waiting = new Map<number, Waiting>();
  #wait = FIRST_WAIT;
  #closed = false;

  constructor(url: string, listener: Listener) {
    this.#url = url;
    this.#listener = listener;
    this.#join();
  }

  /** Sends a request; gives what came of it. */
  ask(ask: Ask): Promise<Answer> {
    const socket = this.#socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) {
      return Promise.reject(new Refusal("The connection to Katydid is lost"));
    }
    const seq = ++this.#seq;
    const request: Request = { seq, ask };
    return new Promise((resolve, reject) => {
      this.#waiting.set(seq, { resolve, reject });
      socket.send(JSON.stringify(request));
    });
  }

  close(): void {
    this.#closed = true;
    this.#socket?.close();
    this.#listener.state("closed");
  }

  #join(): void {
    this.#listener.state("joining");
    const socket = new WebSocket(this.#url);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    socket.onopen = () => {
      this.#wait = FIRST_WAIT;
      this.#listener.state("open");
    };
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data === "string") this.#take(JSON.parse(data) as Event);
      else this.#listener.geometry(data);
    };
    socket.onclose = () => this.#lost();
  }

  #take(event: Event): void {
    this.#listener.event(event);
    if (!("seq" in event)) return;
    const waiting = this.#waiting.get(event.seq);
    this.#waiting.delete(event.seq);
    if (event.event === "refused") waiting?.reject(new Refusal(event.reason));
    else waiting?.resolve(event);
  }

  #lost(): void {
    for (const waiting of this.#waiting.values()) waiting.reject(new Refusal("The connection to Katydid is lost"));
    this.#waiting.clear();
    if (this.#closed) return;
    this.#listener.state("lost");
    setTimeout(() => this.#join(), this.#wait);
    this.#wait = Math.min(this.#wait * 2, LONGEST_WAIT);
  }
}
