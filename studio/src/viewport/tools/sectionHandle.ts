/** The frame of the plane that cuts the view, and a handle to move it along its normal, with the pointer or with keys. */

import { Vector3 } from "three";

import { gridSteps, snap } from "../../core/gridSteps";
import type { Point3 } from "../../core/preview";
import { dot, square } from "../../core/section";
import { t } from "../../i18n";
import type { PlacedPane } from "../panes";
import { settingsStore } from "../settings";
import type { Viewport } from "../Viewport";
import { nearestAlong } from "./rays";

const SVG = "http://www.w3.org/2000/svg";

export class SectionHandle {
  #viewport: Viewport;
  #frame: SVGSVGElement;
  #outline: SVGPolygonElement;
  #button: HTMLButtonElement;
  #drag: { pane: PlacedPane; grip: number; middle: Point3 } | undefined;

  constructor(host: HTMLElement, viewport: Viewport) {
    this.#viewport = viewport;
    this.#frame = document.createElementNS(SVG, "svg");
    this.#frame.setAttribute("class", "viewport-section");
    this.#frame.setAttribute("aria-hidden", "true");
    this.#outline = document.createElementNS(SVG, "polygon");
    this.#frame.append(this.#outline);
    this.#button = document.createElement("button");
    this.#button.type = "button";
    this.#button.className = "viewport-section-handle";
    this.#button.title = t("viewport.section.handleHelp");
    this.#button.addEventListener("pointerdown", (event) => this.#begin(event));
    this.#button.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"]) this.#button.addEventListener(end, () => (this.#drag = undefined));
    this.#button.addEventListener("keydown", (event) => this.#key(event));
    host.append(this.#frame, this.#button);
  }

  /** Puts frame and handle where the plane is in the active pane. */
  place(placed: readonly PlacedPane[]): void {
    const { model, panes } = this.#viewport;
    const { section } = model;
    const box = this.#viewport.documentBounds();
    const pane = placed.find((each) => each.pane === panes.active);
    const shape = section && box && square(section.normal, section.at, box);
    const place = (point: Point3) => this.#viewport.placeOf(point, pane);
    const corners = shape?.corners.map(place) ?? [];
    const middle = shape && place(shape.middle);
    const isSeen = middle !== undefined && corners.length > 0 && corners.every((corner) => corner !== undefined);
    this.#frame.style.display = isSeen ? "" : "none";
    this.#button.hidden = !middle;
    if (isSeen) this.#outline.setAttribute("points", corners.map((corner) => corner?.map((value) => value.toFixed(1)).join()).join(" "));
    if (!middle || !section) return;
    this.#button.style.transform = `translate(${middle[0]}px, ${middle[1]}px)`;
    this.#button.setAttribute("aria-label", t("viewport.section.handle", { at: Number(section.at.toPrecision(6)) }));
  }

  dispose(): void {
    this.#frame.remove();
    this.#button.remove();
  }

  #begin(event: PointerEvent): void {
    const { model, panes } = this.#viewport;
    const box = this.#viewport.documentBounds();
    if (event.button !== 0 || !model.section || !box) return;
    this.#button.setPointerCapture(event.pointerId);
    const pane = panes.placedOf(panes.active);
    const { middle } = square(model.section.normal, model.section.at, box);
    this.#drag = { pane, middle, grip: this.#along(event, pane, middle) ?? 0 };
  }

  #move(event: PointerEvent): void {
    const { section } = this.#viewport.model;
    if (!this.#drag || !section) return;
    const { pane, grip, middle } = this.#drag;
    const along = this.#along(event, pane, middle);
    if (along === undefined) return;
    const at = dot(middle, section.normal) + along - grip;
    const isFree = event.altKey || !settingsStore.getState().snap;
    this.#put(isFree ? at : snap(at, this.#step()));
  }

  #key(event: KeyboardEvent): void {
    const { section } = this.#viewport.model;
    const steps: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, PageUp: 1, ArrowLeft: -1, ArrowDown: -1, PageDown: -1 };
    const step = steps[event.key];
    if (!step || !section || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const size = this.#step();
    this.#put(snap(section.at + step * size * (event.shiftKey ? 10 : 1), size));
  }

  #step(): number {
    const { panes } = this.#viewport;
    const { pane, height } = panes.placedOf(panes.active);
    return gridSteps(pane.rig.pixel(height)).minor;
  }

  #put(at: number): void {
    settingsStore.setState(({ section }) => ({ section: { ...section, at } }));
  }

  /** How far along the normal from a point the pointer is; undefined where the view is along the normal. */
  #along(event: PointerEvent, { pane, left, top, width, height }: PlacedPane, from: Point3): number | undefined {
    const { section } = this.#viewport.model;
    if (!section) return undefined;
    const page = this.#viewport.canvas.getBoundingClientRect();
    const [u, v] = [((event.clientX - page.left - left) / width) * 2 - 1, 1 - ((event.clientY - page.top - top) / height) * 2];
    const { origin, direction } = pane.rig.ray(u, v, width / height);
    return nearestAlong(new Vector3(...from), new Vector3(...section.normal), origin, direction);
  }
}
