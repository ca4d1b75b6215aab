/** The basis functions of a curve: what part each control point has, all along. */

import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import type { Place, Widget } from ".";
import { basis, textbook } from "./nurbs";
import { hue, Plot } from "./plot";

const SAMPLES = 240;

export function basisPlot({ body, curve, parameter }: Place): Widget {
  const drawing = make("div");
  const told = make("p", { class: "told", role: "status" });
  body.append(drawing, told);
  const refresh = async () => {
    const found = await curve();
    if (!found) return;
    const { degree, domain, weights } = found;
    const full = textbook(found.knots);
    const rows = Array.from({ length: SAMPLES + 1 }, (_, k) => {
      const t = domain[0] + ((domain[1] - domain[0]) * k) / SAMPLES;
      return [t, parts(basis(degree, full, t), weights)] as const;
    });
    const now = parameter();
    const values = now === undefined ? undefined : parts(basis(degree, full, now), weights);
    const plot = new Plot(word("basis"), 220, [domain[0], domain[1]], [0, 1]);
    found.points.forEach((_, i) => {
      const line = rows.map(([t, all]) => [t, all[i] ?? 0] as const);
      const isActive = values !== undefined && (values[i] ?? 0) > 1e-12;
      if (isActive) plot.line([[domain[0], 0], ...line, [domain[1], 0]], { fill: hue(i), "fill-opacity": 0.16, stroke: "none" });
      plot.line(line, { stroke: hue(i), "stroke-width": isActive ? 3 : 1.5 });
    });
    if (now !== undefined && values) {
      plot.line([[now, 0], [now, 1]], { stroke: "var(--ink)", "stroke-width": 1, "stroke-dasharray": "4 3" });
      values.forEach((value, i) => value > 1e-12 && plot.dot([now, value], { fill: hue(i) }));
      const shares = values.flatMap((value, i) => (value > 1e-12 ? `P${i} ${number(value, "3")}` : []));
      told.textContent = shares.join(", ");
    }
    drawing.replaceChildren(plot.svg);
  };
  return { refresh };
}

/** Shares with weights: they add up to 1 all the same. */
function parts(values: readonly number[], weights: readonly number[]): number[] {
  const weighted = values.map((value, i) => value * (weights[i] ?? 1));
  const total = weighted.reduce((sum, x) => sum + x, 0) || 1;
  return weighted.map((x) => x / total);
}
