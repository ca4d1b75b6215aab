/** The element of a figure: a still until it is touched, then the engine's picture with its controls, values and widgets. */

import type { Control } from "../core/protocol/Control";
import type { ControlData, FigureData } from "./data";
import { button, make } from "./elements";
import type { Lesson } from "./lesson";
import { fillLive } from "./live";
import { clearLink, readLink, settleLink, writeLink } from "./link";
import type { Stage } from "./stage";
import { transport } from "./transport";
import { number, type Value } from "./values";
import type { Widget } from "./widgets";
import { word } from "./words";

export class Figure extends HTMLElement {
  data!: FigureData;
  lesson: Lesson | undefined;
  /** The picture; without one the values follow all the same. */
  stage: Stage | undefined;
  #starting: Promise<Lesson | undefined> | undefined;
  #text: Promise<string> | undefined;
  #values = new Map<string, number | boolean>();
  /** The sliders and toggles of the definition as it came. */
  #first = new Map<string, number | boolean>();
  #inputs = new Map<string, HTMLInputElement>();
  #widgets: Widget[] = [];
  #gestures = new Map<string, number>();
  #going: Promise<void> | undefined;
  #queued = new Map<string, number | boolean>();

  connectedCallback(): void {
    if (this.data) return;
    const script = this.querySelector(":scope > script");
    this.data = JSON.parse(script?.textContent ?? "{}") as FigureData;
    for (const { name, slider, on } of this.data.controls) this.#values.set(name, slider?.value ?? on);
    this.#controls();
    this.#take();
    const stage = this.querySelector<HTMLElement>(".stage");
    if (stage) {
      const start = button(word("start"), () => void this.start(), { class: "start" });
      stage.append(start);
      stage.addEventListener("pointerdown", () => void this.start(), { once: true });
    }
    const kept = readLink(this.data.id);
    if (kept.size > 0) for (const [name, value] of kept) void this.set(name, value);
  }

  /** The values of an output, as `expected.json` has them; for tests and exercises. */
  async items(name: string): Promise<Value[]> {
    const lesson = await this.start();
    if (!lesson) return [];
    const object = lesson.named(name);
    if (object) return lesson.values(object.id, 0);
    const cut = name.lastIndexOf(".");
    const owner = lesson.named(name.slice(0, cut));
    const port = owner?.outputs.findIndex((one) => one.nickname === name.slice(cut + 1) || one.name === name.slice(cut + 1)) ?? -1;
    return owner && port >= 0 ? lesson.values(owner.id, port) : [];
  }

  /** Joins the engine, once. */
  start(): Promise<Lesson | undefined> {
    this.#starting ??= this.#start();
    return this.#starting;
  }

  /** The value of a control as it stands. */
  value(name: string): number | boolean | undefined {
    return this.#values.get(name);
  }

  /** Gives a control another value. What is dragged quickly is sent as fast as it is answered, the newest last. */
  async set(name: string, value: number | boolean): Promise<void> {
    this.#values.set(name, value);
    this.#show(name, value);
    writeLink(this.data.id, name, value);
    this.#queued.set(name, value);
    this.#going ??= this.#send().finally(() => (this.#going = undefined));
    await this.#going;
  }

  /** A drag of a control has ended: the next one is another step for Undo. */
  ended(name: string): void {
    this.#gestures.delete(name);
  }

  hover(object: string | undefined): void {
    this.stage?.hover(object);
  }

