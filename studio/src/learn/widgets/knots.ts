/** The knots of a curve on an axis, as Rhino or as textbooks count them. */

import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import type { Place, Widget } from ".";
import { hue, Plot } from "./plot";
import { textbook } from "./nurbs";

export function knotAxis({ body, curve, parameter, figure }: Place): Widget {
  let isTextbook = false;
  const name = `knots-${figure.data.id}`;
  const choice = (key: string, value: boolean) => {
    const radio = make("input", { type: "radio", name, checked: value === isTextbook });
    radio.addEventListener("change", () => {
      isTextbook = value;
      void refresh();
    });
    return make("label", {}, radio, ` ${word(key)}`);
  };
  const drawing = make("div");
  const told = make("p", { class: "told", role: "status" });
  body.append(make("div", { class: "keys" }, choice("knots-rhino", false), choice("knots-textbook", true)), drawing, told);
  const refresh = async () => {
    const found = await curve();
    if (!found) return;
    const knots = isTextbook ? textbook(found.knots) : found.knots;
    const [first = 0, last = 1] = [knots[0], knots.at(-1)];
    const heights = new Map<number, number>();
    const stacked = knots.map((knot) => {
      const height = heights.get(knot) ?? 0;
      heights.set(knot, height + 1);
      return [knot, height] as const;
    });
    const most = Math.max(...heights.values());
    const label = `${word("knots")}: ${knots.map((knot) => number(knot, "3")).join(", ")}`;
    const plot = new Plot(label, 60 + 18 * most, [first, last], [-1, most]);
    plot.line([[first, -0.2], [last, -0.2]], { stroke: "var(--ink)", "stroke-width": 1.5 });
    for (const [knot, height] of stacked) plot.dot([knot, height + 0.2], { fill: hue(height) });
    for (const knot of heights.keys()) plot.text([knot, -1], number(knot, "3"));
    const t = parameter();
    if (t !== undefined) plot.line([[t, -0.5], [t, most]], { stroke: "var(--red)" });
    drawing.replaceChildren(plot.svg);
    const { degree, points } = found;
    const rule = isTextbook ? `${points.length} + ${degree} + 1` : `${points.length} + ${degree} − 1`;
    told.textContent = `${knots.length} = ${rule}: ${knots.map((knot) => number(knot, "3")).join(", ")}`;
  };
  return { refresh };
}
