/** How a capsule is divided: names of inputs, the band with the name, names of outputs. All in canvas units. */

import { portName, modifiers, sign } from "./ports";
import type { ObjectView } from "./protocol/ObjectView";
import type { PortView } from "./protocol/PortView";
import { textWidth } from "./text";

export const PORT_TEXT = 10;
export const NAME_TEXT = 11;
/** Room between an edge and a name. */
const EDGE = 7;
const LEAST_BAND = 16;

export interface CapsuleLayout {
  /** Where the band begins and ends, from the left. */
  band: [from: number, to: number];
  /** Whether the name stands upright in it, read from below. */
  upright: boolean;
  /** The size of the name's text: smaller where there is less room for it. */
  nameSize: number;
  tornLeft: boolean;
  tornRight: boolean;
}

/** The name with its signs: what takes room. */
function portText(port: PortView, full: boolean): string {
  const signs = modifiers(port).map(sign).join("");
  return portName(port, full) + (signs === "" ? "" : ` ${signs}`);
}

/** The width of a side's names, 0 without any. */
function column(ports: readonly PortView[], full: boolean): number {
  return Math.max(0, ...ports.map((port) => textWidth(portText(port, full), PORT_TEXT)));
}

/** The names' text size: smaller where the rows are lower than it. */
export function portSize(object: ObjectView): number {
  const rows = Math.max(object.inputs.length, object.outputs.length, 1);
  return Math.min(PORT_TEXT, (0.85 * object.bounds[3]) / rows);
}

export function capsuleLayout(object: ObjectView, width: number, full: boolean): CapsuleLayout {
  const left = column(object.inputs, full);
  const right = column(object.outputs, full);
  const height = object.bounds[3];
  const room = width - 2 * EDGE - LEAST_BAND - 6;
  const share = left + right > room ? Math.max(room, 0) / (left + right) : 1;
  const from = object.inputs.length > 0 ? left * share + EDGE + 4 : 5;
  const to = width - (object.outputs.length > 0 ? right * share + EDGE + 4 : 5);
  const band: [number, number] = [from, Math.max(to, from + LEAST_BAND)];
  const wide = band[1] - band[0];
  const long = textWidth((full ? object.name : object.nickname.trim()) || object.name, NAME_TEXT) + 4;
  const upright = long > wide && height > wide;
  const fits = (upright ? height - 4 : wide) / long;
  return {
    band,
    upright,
    nameSize: NAME_TEXT * Math.min(Math.max(fits, 0.7), 1),
    tornLeft: object.inputs.length === 0,
    tornRight: object.outputs.length === 0,
  };
}

/** How much wider a capsule gets on either side when it shows full names. */
export function growth(object: ObjectView, full: boolean): [left: number, right: number] {
  if (!full || (object.kind !== "component" && object.kind !== "cluster")) return [0, 0];
  // What a side needs beyond its share of the width that the document gives: files are laid out with other letters.
  const [from, to] = capsuleLayout(object, object.bounds[2], false).band;
  const more = (ports: readonly PortView[], has: number) => (ports.length === 0 ? 0 : Math.max(0, column(ports, true) + EDGE + 4 - has));
  return [Math.ceil(more(object.inputs, from)), Math.ceil(more(object.outputs, object.bounds[2] - to))];
}

/** The outline of a capsule with torn edges, as the `d` of a path. */
export function tornPath(width: number, height: number, left: boolean, right: boolean): string {
  const r = Math.min(4, height / 4);
  const teeth = Math.max(2, Math.round(height / 8));
  const tooth = height / teeth;
  const down = Array.from({ length: teeth }, (_, k) => {
    const y = k * tooth;
    return `L${width - 3},${f(y + tooth / 2)} L${width},${f(y + tooth)}`;
  });
  const up = Array.from({ length: teeth }, (_, k) => {
    const y = height - k * tooth;
    return `L3,${f(y - tooth / 2)} L0,${f(y - tooth)}`;
  });
  const start = left ? "M0,0" : `M0,${r} Q0,0 ${r},0`;
  const end = right ? `L${width},0 ${down.join(" ")}` : round(width, height, r);
  return `${start} ${end} ${left ? `L0,${height} ${up.join(" ")}` : `L${r},${height} Q0,${height} 0,${height - r}`} Z`;
}

function round(w: number, h: number, r: number): string {
  return `L${w - r},0 Q${w},0 ${w},${r} L${w},${h - r} Q${w},${h} ${w - r},${h}`;
}

function f(x: number): string {
  return String(Math.round(x * 100) / 100);
}
