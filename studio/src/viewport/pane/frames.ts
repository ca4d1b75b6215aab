/** What lies over each pane: its title where there are four, the view cube, and the frame of the active one. */

import { t, type Key } from "../../i18n";
import { ViewCube } from "../overlay/cube";
import { placeOf, type PlacedPane } from "../panes";
import type { Pane, ViewName } from "../views";

export interface FrameActions {
  activate(pane: Pane): void;
  /** One pane alone, or all four. */
  maximise(pane: Pane): void;
  look(pane: Pane, view: ViewName): void;
}

/** Smaller than this, in pixels, a pane has a small view cube: as on a phone, where the usual one covers the model. */
const SMALL_WIDTH = 420;
const SMALL_HEIGHT = 200;

interface Frame {
  element: HTMLElement;
  title: HTMLButtonElement;
  cube: ViewCube;
}

export class PaneFrames {
  #parent: HTMLElement;
  #actions: FrameActions;
  #frames = new Map<Pane, Frame>();
  /** How it all stands: most pictures show other geometry only, and writing to elements costs the page a layout. */
  #place = "";

  constructor(parent: HTMLElement, actions: FrameActions) {
    this.#parent = parent;
    this.#actions = actions;
  }

  place(placed: readonly PlacedPane[], active: Pane): void {
    const place = `${active.title} ${placeOf(placed)}`;
    if (place === this.#place) return;
    this.#place = place;
    const isFour = placed.length > 1;
    for (const [pane, { element }] of this.#frames) {
      if (!placed.some((each) => each.pane === pane)) {
        element.remove();
        this.#frames.delete(pane);
      }
    }
    for (const { pane, left, top, width, height } of placed) {
      const { element, title, cube } = this.#frames.get(pane) ?? this.#make(pane);
      Object.assign(element.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
      element.classList.toggle("is-active", isFour && pane === active);
      element.classList.toggle("is-small", width < SMALL_WIDTH || height < SMALL_HEIGHT);
      title.hidden = !isFour;
      title.setAttribute("aria-pressed", String(pane === active));
      cube.turn(pane.rig);
    }
  }

  dispose(): void {
    for (const { element } of this.#frames.values()) element.remove();
    this.#frames.clear();
  }

  #make(pane: Pane): Frame {
    const element = document.createElement("div");
    element.className = "viewport-frame";
    const title = document.createElement("button");
    title.type = "button";
    title.className = "viewport-title";
    title.textContent = t(`viewport.view.${pane.title}` as Key);
    title.title = t("viewport.paneHelp");
    title.addEventListener("click", () => this.#actions.activate(pane));
    title.addEventListener("dblclick", () => this.#actions.maximise(pane));
    const cube = new ViewCube((view) => this.#actions.look(pane, view));
    element.append(title, cube.element);
    this.#parent.append(element);
    const frame = { element, title, cube };
    this.#frames.set(pane, frame);
    return frame;
  }
}
