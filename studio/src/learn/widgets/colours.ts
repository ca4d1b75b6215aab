/** False colours of the surfaces in the picture, with what they mean. */

import { colourAt } from "../../core/falseColour";
import type { Analysis } from "../../viewport/settings";
import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import type { Place, Widget } from ".";

const MEASURES: Record<string, Analysis> = { gaussian: "gaussian", mean: "mean", minimum: "lesser", maximum: "greater" };
const STEPS = 12;

export function falseColours({ body, data, figure }: Place): Widget {
  const measure = data.measure ?? "gaussian";
  const analysis = MEASURES[measure] ?? "none";
  const { stage } = figure;
  const box = make("input", { type: "checkbox" });
  box.checked = true;
  const bar = make("div", { class: "legend", "aria-hidden": "true" });
  const told = make("p", { class: "told", role: "status" });
  const stops = Array.from({ length: STEPS + 1 }, (_, k) => `rgb(${colourAt(k / STEPS).slice(0, 3).join(" ")})`);
  bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
  body.append(make("label", {}, box, ` ${word(measure)}`), bar, told);
  const show = () => {
    const legend = stage?.state.getState().legend;
    const isOn = box.checked && legend !== undefined;
    bar.hidden = !isOn;
    const text = isOn ? `${number(legend.range[0], "4")} – ${number(legend.range[1], "4")}` : "";
    if (told.textContent !== text) told.textContent = text;
  };
  const colour = () => stage?.settings.setState({ analysis: box.checked ? analysis : "none" });
  box.addEventListener("change", () => {
    colour();
    show();
  });
  stage?.state.subscribe(show);
  colour();
  return {
    refresh: () => {
      show();
      return Promise.resolve();
    },
  };
}
