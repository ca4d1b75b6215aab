/** What a curve's derivatives show: the comb with the osculating circle, and the hodograph. */

import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import type { Place, Widget } from ".";
import { bend, jet, length, type Vec } from "./nurbs";
import { Plot } from "./plot";

const SAMPLES = 160;
/** The longest tooth of the comb has this part of the size of the curve. */
const TOOTH = 0.25;

type Flat = [number, number];

/** The two axes along which points reach farthest: most curves of the book lie in a plane of two axes. */
function axesOf(points: readonly Vec[]): [0 | 1 | 2, 0 | 1 | 2] {
  const reach = ([0, 1, 2] as const).map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  const thin = reach.indexOf(Math.min(...reach));
  return thin === 0 ? [1, 2] : thin === 1 ? [0, 2] : [0, 1];
}

function boxOf(points: readonly Flat[]): [Flat, Flat] {
  const along = (axis: 0 | 1): Flat => {
    const values = points.map((point) => point[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  return [along(0), along(1)];
}

export function combPlot({ body, curve, parameter }: Place): Widget {
  const drawing = make("div");
  const told = make("p", { class: "told", role: "status" });
  body.append(drawing, told);
  const refresh = async () => {
    const found = await curve();
    if (!found) return;
    const [start, end] = found.domain;
    const jets = Array.from({ length: SAMPLES + 1 }, (_, k) => jet(found, start + ((end - start) * k) / SAMPLES));
    const [a, b] = axesOf(jets.map(([point]) => point));
    const flat = (v: Vec): Flat => [v[a], v[b]];
    const points = jets.map(([point]) => flat(point));
    const [x, y] = boxOf(points);
    const size = Math.hypot(x[1] - x[0], y[1] - y[0]);
    const bends = jets.map((one) => flat(bend(one)));
    const sharpest = Math.max(...bends.map(([u, v]) => Math.hypot(u, v)), 1e-12);
    const teeth = points.map(([u, v], k): Flat => {
      const [p, q] = bends[k] ?? [0, 0];
      const factor = (TOOTH * size) / sharpest;
      return [u - p * factor, v - q * factor];
    });
    const [bx, by] = boxOf([...points, ...teeth]);
    const plot = new Plot(word("comb"), 280, bx, by, true);
    teeth.forEach((tooth, k) => k % 2 === 0 && plot.line([points[k] ?? tooth, tooth], { stroke: "var(--grey)", "stroke-width": 1 }));
    plot.line(teeth, { stroke: "var(--purple)" });
    plot.line(points, { stroke: "var(--ink)", "stroke-width": 3 });
    const t = parameter();
    if (t !== undefined) {
      const one = jet(found, Math.min(Math.max(t, start), end));
      const turning = bend(one);
      const k = length(turning);
      const here = flat(one[0]);
      if (k > 1e-9) {
        const [u, v] = flat(turning);
        const centre: Flat = [here[0] + u / k ** 2, here[1] + v / k ** 2];
        const ring = Array.from({ length: 73 }, (_, step): Flat => {
          const angle = (step * Math.PI) / 36;
          return [centre[0] + Math.cos(angle) / k, centre[1] + Math.sin(angle) / k];
        });
        plot.line(ring, { stroke: "var(--orange)" });
      }
      plot.dot(here, { fill: "var(--red)" });
      told.textContent = `${word("comb")} ${number(k, "4")}${k > 1e-9 ? `, ${word("radius")} ${number(1 / k, "3")}` : ""}`;
    }
    drawing.replaceChildren(plot.svg);
  };
  return { refresh };
}

export function hodographPlot({ body, curve, parameter }: Place): Widget {
  const drawing = make("div");
  const told = make("p", { class: "told", role: "status" });
  body.append(drawing, told);
  const refresh = async () => {
    const found = await curve();
    if (!found) return;
    const [start, end] = found.domain;
    const speeds = Array.from({ length: SAMPLES + 1 }, (_, k) => jet(found, start + ((end - start) * k) / SAMPLES)[1]);
    const [a, b] = axesOf(speeds);
    const flat = (v: Vec): Flat => [v[a], v[b]];
    const [x, y] = boxOf([[0, 0], ...speeds.map(flat)]);
    const plot = new Plot(word("hodograph"), 260, x, y, true);
    plot.line(speeds.map(flat), { stroke: "var(--teal)", "stroke-width": 3 });
    plot.dot([0, 0], { fill: "var(--ink)", r: 3 });
    const t = parameter();
    if (t !== undefined) {
      const now = jet(found, Math.min(Math.max(t, start), end))[1];
      plot.line([[0, 0], flat(now)], { stroke: "var(--red)" });
      plot.dot(flat(now), { fill: "var(--red)" });
      told.textContent = `(${now.map((value) => number(value, "2")).join(", ")})`;
    }
    drawing.replaceChildren(plot.svg);
  };
  return { refresh };
}
