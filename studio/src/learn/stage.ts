/** The picture of a figure: the studio's viewport, with hands and a keyboard of its own. */

import type { Rgba } from "../core/preview";
import { freshSettings, freshState } from "../viewport/settings";
import { Viewport } from "../viewport/Viewport";
import type { ViewName } from "../viewport/views";
import { parseColour } from "../viewport/theme";
import { make } from "./elements";
import type { Lesson } from "./lesson";
import type { FigureData } from "./data";
import { Grips } from "./grips";

const NOTHING: ReadonlySet<string> = new Set();
/** The usual colour of previews: a clear dark red, as in the studio. */
const PREVIEW: Rgba = [150, 0, 0, 100];
/** Pictures of a book are looked at from farther away than a model: heavier lines, larger letters, more room about them. */
const LOOK = { weight: 1.6, margin: 1.3, textSize: 16 } as const;
/** How much of a surface's colour covers what is behind it, of 255. */
const OF_SURFACE = 120;
const STEP = 24;
const ZOOM = 1.15;

export class Stage {
  readonly viewport: Viewport;
  readonly host: HTMLElement;
  /** How this picture is looked at, and what it says: each figure has its own. */
  readonly settings = freshSettings();
  readonly state = freshState();
  #lesson: Lesson;
  #data: FigureData;
  #hovered: string | undefined;
  readonly grips: Grips;
  #stop: (() => void)[] = [];
  #colours = new Map<string, Rgba>();

  constructor(stage: HTMLElement, lesson: Lesson, data: FigureData) {
    this.#lesson = lesson;
    this.#data = data;
    this.host = make("div", { class: "live-stage", tabindex: 0, role: "application", "aria-label": data.alt });
    stage.append(this.host);
    this.viewport = new Viewport(this.host, this.#around(), { ...LOOK, settings: this.settings, state: this.state });
    this.viewport.canvas.setAttribute("aria-hidden", "true");
    this.viewport.panes.look(data.view as ViewName, false, true);
    this.grips = new Grips(this, lesson, data);
    this.viewport.afterDraw = () => this.grips.place();
    this.#stop.push(
      lesson.geometry.listen({
        put: (object, preview) => this.viewport.put(object, preview),
        drop: (object) => this.viewport.drop(object),
        clear: () => this.viewport.clear(),
        failed: () => undefined,
      }),
    );
    this.retheme();
    this.#hands();
  }

  /** Marks an object, as its symbol is pointed at. */
  hover(object: string | undefined): void {
    this.#hovered = object;
    this.viewport.surround(this.#around());
  }

  retheme(): void {
    const probe = make("span");
    this.host.append(probe);
    this.#colours = new Map();
    for (const [name, hue] of Object.entries(this.#data.colours)) {
      const object = this.#lesson.named(name);
      probe.style.color = `var(--${hue})`;
      const [red, green, blue] = parseColour(getComputedStyle(probe).color);
      if (object) this.#colours.set(object.id, [red, green, blue, OF_SURFACE]);
    }
    // Names in the picture are read, not looked at: they are in the ink of the text where nothing else is said.
    probe.style.color = "var(--ink)";
    const ink = parseColour(getComputedStyle(probe).color);
    for (const { id, name } of this.#lesson.objects.values()) {
      if (name.startsWith("Text Tag") && !this.#colours.has(id)) this.#colours.set(id, ink);
    }
    probe.remove();
    this.viewport.surround(this.#around());
    this.viewport.retheme();
  }

  dispose(): void {
    for (const stop of this.#stop) stop();
    this.viewport.dispose();
    this.host.remove();
  }

  #around() {
    const only = this.#data.only.flatMap((name) => this.#lesson.named(name)?.id ?? []);
    return {
      normal: PREVIEW,
      selected: [0, 130, 60, 140] as Rgba,
      selection: this.#hovered ? new Set([this.#hovered]) : NOTHING,
      hovered: undefined,
      hidden: NOTHING,
      only: only.length > 0 ? new Set(only) : undefined,
      layers: new Map<string, Rgba>(),
      colours: this.#colours,
    };
  }

  #hands(): void {
    const { host, viewport } = this;
    const { panes } = viewport;
    let last: [number, number] | undefined;
    host.addEventListener("pointerdown", (event) => {
      if (event.target !== viewport.canvas) return;
      last = [event.clientX, event.clientY];
      host.setPointerCapture(event.pointerId);
    });
    host.addEventListener("pointermove", (event) => {
      if (!last) return;
      this.#move(event.clientX - last[0], event.clientY - last[1], event.shiftKey || event.buttons === 4);
      last = [event.clientX, event.clientY];
    });
    const end = () => (last = undefined);
    host.addEventListener("pointerup", end);
    host.addEventListener("pointercancel", end);
    host.addEventListener("wheel", (event) => {
      // The wheel belongs to the page, unless it is asked for.
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.#zoom(event.deltaY > 0 ? ZOOM : 1 / ZOOM);
    }, { passive: false });
    host.addEventListener("keydown", (event) => {
      if (event.target !== host) return;
      const moves: Record<string, [number, number]> = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, -STEP], ArrowDown: [0, STEP] };
      const move = moves[event.key];
      if (move) this.#move(...move, event.shiftKey);
      else if (event.key === "+") this.#zoom(1 / ZOOM);
      else if (event.key === "-") this.#zoom(ZOOM);
      else if (event.key === "Home") {
        panes.look(this.#data.view as ViewName, false, true);
        viewport.zoomExtents(true);
      } else return;
      event.preventDefault();
    });
  }

  #move(dx: number, dy: number, isPan: boolean): void {
    const { panes } = this.viewport;
    if (isPan || this.#data.view !== "perspective") panes.pan(panes.active, dx, dy);
    else panes.orbit(panes.active, dx, dy);
  }

  #zoom(factor: number): void {
    const { panes } = this.viewport;
    const [x, y, z] = panes.active.rig.pose.target;
    panes.zoom(panes.active, panes.active.rig.eye().set(x, y, z), factor);
  }
}
