/** Points that a reader drags: buttons over the picture, which arrow keys move too. */

import { Plane, Ray, Vector3 } from "three";

import { make } from "./elements";
import type { Lesson } from "./lesson";
import type { FigureData } from "./data";
import type { Stage } from "./stage";
import { number } from "./values";
import { word } from "./words";

type Point = [number, number, number];

interface Grip {
  button: HTMLButtonElement;
  name: string;
  index: number;
  at: Point;
  /** Where it was at first. */
  first: Point;
}

/** The normal of the plane in which a point is dragged, by the view. */
const NORMALS: Record<string, Point> = { front: [0, 1, 0], right: [1, 0, 0] };
/** Arrow keys move a point by this part of what is seen. */
const SHARE = 0.02;

/** What stands on the button of a point: its name, or of a list with a long name its number. */
function labelOf(name: string, index: number, isOneOfMany: boolean): string {
  if (!isOneOfMany) return name;
  return name.length <= 2 ? `${name}${index}` : String(index);
}

export class Grips {
  #stage: Stage;
  #lesson: Lesson;
  #data: FigureData;
  #grips: Grip[] = [];
  #dragged: Grip | undefined;
  #gesture: number | null = null;

  constructor(stage: Stage, lesson: Lesson, data: FigureData) {
    this.#stage = stage;
    this.#lesson = lesson;
    this.#data = data;
    lesson.onSolved.add(() => void this.refresh());
    void this.refresh();
  }

  /** Takes up where the points are now. */
  async refresh(): Promise<void> {
    for (const name of this.#data.drag) {
      const object = this.#lesson.named(name);
      if (!object) continue;
      const values = await this.#lesson.values(object.id, 0);
      values.forEach((value, index) => {
        if (!Array.isArray(value) || value.length !== 3) return;
        const known = this.#grips.find((grip) => grip.name === name && grip.index === index);
        const grip = known ?? this.#make(name, index, values.length > 1, value as Point);
        if (grip !== this.#dragged) grip.at = value as Point;
        const told = value.map((x) => number(x, "2")).join(", ");
        const title = values.length > 1 ? `${name} ${index}` : name;
        grip.button.setAttribute("aria-label", `${word("point")} ${title} (${told}), ${word("drag-hint")}`);
      });
    }
    this.place();
  }

  /** The points that are not where they were, by their names. */
  moved(): [string, Point][] {
    const far = ({ at, first }: Grip) => at.some((x, axis) => x !== first[axis]);
    return this.#grips.filter(far).map(({ name, at }): [string, Point] => [name, at]);
  }

  /** Puts all points back. */
  async reset(): Promise<void> {
    for (const grip of this.#grips) {
      if (grip.at.every((x, axis) => x === grip.first[axis])) continue;
      grip.at = grip.first;
      await this.#keep(grip, grip.first).catch(() => undefined);
    }
    this.place();
  }

  /** Puts the buttons where their points are seen. */
  place(): void {
    for (const { button, at } of this.#grips) {
      const place = this.#stage.viewport.placeOf(at);
      button.hidden = !place;
      if (place) button.style.transform = `translate(${place[0]}px, ${place[1]}px) translate(-50%, -50%)`;
    }
  }

  #make(name: string, index: number, isOneOfMany: boolean, at: Point): Grip {
    const button = make("button", { type: "button", class: "grip" }, labelOf(name, index, isOneOfMany));
    const grip: Grip = { button, name, index, at, first: at };
    this.#grips.push(grip);
    this.#stage.host.append(button);
    button.addEventListener("pointerdown", (event) => {
      this.#dragged = grip;
      this.#gesture = this.#lesson.newGesture();
      button.setPointerCapture(event.pointerId);
      event.preventDefault();
      button.focus();
    });
    button.addEventListener("pointermove", (event) => {
      if (this.#dragged === grip) this.#moveTo(grip, this.#under(event, grip.at));
    });
    const end = () => {
      this.#dragged = undefined;
      this.#gesture = null;
    };
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
    button.addEventListener("keydown", (event) => {
      const moves: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const move = moves[event.key];
      if (!move) return;
      event.preventDefault();
      const rig = this.#stage.viewport.panes.active.rig;
      const step = rig.pose.height * SHARE;
      // Along the axes of the plane in which the point moves.
      const [x, y, z] = grip.at;
      const [a, b] = [move[0] * step, move[1] * step];
      const { view } = this.#data;
      this.#moveTo(grip, view === "front" ? [x + a, y, z + b] : view === "right" ? [x, y + a, z + b] : [x + a, y + b, z]);
    });
    return grip;
  }

  /** The point under the pointer, in the plane through the point as it was. */
  #under(event: PointerEvent, at: Point): Point {
    const box = this.#stage.host.getBoundingClientRect();
    const { rig } = this.#stage.viewport.panes.active;
    const [x, y] = [((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2];
    const { origin, direction } = rig.ray(x, y, box.width / box.height);
    const normal = new Vector3(...(NORMALS[this.#data.view] ?? [0, 0, 1]));
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(...at));
    const hit = new Ray(origin, direction.clone().normalize()).intersectPlane(plane, new Vector3());
    return hit ? [hit.x, hit.y, hit.z] : at;
  }

  #moveTo(grip: Grip, to: Point): void {
    const digits = Math.max(0, 3 - Math.ceil(Math.log10(Math.max(this.#stage.viewport.panes.active.rig.pose.height, 1e-9))));
    const rounded = to.map((x) => Number(x.toFixed(Math.min(digits, 12)))) as Point;
    if (rounded.every((x, axis) => x === grip.at[axis])) return;
    grip.at = rounded;
    this.place();
    void this.#keep(grip, rounded).catch(() => undefined);
  }

  async #keep({ name, index }: Grip, to: Point): Promise<void> {
    const object = this.#lesson.named(name);
    if (!object) return;
    if (object.name === "Construct Point") {
      for (const [axis, port] of object.inputs.entries()) {
        const value = to[axis];
        if (value === undefined) continue;
        const source = port.sources[0];
        if (source === undefined) {
          await this.#lesson.edit({ do: "keep", port: port.id, values: String(value) }, this.#gesture);
          continue;
        }
        const slider = [...this.#lesson.objects.values()].find((one) => one.outputs.some((output) => output.id === source));
        if (slider?.control?.is !== "slider") continue;
        const { min, max } = slider.control;
        const within = Math.min(Math.max(value, Math.min(min, max)), Math.max(min, max));
        await this.#lesson.edit({ do: "set", object: slider.id, to: { is: "number", value: within } }, this.#gesture);
      }
      return;
    }
    const port = object.inputs[0];
    if (!port) return;
    const all = (await this.#lesson.values(object.id, 0)).map((value, at) => (at === index ? to : value));
    const values = all.map((point) => (Array.isArray(point) ? `{${point.join(", ")}}` : "")).join("\n");
    await this.#lesson.edit({ do: "keep", port: port.id, values }, this.#gesture);
  }
}
