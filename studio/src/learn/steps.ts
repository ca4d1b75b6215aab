/** The steps of an algorithm: all of them, or one after the other. */

import type { ExplanationView } from "../core/protocol/ExplanationView";
import type { NumberView } from "../core/protocol/NumberView";
import type { QuantityView } from "../core/protocol/QuantityView";
import type { StepView } from "../core/protocol/StepView";
import { button, make } from "./elements";
import { figureOf, type Figure } from "./figure";
import { number } from "./values";
import { word } from "./words";

const DIGITS = "4";

function numeral({ value, exact }: NumberView): string {
  return exact !== null ? exact.replace("-", "−") : number(value, DIGITS);
}

function equation(quantity: QuantityView, rule: (Node | string)[]): (Node | string)[] {
  const numbers = quantity.numbers.map(numeral);
  const value = numbers.length === 1 ? (numbers[0] ?? "") : `(${numbers.join(", ")})`;
  return [make("i", {}, quantity.name), ...rule, " = ", make("b", {}, value)];
}

function written(step: StepView): (Node | string)[] {
  const rule: (Node | string)[] = step.rule === "" ? [] : [` = ${step.rule}`];
  step.terms.forEach((term, place) => {
    const factor = numeral(term.factor);
    rule.push(place === 0 ? " = " : " + ", factor.startsWith("−") && place > 0 ? `(${factor})` : factor, " ", make("i", {}, term.name));
  });
  return equation(step.made, rule);
}

/** As the builder of the pages lists them (`crates/book/src/steps.rs`). */
function listed(told: ExplanationView): Node[] {
  const lines = (name: string, list: QuantityView[]) =>
    make("ul", { class: name }, ...list.map((quantity) => make("li", {}, ...equation(quantity, []))));
  const rounds = told.rounds.map((round) =>
    make("li", {}, make("ul", {}, ...round.map((step) => make("li", { class: "step" }, ...written(step))))),
  );
  return [lines("given", told.given), make("ol", { class: "rounds" }, ...rounds), lines("result", told.result)];
}

class Steps {
  #element: HTMLElement;
  #list: HTMLElement;
  #place = -1;
  #told = make("span", { role: "status", class: "place" });

  constructor(element: HTMLElement) {
    this.#element = element;
    this.#list = make("div", { class: "list" }, ...element.childNodes);
    const back = button(word("step-previous"), () => this.#go(-1));
    const next = button(word("step-next"), () => this.#go(1));
    element.append(make("div", { class: "step-keys" }, back, next, this.#told), this.#list);
    document.addEventListener("katydid-solved", (event) => {
      const figure = (event as CustomEvent<Figure>).detail;
      if (figure.data.id === element.dataset.figure) void this.#refresh(figure);
    });
  }

  async #refresh(figure: Figure): Promise<void> {
    const { object = "", algorithm = null } = this.#element.dataset;
    const told = await figure.lesson?.explain(object, algorithm);
    if (!told) return;
    this.#list.replaceChildren(...listed(told));
    this.#mark();
  }

  #go(by: number): void {
    const all = this.#list.querySelectorAll(".step").length;
    this.#place = Math.min(Math.max(this.#place + by, -1), all - 1);
    this.#mark();
    const figure = figureOf(this.#element.dataset.figure);
    void figure?.start();
  }

  #mark(): void {
    const all = [...this.#list.querySelectorAll<HTMLElement>(".step")];
    all.forEach((step, at) => {
      step.classList.toggle("now", at === this.#place);
      step.classList.toggle("later", this.#place >= 0 && at > this.#place);
    });
    const now = all[this.#place];
    const made = now?.querySelector("i")?.textContent ?? "";
    this.#told.textContent = now ? word("step-of", { n: this.#place + 1, all: all.length }) : "";
    this.#hover(made);
  }

  /** What the step makes is marked in the picture where an object has its name. */
  #hover(made: string): void {
    const figure = figureOf(this.#element.dataset.figure);
    figure?.hover(figure.lesson?.named(made)?.id);
  }
}

export function readySteps(): void {
  for (const element of document.querySelectorAll<HTMLElement>(".steps")) new Steps(element);
}