  retheme(): void {
    this.stage?.retheme();
    for (const widget of this.#widgets) void widget.refresh();
  }

  async #send(): Promise<void> {
    const lesson = await this.start();
    while (this.#queued.size > 0) {
      const next = [...this.#queued];
      this.#queued.clear();
      if (!lesson) return;
      for (const [name, value] of next) {
        const object = lesson.named(name);
        if (!object) continue;
        const gesture = this.#gestures.get(name) ?? lesson.newGesture();
        this.#gestures.set(name, gesture);
        const to = typeof value === "number" ? ({ is: "number", value } as const) : ({ is: "switch", on: value } as const);
        await lesson.edit({ do: "set", object: object.id, to }, gesture).catch(() => undefined);
      }
    }
  }

  async #start(): Promise<Lesson | undefined> {
    const start = this.querySelector<HTMLButtonElement>(".start");
    if (start) {
      start.disabled = true;
      start.textContent = word("starting");
    }
    try {
      // All that is needed is fetched at once: the engine, the definition, and what draws.
      transport().prepare();
      void import("./stage").catch(() => undefined);
      const [{ Lesson }, text] = await Promise.all([import("./lesson"), this.#definition()]);
      const lesson = await Lesson.open(transport(), this.data.definition.replaceAll("/", "-"), text);
      this.lesson = lesson;
      for (const { nickname, control } of lesson.objects.values()) {
        const value = stateOf(control);
        if (value !== undefined) this.#first.set(nickname, value);
      }
      this.setAttribute("data-state", "live");
      await this.#draw(lesson);
      start?.remove();
      const { widgetsOf } = await import("./widgets");
      this.#widgets = widgetsOf(this, lesson);
      lesson.onSolved.add(() => void this.#solved(lesson));
      await this.#solved(lesson);
      return lesson;
    } catch {
      this.setAttribute("data-state", "still");
      if (start) start.textContent = word("no-engine");
      return undefined;
    }
  }

  /** Puts the engine's picture over the still; where the browser cannot draw it, the still stays and the values follow. */
  async #draw(lesson: Lesson): Promise<void> {
    const stage = this.querySelector<HTMLElement>(".stage");
    if (!stage) return;
    const { Stage } = await import("./stage");
    try {
      this.stage = new Stage(stage, lesson, this.data);
    } catch {
      stage.querySelector(".live-stage")?.remove();
    }
  }

  async #solved(lesson: Lesson): Promise<void> {
    this.#follow(lesson);
    await fillLive(this, lesson);
    await Promise.all(this.#widgets.map((widget) => widget.refresh().catch(() => undefined)));
    this.setAttribute("data-solved", String(Number(this.getAttribute("data-solved") ?? 0) + 1));
    document.dispatchEvent(new CustomEvent("katydid-solved", { detail: this }));
  }

  /** Points that are dragged move sliders too: what is shown of them follows. */
  #follow(lesson: Lesson): void {
    // While a hand moves a control, it is ahead of what is solved.
    if (this.#going) return;
    for (const { nickname, control } of lesson.objects.values()) {
      const value = stateOf(control);
      if (value === undefined || this.#queued.has(nickname) || this.#values.get(nickname) === value) continue;
      if (!this.#values.has(nickname) && this.#first.get(nickname) === value) continue;
      this.#values.set(nickname, value);
      this.#show(nickname, value);
    }
  }

  /** All sliders, toggles and points as they came. */
  async #reset(): Promise<void> {
    const { lesson } = this;
    if (!lesson) return;
    for (const { nickname, control } of [...lesson.objects.values()]) {
      const [value, first] = [stateOf(control), this.#first.get(nickname)];
      if (first !== undefined && value !== first) void this.set(nickname, first);
    }
    await this.stage?.grips.reset();
    clearLink(this.data.id);
  }

  #definition(): Promise<string> {
    this.#text ??= fetch(this.data.file).then((response) => {
      if (!response.ok) throw new Error(`${response.status}`);
      return response.text();
    });
    return this.#text;
  }

  /** The text of the definition with the sliders as they stand. */
  async #now(): Promise<string> {
    let text = await this.#definition();
    for (const [name, value] of this.#values) {
      const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
      const kind = typeof value === "number" ? "Number Slider" : "Boolean Toggle";
      text = text.replace(new RegExp(`^(${escaped} = ${kind}\\()[^,)]+`, "m"), (_, head: string) => `${head}${value}`);
    }
    // Points whose coordinates stand in the text.
    for (const [name, at] of this.stage?.grips.moved() ?? []) {
      const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
      text = text.replace(new RegExp(`^(${escaped} = Construct Point\\()[-0-9., ]+(?=\\))`, "m"), (_, head: string) => `${head}${at.join(", ")}`);
    }
    return text;
  }

  #controls(): void {
    if (this.data.controls.length + this.data.drag.length === 0) return;
    const rows = this.data.controls.map((control) => this.#control(control));
    const reset = button(word("reset"), () => void this.#reset());
    const panel = make("div", { class: "controls", role: "group", "aria-label": word("controls") }, ...rows, reset);
    (this.querySelector(".say") ?? this).before(panel);
  }

  #control({ name, label, slider, on }: ControlData): HTMLElement {
    const kind = slider ? { type: "range", min: slider.min, max: slider.max, step: slider.step, value: slider.value } : { type: "checkbox", checked: on };
    const input = make("input", { ...kind, "data-name": name });
    const output = make("output", {}, slider ? number(slider.value, "6") : "");
    const read = () => (slider ? input.valueAsNumber : input.checked);
    input.addEventListener("input", () => void this.set(name, read()));
    input.addEventListener("change", () => this.ended(name));
    this.#inputs.set(name, input);
    return make("label", {}, make("span", {}, label), input, output);
  }

  #show(name: string, value: number | boolean): void {
    const input = this.#inputs.get(name);
    if (input) {
      if (typeof value === "number") input.value = String(value);
      else input.checked = value;
      const output = input.parentElement?.querySelector("output");
      if (output && typeof value === "number") output.textContent = number(value, "6");
    }
    for (const drag of document.querySelectorAll<HTMLElement>(`.drag[data-figure="${this.data.id}"]`)) {
      if (drag.dataset.name !== name || typeof value !== "number") continue;
      drag.textContent = number(value, "6");
      drag.setAttribute("aria-valuenow", String(value));
    }
  }

  #take(): void {
    const take = this.querySelector(".take p");
    if (!take) return;
    const told = make("span", { role: "status" });
    const copy = async (text: string) => {
      await navigator.clipboard.writeText(text).catch(() => undefined);
      told.textContent = ` ${word("copied")}`;
    };
    const copied = button(word("take-copy"), () => void this.#now().then(copy));
    const link = button(word("take-link"), () => {
      settleLink();
      void copy(location.href);
    });
    const studio = button(word("take-studio"), () => void this.#studio());
    take.append(" ", copied, " ", link, " ", studio, told);
  }

  async #studio(): Promise<void> {
    const name = this.data.definition.replaceAll("/", "-");
    const address = await transport().studio(name, await this.#now()).catch(() => undefined);
    if (address) location.assign(address);
  }
}

/** What a slider or a toggle stands at. */
function stateOf(control: Control | null): number | boolean | undefined {
  if (control?.is === "slider") return control.value;
  return control?.is === "toggle" ? control.on : undefined;
}

/** The figure of a page by its id. */
export function figureOf(id: string | undefined): Figure | undefined {
  const element = document.getElementById(id ?? "")?.querySelector("katydid-figure");
  return element instanceof Figure ? element : undefined;
}
