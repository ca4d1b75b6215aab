/** A session that lives in the page: it edits a document as the protocol asks, and makes results up. */

import type { Ask } from "../../src/core/protocol/Ask";
import type { DocumentState } from "../../src/core/protocol/DocumentState";
import type { Edit } from "../../src/core/protocol/Edit";
import type { Event } from "../../src/core/protocol/Event";
import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { Request } from "../../src/core/protocol/Request";
import { applyEdit } from "./apply";
import { resultsOf, rowsOfPort } from "./results";

export class PageSession {
  state: DocumentState;
  /** The edits that came, for tests to look at. */
  readonly edits: Edit[] = [];
  readonly asks: Ask[] = [];
  #listener: ((event: Event) => void) | undefined;
  #past: { objects: ObjectView[]; gesture: number | null }[] = [];
  #future: ObjectView[][] = [];
  #solution = 0;

  constructor(state: DocumentState) {
    this.state = state;
  }

  join(listener: (event: Event) => void): void {
    this.#listener = listener;
    this.#tell({ event: "document", ...this.state });
    this.#solve();
  }

  take({ seq, ask }: Request): void {
    this.asks.push(ask);
    try {
      const made = this.#answer(seq, ask);
      if (made) this.#tell({ event: "done", seq, revision: this.state.revision, made });
    } catch (error) {
      this.#tell({ event: "refused", seq, reason: String(error) });
    }
  }

  #answer(seq: number, ask: Ask): string[] | undefined {
    switch (ask.ask) {
      case "edit":
        return this.#edit(ask.edit, ask.gesture);
      case "undo":
        this.#step(this.#past.pop()?.objects, (now) => this.#future.push(now));
        return [];
      case "redo":
        this.#step(this.#future.pop(), (objects) => this.#past.push({ objects, gesture: null }));
        return [];
      case "abandon":
        if (this.#past.at(-1)?.gesture === ask.gesture) this.#step(this.#past.pop()?.objects, () => {});
        return [];
      case "rows":
        this.#tell({ event: "rows", seq, page: rowsOfPort(this.state.objects, ask.port, ask.from, ask.count) });
        return undefined;
      case "copy": {
        const chosen = new Set(ask.objects);
        const text = JSON.stringify(this.state.objects.filter((object) => chosen.has(object.id)));
        this.#tell({ event: "copied", seq, text });
        return undefined;
      }
      case "enter":
        this.state = { ...this.state, within: ask.within };
        this.#tell({ event: "document", ...this.state });
        this.#solve();
        return [];
      default:
        return [];
    }
  }

  #edit(edit: Edit, gesture: number | null): string[] {
    this.edits.push(edit);
    const before = this.state.objects;
    const { objects, made } = applyEdit(before, edit);
    if (gesture === null || this.#past.at(-1)?.gesture !== gesture) this.#past.push({ objects: before, gesture });
    this.#future = [];
    this.#put(objects);
    return made;
  }

  #step(objects: ObjectView[] | undefined, keep: (now: ObjectView[]) => void): void {
    if (!objects) return;
    keep(this.state.objects);
    this.#put(objects);
  }

  #put(objects: ObjectView[]): void {
    const before = new Map(this.state.objects.map((object) => [object.id, object]));
    const after = new Set(objects.map((object) => object.id));
    const put = objects.filter((object) => before.get(object.id) !== object);
    const removed = [...before.keys()].filter((id) => !after.has(id));
    const revision = this.state.revision + 1;
    const undo = this.#past.length > 0 ? "Change" : null;
    const redo = this.#future.length > 0 ? "Change" : null;
    const document = { ...this.state.document, undo, redo, changed: true };
    this.state = { ...this.state, objects, revision, document };
    const order = objects.map((object) => object.id);
    this.#tell({ event: "patch", revision, within: this.state.within, put, removed, order, document });
    this.#solve();
  }

  #solve(): void {
    const results = resultsOf(this.state.objects);
    const solution = ++this.#solution;
    const { within } = this.state;
    this.#tell({ event: "results", solution, within, results, finished: true, cancelled: false, milliseconds: 3 });
  }

  #tell(event: Event): void {
    this.#listener?.(structuredClone(event));
  }
}
