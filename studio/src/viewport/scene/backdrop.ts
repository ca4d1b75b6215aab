/**
 * Background and grid as a still picture behind the canvas, for software: a grid takes it as long as a model, and while
 * the camera rests all pictures have the same one. They are then drawn on nothing, and this is what is seen behind them.
 */

export class Backdrop {
  readonly element: HTMLCanvasElement;
  /** From where it was taken. */
  #taken = "";
  /** From where the last picture was. */
  #last = "";

  constructor(before: HTMLElement) {
    this.element = document.createElement("canvas");
    this.element.className = "viewport-backdrop";
    this.element.setAttribute("aria-hidden", "true");
    before.before(this.element);
  }

  /** Whether it is what belongs behind a picture from there. */
  serves(place: string): boolean {
    return place === this.#taken;
  }

  /** Whether the camera rests: two pictures from there follow each other. */
  rests(place: string): boolean {
    const isSame = place === this.#last;
    this.#last = place;
    return isSame;
  }

  /** Takes what is on a canvas. */
  take(picture: HTMLCanvasElement, place: string): void {
    const { element } = this;
    element.width = picture.width;
    element.height = picture.height;
    element.style.width = picture.style.width;
    element.style.height = picture.style.height;
    const flat = element.getContext("2d", { alpha: false });
    if (!flat) return;
    flat.drawImage(picture, 0, 0);
    this.#taken = place;
  }

  /** It has other colours now. */
  forget(): void {
    this.#taken = "";
    this.#last = "";
  }
}
