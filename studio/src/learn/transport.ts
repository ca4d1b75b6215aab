/** How a page reaches an engine: the studio's server, or whatever else opens a definition and speaks the session's protocol. */

import { Ways } from "#ways";

import type { Answer, Listener } from "../core/connection";
import type { Ask } from "../core/protocol/Ask";

/** A way to one definition that is open. */
export interface Line {
  ask(ask: Ask): Promise<Answer>;
  close(): void;
}

export interface Transport {
  /** Begins what takes long before the first definition is there. */
  prepare(): void;
  /** Opens a definition for a while; gives its id. */
  open(name: string, text: string): Promise<string>;
  connect(document: string, listener: Listener): Line;
  geometry(hash: string, signal: AbortSignal): Promise<ArrayBuffer>;
  /** The address at which the studio shows the definition with these values; undefined where there is no studio. */
  studio(name: string, text: string): Promise<string | undefined>;
}

let ways: Transport | undefined;

/** The way that this page has: its server, or the engine in a worker where the site has none. */
export const transport = (): Transport => (ways ??= new Ways());
