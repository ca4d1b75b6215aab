/** The cells of a matrix or transform, as the engine has them. Those that sliders give can be typed into; the way to it can be played. */

import type { ObjectView } from "../../core/protocol/ObjectView";
import { button, make } from "../elements";
import type { Lesson } from "../lesson";
import { number } from "../values";
import { word } from "../words";
import { outputOf, type Place, type Widget } from ".";
import { play, type Way } from "./play";

/** The numbers of what a matrix reads as. */
function numbers(values: readonly unknown[]): number[] {
  const all = values.flatMap((value) => (Array.isArray(value) ? value : typeof value === "string" ? (value.match(/-?\d[\d.eE+-]*/g) ?? []) : [value]));
  return all.map(Number).filter(Number.isFinite);
}

/** The object that has this output. */
const ownerOf = (lesson: Lesson, output: string | undefined): ObjectView | undefined =>
  [...lesson.objects.values()].find((one) => one.outputs.some(({ id }) => id === output));

/** The sliders that give cells, by the place of the cell: the matrix is made of a list, and sliders go into the list one by one. */
function slidersOf(lesson: Lesson, name: string, count: number): Map<number, string> {
  const found = new Map<number, string>();
  let object = lesson.named(name);
  if (object?.name === "Construct Matrix") object = ownerOf(lesson, object.inputs.at(-1)?.sources[0]);
  if (object?.name !== "Merge") return found;
  const inputs = object.inputs.filter(({ sources, kept }) => sources.length + kept > 0);
  if (inputs.length !== count) return found;
  inputs.forEach(({ sources }, place) => {
    const source = sources.length === 1 ? ownerOf(lesson, sources[0]) : undefined;
    if (source?.control?.is === "slider") found.set(place, source.nickname);
  });
  return found;
}

/** `xS:11` gives the cell in row 1 and column 1; a name alone is a slider that moves the whole, as an angle does. */
function told(at: readonly string[], columns: number): { cells: Map<number, string>; others: string[] } {
  const cells = new Map<number, string>();
  const others: string[] = [];
  for (const one of at) {
    const [, name = "", row, column] = /^(.*):(\d)(\d)$/.exec(one) ?? [];
    if (row && column) cells.set((Number(row) - 1) * columns + Number(column) - 1, name);
    else others.push(one);
  }
  return { cells, others };
}

/** The numbers of a matrix, row by row: a matrix itself reads as its size alone, so those that it is made of are taken. */
async function entriesOf(lesson: Lesson, name: string): Promise<number[]> {
  const object = lesson.named(name);
  const source = object?.name === "Construct Matrix" ? object.inputs.at(-1)?.sources[0] : undefined;
  const maker = ownerOf(lesson, source);
  const output = maker ? ([maker.id, maker.outputs.findIndex(({ id }) => id === source)] as const) : outputOf(lesson, name);
  return output ? numbers(await lesson.values(...output)) : [];
}

export function matrixCells({ body, data, lesson, figure }: Place): Widget {
  const cells = make("div", { class: "matrix-cells", role: "group", "aria-label": word("matrix") });
  const way = button(word("play"), () => void play(figure, ways()), { hidden: true });
  body.append(cells, make("div", { class: "keys" }, way));
  let fields: (HTMLInputElement | HTMLElement)[] = [];
  let sliders = new Map<number, string>();
  let others: string[] = [];
  let columns = 1;

  const sliderOf = (name: string) => {
    const control = lesson.named(name)?.control;
    return control?.is === "slider" ? control : undefined;
  };

  /** From the matrix that changes nothing to the one that is there now. */
  const ways = (): Way[] => {
    const isDiagonal = (place: number) => place % columns === Math.floor(place / columns);
    const all = [...[...sliders].map(([place, name]) => [name, isDiagonal(place) ? 1 : 0] as const), ...others.map((name) => [name, 0] as const)];
    return all.flatMap(([name, from]) => {
      const slider = sliderOf(name);
      return slider ? [{ name, from: Math.min(Math.max(from, slider.min), slider.max), to: slider.value, digits: slider.digits }] : [];
    });
  };

  const field = (place: number): HTMLElement => {
    const name = sliders.get(place);
    const slider = name === undefined ? undefined : sliderOf(name);
    const label = word("cell", { row: Math.floor(place / columns) + 1, column: (place % columns) + 1 });
    if (name === undefined || !slider) return make("span", { class: "cell" });
    const input = make("input", { class: "cell", type: "number", min: slider.min, max: slider.max, step: 10 ** -Math.min(slider.digits, 2), "aria-label": `${label}, ${name}`, title: name });
    input.addEventListener("input", () => {
      const value = input.valueAsNumber;
      if (Number.isFinite(value)) void figure.set(name, Math.min(Math.max(value, slider.min), slider.max));
    });
    input.addEventListener("change", () => {
      figure.ended(name);
      void refresh();
    });
    return input;
  };

  const build = (count: number) => {
    columns = Math.round(Math.sqrt(count)) || 1;
    const named = told(data.at, columns);
    sliders = new Map([...slidersOf(lesson, data.object, count), ...named.cells]);
    others = named.others;
    fields = Array.from({ length: count }, (_, place) => field(place));
    cells.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    cells.replaceChildren(...fields);
    way.hidden = ways().length === 0;
  };

  const refresh = async () => {
    const all = await entriesOf(lesson, data.object);
    if (all.length !== fields.length) build(all.length);
    fields.forEach((one, place) => {
      const value = all[place] ?? 0;
      if (!(one instanceof HTMLInputElement)) one.textContent = number(value, "3");
      // What is being typed stays as it is typed.
      else if (one !== document.activeElement || one.valueAsNumber !== value) one.value = String(Number(value.toFixed(6)));
    });
  };
  return { refresh };
}
