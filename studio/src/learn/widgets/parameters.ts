/** The rectangle of a surface's parameters: a place in it is dragged, or moved by arrow keys, and two sliders follow. */

import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import type { Place, Widget } from ".";
import { Plot, WIDTH } from "./plot";

export function parameterPlot({ body, data, lesson, figure }: Place): Widget {
  const drawing = make("div", { tabindex: 0, role: "group", "aria-label": `${word("uv")}: ${word("drag-hint")}` });
  const told = make("p", { class: "told", role: "status" });
  body.append(drawing, told);
  const sliders = () =>
    data.at.slice(0, 2).flatMap((name) => {
      const control = lesson.named(name)?.control;
      return control?.is === "slider" ? [{ name, ...control }] : [];
    });
  const put = (which: number, share: number) => {
    const slider = sliders()[which];
    if (!slider) return;
    const value = slider.min + Math.min(Math.max(share, 0), 1) * (slider.max - slider.min);
    void figure.set(slider.name, Number(value.toFixed(slider.digits)));
  };
  let isDown = false;
  const under = (event: PointerEvent) => {
    const box = drawing.querySelector("svg")?.getBoundingClientRect();
    if (!box) return;
    const scale = WIDTH / box.width;
    const [x, y] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    put(0, (x - 22) / (WIDTH - 44));
    put(1, 1 - (y - 22) / (240 - 44));
  };
  drawing.addEventListener("pointerdown", (event) => {
    isDown = true;
    drawing.setPointerCapture(event.pointerId);
    under(event);
  });
  drawing.addEventListener("pointermove", (event) => isDown && under(event));
  drawing.addEventListener("pointerup", () => {
    isDown = false;
    for (const { name } of sliders()) figure.ended(name);
  });
  drawing.addEventListener("keydown", (event) => {
    const moves: Record<string, [number, number]> = { ArrowLeft: [0, -0.02], ArrowRight: [0, 0.02], ArrowDown: [1, -0.02], ArrowUp: [1, 0.02] };
    const move = moves[event.key];
    const slider = move && sliders()[move[0]];
    if (!move || !slider) return;
    event.preventDefault();
    put(move[0], (slider.value - slider.min) / (slider.max - slider.min || 1) + move[1]);
  });
  const refresh = () => {
    const [u, v] = sliders();
    if (!u || !v) return Promise.resolve();
    const plot = new Plot(word("uv"), 240, [u.min, u.max], [v.min, v.max]);
    plot.line([[u.min, v.min], [u.max, v.min], [u.max, v.max], [u.min, v.max], [u.min, v.min]], { stroke: "var(--ink)" });
    plot.line([[u.value, v.min], [u.value, v.max]], { stroke: "var(--green)" });
    plot.line([[u.min, v.value], [u.max, v.value]], { stroke: "var(--red)" });
    plot.dot([u.value, v.value], { fill: "var(--blue)" });
    drawing.replaceChildren(plot.svg);
    told.textContent = `(${number(u.value, "3")}, ${number(v.value, "3")})`;
    return Promise.resolve();
  };
  return { refresh };
}
