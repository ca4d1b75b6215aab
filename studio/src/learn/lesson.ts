/** A definition that a figure shows: its objects, controls and values, as the engine has them. */

import { Refusal, type Answer } from "../core/connection";
import { FrameBuffer } from "../core/frames";
import type { Ask } from "../core/protocol/Ask";
import type { Edit } from "../core/protocol/Edit";
import type { Event } from "../core/protocol/Event";
import type { ExplanationView } from "../core/protocol/ExplanationView";
import type { NurbsView } from "../core/protocol/NurbsView";
import type { ObjectView } from "../core/protocol/ObjectView";
import { GeometryStore } from "../viewport/geometryStore";
import type { Line, Transport } from "./transport";
import { items, type Value } from "./values";

/** So many rows of an output are asked for: more are not read on a page. */
const MOST_ROWS = 500;

export class Lesson {
  readonly objects = new Map<string, ObjectView>();
  readonly geometry: GeometryStore;
  /** Called when a solve has ended. */
  onSolved = new Set<() => void>();
  onState: (state: string) => void = () => {};
  #line: Line | undefined;
  #frames = new FrameBuffer();
  #cache = new Map<string, Promise<Value[]>>();
  #ready: Promise<void>;
  #isReady: () => void = () => {};
  #gesture = Math.floor(Math.random() * 1e6);

  constructor(transport: Transport) {
    this.geometry = new GeometryStore((hash, signal) => transport.geometry(hash, signal));
    this.#ready = new Promise((resolve) => (this.#isReady = resolve));
  }

  static async open(transport: Transport, name: string, text: string): Promise<Lesson> {
    const lesson = new Lesson(transport);
    const document = await transport.open(name, text);
    lesson.#line = transport.connect(document, {
      event: (event) => lesson.#take(event),
      geometry: (bytes) => lesson.#frames.put(bytes),
      state: (state) => lesson.onState(state),
    });
    await lesson.#ready;
    return lesson;
  }

  close(): void {
    this.#line?.close();
  }

  named(nickname: string): ObjectView | undefined {
    for (const object of this.objects.values()) if (object.nickname === nickname) return object;
    return undefined;
  }

  ask(ask: Ask): Promise<Answer> {
    return this.#line?.ask(ask) ?? Promise.reject(new Refusal("closed"));
  }

  /** A number for the edits of one drag. */
  newGesture(): number {
    return ++this.#gesture;
  }

  async edit(edit: Edit, gesture: number | null = null): Promise<void> {
    await this.ask({ ask: "edit", edit, gesture, within: [] });
  }

  /** The items of an output, kept until the next solve. */
  values(object: string, output: number): Promise<Value[]> {
    const view = this.objects.get(object);
    const port = view?.outputs[output];
    if (!view || !port) return Promise.resolve([]);
    const known = this.#cache.get(port.id);
    if (known) return known;
    const isText = view.control?.is === "panel" || port.kind === "Text";
    const asked = this.ask({ ask: "rows", port: port.id, from: 0, count: MOST_ROWS, exact: true, within: [] }).then(
      (answer) => (answer.event === "rows" ? items(answer.page.rows, isText) : []),
      () => [],
    );
    this.#cache.set(port.id, asked);
    return asked;
  }

  async explain(object: string, algorithm: string | null): Promise<ExplanationView | undefined> {
    const answer = await this.ask({ ask: "explain", object, algorithm }).catch(() => undefined);
    return answer?.event === "explained" ? answer.explanation : undefined;
  }

  async nurbs(object: string, output: number): Promise<NurbsView | undefined> {
    const port = this.objects.get(object)?.outputs[output];
    if (!port) return undefined;
    const answer = await this.ask({ ask: "nurbs", port: port.id }).catch(() => undefined);
    return answer?.event === "nurbs" ? answer.curve : undefined;
  }

  #take(event: Event): void {
    switch (event.event) {
      case "document":
        this.objects.clear();
        for (const object of event.objects) this.objects.set(object.id, object);
        this.#cache.clear();
        break;
      case "patch":
        for (const id of event.removed) this.objects.delete(id);
        for (const object of event.put) this.objects.set(object.id, object);
        break;
      case "results":
        this.#cache.clear();
        if (event.finished) {
          this.#isReady();
          for (const tell of this.onSolved) tell();
        }
        break;
      case "preview":
        this.geometry.changed(event.objects, this.#frames.take());
        break;
      default:
    }
  }
}
