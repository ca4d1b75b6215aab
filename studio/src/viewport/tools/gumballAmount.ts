/** How far the gumball goes: said beside the pointer, or typed. */

import { AXES, type Grip } from "../../core/gumball";
import { t } from "../../i18n";

type Place = readonly [number, number];

export class AmountField {
  #box = document.createElement("div");
  #text = document.createElement("span");
  #field = document.createElement("input");
  #take: (text: string) => boolean = () => true;

  constructor(host: HTMLElement) {
    this.#box.className = "viewport-gumball-amount";
    this.#box.hidden = true;
    this.#field.type = "text";
    this.#field.inputMode = "decimal";
    this.#field.autocomplete = "off";
    this.#field.addEventListener("keydown", (event) => this.#key(event));
    this.#field.addEventListener("blur", () => this.hide());
    this.#box.append(this.#text, this.#field);
    host.append(this.#box);
  }

  hide(): void {
    this.#box.hidden = true;
  }

  tell(text: string, at: Place): void {
    this.#field.hidden = true;
    this.#text.textContent = text;
    this.#put(at);
  }

  /** Asks for an amount; what `take` refuses may be typed anew. */
  ask({ does, axis }: Grip, at: Place, take: (text: string) => boolean): void {
    const label = t(`viewport.gumball.amount.${does}`, { axis: axis === undefined ? "" : AXES[axis] });
    this.#take = take;
    this.#text.textContent = "";
    this.#field.hidden = false;
    this.#field.setAttribute("aria-label", label);
    this.#field.placeholder = label;
    this.#field.title = label;
    this.#field.value = "";
    this.#field.removeAttribute("aria-invalid");
    this.#put(at);
    this.#field.focus({ preventScroll: true });
  }

  dispose(): void {
    this.#box.remove();
  }

  #put([x, y]: Place): void {
    this.#box.style.transform = `translate(${x + 16}px, ${y + 18}px)`;
    this.#box.hidden = false;
  }

  #key(event: KeyboardEvent): void {
    if (event.key !== "Enter" && event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "Escape" || this.#take(this.#field.value)) this.hide();
    else this.#field.setAttribute("aria-invalid", "true");
  }
}
