/** What stands beside the picture of a figure. */

import type { NurbsView } from "../../core/protocol/NurbsView";
import type { WidgetData } from "../data";
import { make } from "../elements";
import type { Figure } from "../figure";
import type { Lesson } from "../lesson";
import { word } from "../words";
import { basisPlot } from "./basis";
import { combPlot, hodographPlot } from "./bending";
import { falseColours } from "./colours";
import { knotAxis } from "./knots";
import { matrixCells } from "./matrix";
import { parameterPlot } from "./parameters";

export interface Widget {
  refresh(): Promise<void>;
}

/** Where a widget draws, and what it may ask. */
export interface Place {
  data: WidgetData;
  figure: Figure;
  lesson: Lesson;
  /** The element below its heading. */
  body: HTMLElement;
  curve(): Promise<NurbsView | undefined>;
  /** The value of the slider that `at` names. */
  parameter(which?: number): number | undefined;
}

const KINDS: Record<WidgetData["kind"], (place: Place) => Widget> = {
  knots: knotAxis,
  basis: basisPlot,
  comb: combPlot,
  hodograph: hodographPlot,
  matrix: matrixCells,
  uv: parameterPlot,
  colours: falseColours,
};

/** The output that a name means: of `object` the first, or `object.port`. */
export function outputOf(lesson: Lesson, name: string): [string, number] | undefined {
  const whole = lesson.named(name);
  if (whole) return [whole.id, 0];
  const cut = name.lastIndexOf(".");
  const owner = cut < 0 ? undefined : lesson.named(name.slice(0, cut));
  const port = name.slice(cut + 1);
  const place = owner?.outputs.findIndex((one) => one.nickname === port || one.name === port) ?? -1;
  return owner && place >= 0 ? [owner.id, place] : undefined;
}

export function widgetsOf(figure: Figure, lesson: Lesson): Widget[] {
  const list = make("div", { class: "widgets" });
  const widgets = figure.data.widgets.flatMap((data) => {
    const kind = KINDS[data.kind];
    const body = make("div", {});
    list.append(make("section", { class: `widget ${data.kind}` }, make("h4", {}, word(data.kind)), body));
    const output = outputOf(lesson, data.object);
    const curve = () => (output ? lesson.nurbs(...output) : Promise.resolve(undefined));
    const parameter = (which = 0) => {
      const control = lesson.named(data.at[which] ?? "")?.control;
      return control?.is === "slider" ? control.value : undefined;
    };
    return [kind({ data, figure, lesson, body, curve, parameter })];
  });
  if (widgets.length > 0) (figure.querySelector(".take") ?? figure).before(list);
  return widgets;
}
