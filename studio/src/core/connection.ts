/** The wire to the session: requests out, events and geometry in, joined again when it breaks. */

import type { Ask } from "./protocol/Ask";
import type { Event } from "./protocol/Event";
import type { Request } from "./protocol/Request";

export type ConnectionState = "joining" | "open" | "lost" | "closed";

/** What a request came to. */
export type Answer = Extract<Event, { event: "done" | "rows" | "pictures" | "copied" | "scripts" | "explained" | "nurbs" | "effects" | "solved" | "motion" }>;

/** A request that the session refused, with its reason. */
export class Refusal extends Error {}

export interface Listener {
  event(event: Event): void;
  geometry(bytes: ArrayBuffer): void;
  state(state: ConnectionState): void;
}

/** A line to a document: over a socket, or to the page's own engine. */
export interface Line {
  /** Sends a request; gives what came of it. */
  ask(ask: Ask): Promise<Answer>;
  close(): void;
}

interface Waiting {
  resolve(answer: Answer): void;
  reject(reason: Error): void;
}

/** Those who wait for answers, by the numbers of their requests. */
export class Waiters {
  #seq = 0;
  #waiting = new Map<number, Waiting>();

  /** A new request: its number, and what will come of it. */
  wait(): [number, Promise<Answer>] {
    const seq = ++this.#seq;
    return [seq, new Promise((resolve, reject) => this.#waiting.set(seq, { resolve, reject }))];
  }

  /** Gives an answer to who waits for it. */
  take(event: Event): void {
    if (!("seq" in event)) return;
    const waiting = this.#waiting.get(event.seq);
    this.#waiting.delete(event.seq);
    if (event.event === "refused") waiting?.reject(new Refusal(event.reason));
    else waiting?.resolve(event);
  }

  /** No answer will come any more. */
  fail(reason: string): void {
    for (const waiting of this.#waiting.values()) waiting.reject(new Refusal(reason));
    this.#waiting.clear();
  }
}

const FIRST_WAIT = 250;
const LONGEST_WAIT = 5000;

export class Connection implements Line {
  #url: string;
  #listener: Listener;
  #socket: WebSocket | undefined;
  #waiters = new Waiters();
  #wait = FIRST_WAIT;
  #closed = false;

  constructor(url: string, listener: Listener) {
    this.#url = url;
    this.#listener = listener;
    this.#join();
  }

  ask(ask: Ask): Promise<Answer> {
    const socket = this.#socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) {
      return Promise.reject(new Refusal("The connection to Katydid is lost"));
    }
    const [seq, answer] = this.#waiters.wait();
    const request: Request = { seq, ask };
    socket.send(JSON.stringify(request));
    return answer;
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
    this.#waiters.take(event);
  }

  #lost(): void {
    this.#waiters.fail("The connection to Katydid is lost");
    if (this.#closed) return;
    this.#listener.state("lost");
    setTimeout(() => this.#join(), this.#wait);
    this.#wait = Math.min(this.#wait * 2, LONGEST_WAIT);
  }
}
