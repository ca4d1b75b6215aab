/** How the gumball looks: lines along the axes, arcs about them, and a button for each grip, at one size on the screen. */

import { along } from "../../core/frame";
import { across, AXES, GRIPS, unit, type Axis, type Grip } from "../../core/gumball";
import type { Point3 } from "../../core/preview";
import { t } from "../../i18n";
import "./gumball.css";

const SVG = "http://www.w3.org/2000/svg";
/** How far the grips are from the middle, in pixels: those that scale on the other side, so that there is room for each. */
const FAR = { move: 92, scale: -72, turn: 60 } as const;
/** An axis that is seen shorter than this part of its length points at the eye: its grips would lie on each other. */
const FLAT = 0.25;
/** What is nearer to another grip than this could not be hit for sure: WCAG asks for targets of 24 pixels. */
const APART = 24;
const STEPS = 12;
/** Where the arc of a turn can begin. */
const QUARTERS = [0, 1, 3, 2];

type Place = readonly [number, number];
type Seen = (point: Point3) => Place | undefined;

export class GumballPicture {
  #svg = document.createElementNS(SVG, "svg");
  #lines: Record<"move" | "turn", SVGPolylineElement>[] = [];
  readonly layer = document.createElement("div");
  readonly buttons: readonly { grip: Grip; button: HTMLButtonElement }[];

  constructor(host: HTMLElement) {
    this.#svg.setAttribute("class", "viewport-gumball");
    this.#svg.setAttribute("aria-hidden", "true");
    for (const name of AXES) {
      const line = () => {
        const made = document.createElementNS(SVG, "polyline");
        made.setAttribute("class", `viewport-axis-${name}`);
        this.#svg.append(made);
        return made;
      };
      this.#lines.push({ move: line(), turn: line() });
    }
    this.layer.className = "viewport-handles";
    this.layer.setAttribute("role", "group");
    this.layer.setAttribute("aria-label", t("viewport.gumball"));
    this.buttons = GRIPS.map((grip) => ({ grip, button: buttonOf(grip) }));
    this.layer.append(...this.buttons.map(({ button }) => button));
    host.append(this.#svg, this.layer);
    this.hide();
  }

  hide(): void {
    this.#svg.style.display = "none";
    this.layer.hidden = true;
  }

  /**
   * Shows it about a point; `pixel` is the length in the model that one pixel shows there. A point cannot be turned, and
   * has no free grip where it has a handle.
   */
  show(middle: Point3, pixel: number, { isPoint, isFree }: { isPoint: boolean; isFree: boolean }, seen: Seen): void {
    const at = seen(middle);
    if (!at) return this.hide();
    this.#svg.style.display = "";
    this.layer.hidden = false;
    const end = (axis: Axis, far: number) => seen(along(middle, [far * pixel, unit(axis)]));
    const isFlat = ([0, 1, 2] as const).map((axis) => {
      const tip = end(axis, FAR.move);
      return !tip || Math.hypot(tip[0] - at[0], tip[1] - at[1]) < FLAT * FAR.move;
    });
    const shown: Place[] = isFree ? [] : [at];
    /** The first of some places that nothing stands at. */
    const free = (places: readonly (Place | undefined)[]) =>
      places.findIndex((place) => place && shown.every(([x, y]) => Math.hypot(place[0] - x, place[1] - y) >= APART));
    const arcs: (number | undefined)[] = [];
    for (const { grip, button } of this.buttons) {
      const { does, axis } = grip;
      const isMeant = axis === undefined ? isFree : !(isPoint && does !== "move") && !(does === "turn" ? across(axis).some((other) => isFlat[other]) : isFlat[axis]);
      const places = axis === undefined ? [at] : does === "turn" ? QUARTERS.map((turn) => seen(onArc(middle, axis, FAR.turn * pixel, turn + 0.5))) : [end(axis, FAR[does])];
      const found = isMeant ? free(places) : -1;
      const place = places[found];
      button.hidden = !place;
      if (!place) continue;
      shown.push(place);
      if (axis !== undefined && does === "turn") arcs[axis] = QUARTERS[found];
      button.style.transform = `translate(${place[0].toFixed(1)}px, ${place[1].toFixed(1)}px)`;
    }
    this.#lines.forEach(({ move, turn }, line) => {
      const axis = line as Axis;
      const from = isPoint ? at : end(axis, FAR.scale);
      draw(move, isFlat[axis] ? [] : [from, end(axis, FAR.move)]);
      const quarter = arcs[axis];
      const steps = Array.from({ length: STEPS + 1 }, (_, k) => k / STEPS);
      draw(turn, quarter === undefined ? [] : steps.map((step) => seen(onArc(middle, axis, FAR.turn * pixel, quarter + step))));
    });
  }

  dispose(): void {
    this.#svg.remove();
    this.layer.remove();
  }
}

function buttonOf(grip: Grip): HTMLButtonElement {
  const axis = grip.axis === undefined ? "free" : AXES[grip.axis];
  const button = document.createElement("button");
  button.type = "button";
  button.className = `viewport-grip is-${grip.does} is-${axis}`;
  const label = grip.axis === undefined ? t("viewport.gumball.free") : t(`viewport.gumball.${grip.does}`, { axis });
  button.setAttribute("aria-label", label);
  button.title = `${label}. ${t(grip.axis === undefined ? "viewport.gumball.freeHelp" : `viewport.gumball.${grip.does}Help`)}`;
  return button;
}

/** A point of the circle about an axis, by how many quarters of a turn it is from where that begins. */
function onArc(middle: Point3, axis: Axis, radius: number, quarters: number): Point3 {
  const [u, v] = across(axis);
  const angle = (Math.PI / 2) * quarters;
  return along(middle, [radius * Math.cos(angle), unit(u)], [radius * Math.sin(angle), unit(v)]);
}

function draw(line: SVGPolylineElement, places: readonly (Place | undefined)[]): void {
  const isSeen = places.length > 0 && places.every((place) => place !== undefined);
  line.setAttribute("points", isSeen ? places.map((place) => place?.map((value) => value.toFixed(1)).join()).join(" ") : "");
}
