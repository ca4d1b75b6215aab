/** The view cube: six buttons that look like a cube turned as the model is; and the axes below it. */

import { Vector3 } from "three";

import { t, type Key } from "../../i18n";
import type { CameraRig } from "../camera";
import type { ViewName } from "../views";

const SVG = "http://www.w3.org/2000/svg";
const SIZE = 84;
const HALF = 21;

type Face = Exclude<ViewName, "perspective">;

const FACES: Record<Face, { normal: [number, number, number]; up: [number, number, number] }> = {
  top: { normal: [0, 0, 1], up: [0, 1, 0] },
  bottom: { normal: [0, 0, -1], up: [0, -1, 0] },
  front: { normal: [0, -1, 0], up: [0, 0, 1] },
  back: { normal: [0, 1, 0], up: [0, 0, 1] },
  left: { normal: [-1, 0, 0], up: [0, 0, 1] },
  right: { normal: [1, 0, 0], up: [0, 0, 1] },
};

const AXES = ["x", "y", "z"] as const;

export class ViewCube {
  readonly element: SVGSVGElement;
  #faces = new Map<Face, { group: SVGGElement; shape: SVGPolygonElement; label: SVGTextElement }>();
  #axes = new Map<string, { line: SVGLineElement; label: SVGTextElement }>();

  constructor(choose: (view: ViewName) => void) {
    this.element = make("svg", { viewBox: `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`, class: "viewport-cube" });
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", t("viewport.cube"));
    for (const name of AXES) {
      const line = make("line", { class: `viewport-axis viewport-axis-${name}` });
      const label = make("text", { class: `viewport-axis-label viewport-axis-${name}`, "aria-hidden": "true" });
      label.textContent = name;
      this.element.append(line, label);
      this.#axes.set(name, { line, label });
    }
    for (const face of Object.keys(FACES) as Face[]) this.#addFace(face, choose);
  }

  #addFace(face: Face, choose: (view: ViewName) => void): void {
    const title = t(`viewport.view.${face}` as Key);
    const group = make("g", { role: "button", tabindex: "0", "aria-label": t("viewport.lookFrom", { view: title }) });
    const shape = make("polygon", {});
    const label = make("text", { "aria-hidden": "true" });
    label.textContent = title;
    group.append(shape, label);
    group.addEventListener("click", () => choose(face));
    group.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      event.stopPropagation();
      choose(face);
    });
    this.element.append(group);
    this.#faces.set(face, { group, shape, label });
  }

  /** Turns it as the camera looks. */
  turn(rig: CameraRig): void {
    const [right, up, backward] = [rig.right(), rig.up(), rig.backward()];
    const flat = (point: Vector3): [number, number] => [point.dot(right) * HALF, -point.dot(up) * HALF];
    for (const [face, { group, shape, label }] of this.#faces) {
      const normal = new Vector3(...FACES[face].normal);
      const top = new Vector3(...FACES[face].up);
      const side = top.clone().cross(normal);
      const towards = normal.dot(backward);
      // Those on the far side stay in the tab order, for hands that cannot turn the cube first.
      group.classList.toggle("is-behind", towards < 0.02);
      const corner = (a: number, b: number) => flat(normal.clone().addScaledVector(side, a).addScaledVector(top, b));
      shape.setAttribute("points", [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)].map((p) => p.join()).join(" "));
      const [u, v] = [flat(side), flat(top)].map(([x, y]) => [x / HALF, y / HALF]) as [[number, number], [number, number]];
      const [x, y] = flat(normal);
      // The letters lie in the face.
      label.setAttribute("transform", `matrix(${u[0]} ${u[1]} ${-v[0]} ${-v[1]} ${x} ${y})`);
    }
    const corner = new Vector3(-1.25, -1.25, -1.25);
    AXES.forEach((name, axis) => {
      const entry = this.#axes.get(name);
      if (!entry) return;
      const end = corner.clone().setComponent(axis, 1.1);
      const [[x1, y1], [x2, y2]] = [flat(corner), flat(end)];
      for (const [key, value] of Object.entries({ x1, y1, x2, y2 })) entry.line.setAttribute(key, value.toFixed(2));
      const [lx, ly] = flat(end.setComponent(axis, 1.45));
      entry.label.setAttribute("x", lx.toFixed(2));
      entry.label.setAttribute("y", ly.toFixed(2));
    });
  }

  dispose(): void {
    this.element.remove();
  }
}

function make<K extends keyof SVGElementTagNameMap>(name: K, attributes: Record<string, string>): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}
