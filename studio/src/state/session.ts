/** The one connection of this page, and the short ways to ask for something over it. */

import { engine } from "#engine";

import { Connection, Refusal, type Answer, type ConnectionState, type Line as Wire, type Listener } from "../core/connection";
import type { Ask } from "../core/protocol/Ask";
import type { Edit } from "../core/protocol/Edit";
import { createStore } from "zustand/vanilla";

import { documentStore, takeDocument } from "./document";
import { takeAnalysis } from "./analysis";
import { takeModel } from "./model";
import { takeRun } from "./run";
import { takeGeometry, takePreview } from "./preview";

export interface Line {
  state: ConnectionState;
  /** What went wrong last, for the line at the bottom; it goes when the next request succeeds. */
  complaint: string | undefined;
  /** The last edit of this face that was taken whole; those of a drag are not told one by one. */
  edited: { what: Edit["do"]; revision: number } | undefined;
}

export const lineStore = createStore<Line>(() => ({ state: "closed", complaint: undefined, edited: undefined }));

let connection: Wire | undefined;

/** Joins a document of the server, or of the page's own engine. */
export function join(document: string, token: string): void {
  connection?.close();
  const listener: Listener = {
    event(event) {
      takeDocument(event);
      takeRun(event);
      takePreview(event);
      takeAnalysis(event);
      takeModel(event);
    },
    geometry: takeGeometry,
    state: (state) => lineStore.setState({ state }),
  };
  connection = engine ? engine.connect(document, listener) : new Connection(socketOf(document, token), listener);
}

function socketOf(document: string, token: string): string {
  const url = new URL("socket", location.href);
  url.protocol = location.protocol === "https:" ? "wss:" : "ws:";
  url.search = new URLSearchParams({ document, token }).toString();
  return url.toString();
}

/** Asks; a refusal is shown and thrown. */
export async function ask(what: Ask): Promise<Answer> {
  if (!connection) throw new Refusal("No document is open");
  try {
    const answer = await connection.ask(what);
    if (lineStore.getState().complaint !== undefined) lineStore.setState({ complaint: undefined });
    return answer;
  } catch (error) {
    if (error instanceof Refusal) lineStore.setState({ complaint: error.message });
    throw error;
  }
}

/** Edits what is shown. Edits with the same gesture are one step for Undo. A refusal is shown, not thrown. */
export async function edit(change: Edit, gesture: number | null = null): Promise<Answer | undefined> {
  try {
    const answer = await ask({ ask: "edit", edit: change, gesture, within: documentStore.getState().within });
    if (gesture === null && answer.event === "done") {
      lineStore.setState({ edited: { what: change.do, revision: answer.revision } });
    }
    return answer;
  } catch (error) {
    if (error instanceof Refusal) return undefined;
    throw error;
  }
}

let lastGesture = 0;

/** A number for the edits of one drag. */
export function newGesture(): number {
  return ++lastGesture;
}
