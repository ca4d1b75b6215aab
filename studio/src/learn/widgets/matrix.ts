/** The cells of a matrix or transform, as the engine has them. */

import { make } from "../elements";
import { number } from "../values";
import { word } from "../words";
import { outputOf, type Place, type Widget } from ".";

/** The numbers of what a matrix reads as. */
function numbers(values: readonly unknown[]): number[] {
  const all = values.flatMap((value) => (Array.isArray(value) ? value : typeof value === "string" ? (value.match(/-?\d[\d.eE+-]*/g) ?? []) : [value]));
  return all.map(Number).filter(Number.isFinite);
}

export function matrixCells({ body, data, lesson }: Place): Widget {
  const cells = make("div", { class: "matrix-cells", role: "group", "aria-label": word("matrix") });
  body.append(cells);
  const refresh = async () => {
    const output = outputOf(lesson, data.object);
    const all = output ? numbers(await lesson.values(...output)) : [];
    const columns = Math.round(Math.sqrt(all.length)) || 1;
    cells.style.gridTemplateColumns = `repeat(${columns}, 1fr)`;
    cells.replaceChildren(...all.map((value) => make("span", {}, number(value, "3"))));
  };
  return { refresh };
}
