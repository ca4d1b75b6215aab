/**
 * Drags a particle of a solver: with Alt held, the left button takes the point under the pointer and drags it in the plane of
 * the view, where the document has a Grab. Nothing of it is kept, and there is no step for Undo.
 */

import { grabsOf, GrabGesture } from "../../core/grab";
import { distance } from "../../core/frame";
import type { Point3 } from "../../core/preview";
import type { HeldPoint } from "../../core/protocol/HeldPoint";
import { documentStore } from "../../state/document";
import { runStore } from "../../state/run";
import { ask, edit, newGesture } from "../../state/session";
import type { PlacedPane } from "../panes";
import { viewportStore } from "../settings";
import type { Viewport } from "../Viewport";
import { draggedAcross } from "./rays";

const SVG = "http://www.w3.org/2000/svg";
/** How near to a point the pointer takes it, in pixels. */
const REACH = 12;
const HELD = "viewport.grab.held";

export class Grabber {
  #viewport: Viewport;
  #picture: SVGSVGElement;
  #line: SVGLineElement;
  #handle: SVGCircleElement;
  #gesture: GrabGesture;
  /** The Grabs that drag, and the pane in which they do. */
  #grabs: readonly string[] = [];
  #pane: PlacedPane | undefined;
  #look = 0;
  #stop = new AbortController();
  #unsubscribe: () => void;

  constructor(host: HTMLElement, viewport: Viewport) {
    this.#viewport = viewport;
    this.#picture = document.createElementNS(SVG, "svg");
    this.#picture.setAttribute("class", "viewport-grab");
    this.#picture.setAttribute("aria-hidden", "true");
    this.#picture.style.display = "none";
    this.#line = document.createElementNS(SVG, "line");
    this.#handle = document.createElementNS(SVG, "circle");
    this.#handle.setAttribute("r", "6");
    this.#picture.append(this.#line, this.#handle);
    host.append(this.#picture);
    this.#gesture = new GrabGesture({
      send: (held) => this.#send(held),
      soon: (then) => requestAnimationFrame(then),
      lost: () => this.#show(false),
    });
    this.#unsubscribe = runStore.subscribe((now, before) => {
      if (now.results !== before.results && now.progress === undefined) this.#gesture.solved();
    });
    const { signal } = this.#stop;
    viewport.canvas.addEventListener("pointermove", (event) => this.#hover(event), { signal });
    // Nothing is held by a page that is not looked at: the button may go up elsewhere.
    window.addEventListener("blur", () => this.end(), { signal });
  }

  dispose(): void {
    this.end();
    this.#stop.abort();
    this.#unsubscribe();
    cancelAnimationFrame(this.#look);
    this.#picture.remove();
  }

  /** Takes the point at a place of the canvas; whether there is one, and a Grab that can drag it. */
  begin(x: number, y: number): boolean {
    const grabs = this.#available();
    const from = grabs.length > 0 ? this.#viewport.vertexAt(x, y, REACH) : undefined;
    if (!from) return false;
    const { panes } = this.#viewport;
    const pane = panes.placedOf(panes.active);
    const start = this.#inPlane(pane, from, x, y);
    const beside = this.#inPlane(pane, from, x + REACH, y);
    if (!start || !beside) return false;
    [this.#grabs, this.#pane] = [grabs, pane];
    this.#show(true);
    this.#gesture.begin(from, start, distance(start, beside));
    void ask({ ask: "draft", on: true }).catch(() => {});
    return true;
  }

  move(x: number, y: number): void {
    const { held } = this.#gesture;
    const to = held && this.#pane && this.#inPlane(this.#pane, held.from, x, y);
    if (!to) return;
    this.#gesture.move(to);
    this.#viewport.invalidate();
  }

  /** Lets go. */
  end(): void {
    if (!this.#gesture.held) return;
    this.#gesture.end();
    this.#show(false);
  }

  /** Puts the line and its handle where hand and point are. */
  place(): void {
    const { held } = this.#gesture;
    const [from, to] = [held?.from, held?.to].map((point) => point && this.#viewport.placeOf(point, this.#pane));
    this.#picture.style.display = from && to ? "" : "none";
    if (!from || !to) return;
    const [x1, y1, x2, y2] = [...from, ...to].map((value) => value.toFixed(1));
    for (const [name, value] of Object.entries({ x1, y1, x2, y2 })) this.#line.setAttribute(name, value ?? "0");
    this.#handle.setAttribute("cx", x2 ?? "0");
    this.#handle.setAttribute("cy", y2 ?? "0");
  }

  /** The Grabs of the document; none where nothing is solved for them. */
  #available(): string[] {
    const { document, objects, within } = documentStore.getState();
    return within.length > 0 || document?.locked ? [] : grabsOf(objects.values());
  }

  #inPlane(pane: PlacedPane, through: Point3, x: number, y: number): Point3 | undefined {
    return draggedAcross(pane, through, pane.pane.rig.backward().toArray(), x, y);
  }

  async #send(held: HeldPoint | null): Promise<boolean> {
    const gesture = newGesture();
    const answers = await Promise.all(
      this.#grabs.map((object) => edit({ do: "set", object, to: { is: "grab", held } }, gesture)),
    );
    return answers.every((answer) => answer?.event === "done");
  }

  /** What one sees and hears of a point that is held, and the end of it. */
  #show(isHeld: boolean): void {
    const { canvas } = this.#viewport;
    canvas.classList.toggle("is-grabbing", isHeld);
    canvas.classList.remove("is-grabbable");
    if (isHeld) viewportStore.setState({ notice: HELD });
    else {
      viewportStore.setState(({ notice }) => (notice === HELD ? { notice: undefined } : {}));
      void ask({ ask: "draft", on: false }).catch(() => {});
    }
    this.#viewport.invalidate();
  }

  /** The cursor says what Alt and the button would take. */
  #hover({ altKey, buttons, offsetX, offsetY }: PointerEvent): void {
    if (buttons !== 0 || this.#look) return;
    const { classList } = this.#viewport.canvas;
    if (!altKey) return classList.remove("is-grabbable");
    this.#look = requestAnimationFrame(() => {
      this.#look = 0;
      const isThere = this.#available().length > 0 && this.#viewport.vertexAt(offsetX, offsetY, REACH) !== undefined;
      classList.toggle("is-grabbable", isThere);
    });
  }
}
