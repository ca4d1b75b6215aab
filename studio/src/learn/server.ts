/** The server that serves the pages below `/learn` has the engine. */

import { Connection, type Listener } from "../core/connection";
import type { Line, Transport } from "./transport";
import { page } from "./words";

export class Ways implements Transport {
  readonly #base = new URL(`${page.root}../`, location.href);

  #address(path: string, query: Record<string, string> = {}): URL {
    const url = new URL(path, this.#base);
    url.search = new URLSearchParams(query).toString();
    return url;
  }

  async #upload(name: string, text: string, query: Record<string, string>): Promise<string> {
    const response = await fetch(this.#address("api/upload", { name, ...query }), { method: "POST", body: text });
    if (!response.ok) throw new Error(`${response.status}`);
    return ((await response.json()) as { document: string }).document;
  }

  /** The server runs already. */
  prepare(): void {}

  open(name: string, text: string): Promise<string> {
    return this.#upload(name, text, { passing: "true" });
  }

  connect(document: string, listener: Listener): Line {
    const url = this.#address("socket", { document });
    url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
    const connection = new Connection(url.toString(), listener);
    const leave = () => {
      connection.close();
      const body = JSON.stringify({ document });
      void fetch(this.#address("api/close"), { method: "POST", body, keepalive: true, headers: { "content-type": "application/json" } }).catch(() => undefined);
    };
    addEventListener("pagehide", leave, { once: true });
    return { ask: (ask) => connection.ask(ask), close: () => connection.close() };
  }

  async geometry(hash: string, signal: AbortSignal): Promise<ArrayBuffer> {
    const response = await fetch(this.#address(`geometry/${encodeURIComponent(hash)}`), { signal });
    if (!response.ok) throw new Error(`${response.status}`);
    return response.arrayBuffer();
  }

  async studio(name: string, text: string): Promise<string | undefined> {
    const document = await this.#upload(name, text, {});
    return this.#address("", { document }).toString();
  }
}
