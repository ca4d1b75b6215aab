/** From a popup code or a find to what the session is asked to place. */

import { IDS, named, type CatalogueEntry, type CataloguePort } from "./catalogue";
import type { Popup } from "./popup";
import type { Initial } from "./protocol/Initial";

/** A component and how it begins. */
export interface Placing {
  component: string;
  /** What the list of finds calls it. */
  name: string;
  with: Initial | null;
}

/** What a code places; none when its component is not in the catalogue. */
export function placing(popup: Popup, catalogue: readonly CatalogueEntry[]): Placing | undefined {
  switch (popup.is) {
    case "panel":
      return { component: IDS.panel, name: "Panel", with: { is: "control", control: panel(popup.text) } };
    case "scribble":
      return { component: IDS.scribble, name: "Scribble", with: { is: "control", control: scribble(popup.text) } };
    case "slider":
      return { component: IDS.slider, name: "Number Slider", with: { is: "control", control: popup.slider } };
    case "point":
      return { component: IDS.point, name: "Point", with: values(0, `{${popup.at.join(",")}}`) };
    case "operator": {
      const entry = named(catalogue, popup.component);
      const start = popup.value === undefined ? null : values(popup.input, popup.value);
      return entry && { component: entry.guid, name: entry.name, with: start };
    }
    case "initialised": {
      const entry = named(catalogue, popup.component) ?? byNickname(catalogue, popup.component);
      if (!entry) return undefined;
      const input = taker(entry.inputs, popup.value);
      return { component: entry.guid, name: entry.name, with: input < 0 ? null : values(input, popup.value) };
    }
  }
}

function byNickname(catalogue: readonly CatalogueEntry[], name: string): CatalogueEntry | undefined {
  const wanted = name.toLowerCase();
  return (
    catalogue.find((entry) => !entry.old && entry.nick.toLowerCase() === wanted) ??
    catalogue.find((entry) => !entry.old && entry.name.toLowerCase().startsWith(wanted))
  );
}

const NUMERIC = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;

/** The first input that a value suits, by the look of the value; else the first of all, −1 where there is none. */
export function taker(inputs: readonly CataloguePort[], value: string): number {
  const kinds = NUMERIC.test(value.trim())
    ? ["Number", "Integer", "Angle", "Percentage"]
    : /^(true|false)$/i.test(value.trim())
      ? ["Boolean"]
      : /^\{?[^{}]*,[^{}]*\}?$/.test(value)
        ? ["Point", "Vector", "Colour"]
        : ["Text", "Generic Data"];
  const suited = inputs.findIndex((input) => kinds.includes(input.kind));
  return suited >= 0 ? suited : inputs.length > 0 ? 0 : -1;
}

/** What new calendars and clocks are set to: the present of whoever places them. Others begin as the session has them. */
export function present(component: string, now: Date): Initial | null {
  if (component === IDS.calendar) {
    const [year, month] = [now.getFullYear(), now.getMonth() + 1];
    return { is: "control", control: { is: "calendar", date: [year, month, now.getDate()], shown: [year, month] } };
  }
  if (component !== IDS.clock) return null;
  return { is: "control", control: { is: "clock", seconds: now.getHours() * 3600 + now.getMinutes() * 60 } };
}

function values(input: number, text: string): Initial {
  return { is: "values", values: [[input, text]] };
}

function panel(text: string) {
  return {
    is: "panel" as const,
    text: text.replaceAll("\\n", "\n"),
    multiline: true,
    paths: true,
    indices: true,
    wrap: true,
    specialCodes: false,
    alignment: 0,
    colour: [255, 250, 90, 255] as [number, number, number, number],
    stream: null,
  };
}

function scribble(text: string) {
  const size = 25;
  const [width, height] = [Math.max(text.length, 1) * size * 0.55, size * 1.3];
  const corners: [[number, number], [number, number], [number, number], [number, number]] = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ];
  return { is: "scribble" as const, text, font: "Arial", size, bold: false, italic: false, corners };
}
