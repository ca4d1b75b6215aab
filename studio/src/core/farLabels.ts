/**
 * The words of the far view. They keep a size that can be read however far away the canvas is, so they need more room than
 * their boxes have: each stands in its box, else above or below it, and gives way to what counts more.
 */

import type { FarBox, FarLabel, FarList } from "./far";
import { meets, STRUCTURE_BELOW, type Rect } from "./geometry";
import { cut, HALF_BOLD, textWidth } from "./text";

/** The least size of letters, in pixels. */
const LEAST = 9;
/** The most that a name may reach beyond its box, in pixels. */
const LONGEST = 110;
const LINE = 1.25;

export interface PlacedLabel {
  box: FarBox;
  lines: readonly string[];
  size: number;
  /** Where the first line's middle is, and which part of it that is. */
  at: readonly [number, number];
  across: FarLabel["across"];
  bold: boolean;
  /** In its box, on the ground, over a box that is lower than it, or on a dark band of this rectangle below the box. */
  on: "box" | "ground" | "over" | Rect;
}

/** The words to be drawn at a zoom, in canvas units; panning changes nothing about them. */
export function placeLabels(list: FarList, zoom: number): PlacedLabel[] {
  const least = LEAST / zoom;
  const placed: PlacedLabel[] = [];
  const words = new Occupied(least);
  const put = (label: PlacedLabel | undefined, rect: Rect | undefined) => {
    if (!label || !rect || words.meets(withGap(rect, least))) return false;
    words.add(rect);
    placed.push(label);
    return true;
  };
  const texts = list.boxes.filter(({ kind }) => kind === "text");
  const span = spanOf([...list.groups, ...list.boxes]);
  const headings = (boxes: readonly FarBox[], taken?: Occupied) => {
    for (const box of bySize(boxes)) {
      if (zoom < STRUCTURE_BELOW && isSign(box)) continue;
      const places = headingsOf(box, least, zoom, span);
      // Rather where no object stands; but over one where there is no other place.
      const free = places.filter((heading) => !taken?.meets(around(heading)));
      for (const heading of [...free, ...places]) if (put(heading, around(heading))) break;
    }
  };
  if (zoom < STRUCTURE_BELOW) {
    headings([...list.groups, ...texts]);
    return placed;
  }
  // Scribbles and what panels show have one place; the label of a group finds another.
  headings(texts);
  for (const box of bySize(list.boxes)) {
    if (box.kind !== "box" || box.label?.lines !== "many") continue;
    const text = linesIn(box, box.label, least);
    if (text) put(text, around(text));
  }
  const taken = new Occupied(least);
  for (const { kind, rect } of list.boxes) if (kind === "box") taken.add(rect);
  headings(list.groups, taken);
  for (const box of bySize(list.boxes)) {
    if (box.kind !== "box" || box.label?.lines !== "one") continue;
    for (const label of namesOf(box, box.label, least, zoom)) {
      const rect = around(label);
      const isFree = label.on === "box" || !taken.meets(rect, box.rect);
      if (isFree && put(label, rect)) break;
    }
    const band = bandOf(box, least);
    if (band && !taken.meets(around(band), box.rect)) put(band, around(band));
  }
  return placed;
}

/** Where everything begins and ends across: words go no farther, as the window that shows everything does not. */
function spanOf(boxes: readonly FarBox[]): Span {
  return boxes.reduce<Span>(([start, end], { rect: [x, , w] }) => [Math.min(start, x), Math.max(end, x + w)], [Infinity, -Infinity]);
}

type Span = readonly [start: number, end: number];

/** Words beside each other do not read as one. */
function withGap([x, y, w, h]: Rect, least: number): Rect {
  const gap = least * 0.4;
  return [x - gap, y, w + 2 * gap, h];
}

/** A letter or two, as `b` over a vector's input: they tell nothing where what they stand for cannot be seen. */
function isSign(box: FarBox): boolean {
  return (box.label?.text.length ?? 0) < 3;
}

/** What is larger counts more. */
function bySize(boxes: readonly FarBox[]): FarBox[] {
  return [...boxes].sort((a, b) => b.rect[2] * b.rect[3] - a.rect[2] * a.rect[3]);
}

function width(text: string, size: number, bold: boolean): number {
  return textWidth(text, size) * (bold ? HALF_BOLD : 1);
}

function around({ lines, size, at: [x, y], across, bold, on }: PlacedLabel): Rect {
  if (typeof on !== "string") return on;
  const wide = Math.max(...lines.map((line) => width(line, size, bold)));
  const left = across === "left" ? x : across === "right" ? x - wide : x - wide / 2;
  return [left, y - size * 0.6, wide, size * (1.2 + LINE * (lines.length - 1))];
}

/**
 * The label of a group stands at its upper left, within it where it is high enough, else above it. What is longer than its
 * box and would go beyond the end of everything begins farther to the left.
 */
function headingsOf(box: FarBox, least: number, zoom: number, [start, end]: Span): PlacedLabel[] {
  const { label, rect } = box;
  if (!label) return [];
  const [x, y, w, h] = rect;
  const size = Math.max(label.size, least * (box.kind === "text" ? 1 : 1.1));
  const room = Math.max(w, LONGEST / zoom);
  const lines = label.text.split("\n").slice(0, 4).map((line) => cut(line, size * HALF_BOLD, room));
  const at = (shown: string[], left: number, top: number): PlacedLabel => ({
    box, lines: shown, size, at: [left, top], across: "left", bold: label.bold, on: "ground",
  });
  const both = (shown: string[], left: number, top: number): PlacedLabel[] => {
    const long = Math.max(...shown.map((line) => width(line, size, label.bold)));
    const back = Math.min(left, Math.max(end - long, start));
    return back < left ? [at(shown, back, top), at(shown, left, top)] : [at(shown, left, top)];
  };
  const inside = both(lines, x + Math.min(6, w / 8), y + size * 0.8);
  const above = both(lines.slice(0, 1), x, y - size * 0.6);
  if (box.kind === "text") return inside;
  if (h <= size * 2.4) return above;
  // From farthest away words above a box would be taken for those of another.
  return zoom < STRUCTURE_BELOW ? inside : [...inside, ...above];
}

/** The first lines of a text, as many as its box holds. */
function linesIn(box: FarBox, label: FarLabel, least: number): PlacedLabel | undefined {
  const [x, y, w, h] = box.rect;
  const size = Math.max(label.size, least);
  const count = Math.floor((h - 2) / (size * LINE));
  if (count < 1 && h < size * 0.9) return undefined;
  const edge = Math.min(4, w / 10);
  const lines = label.text.split("\n").slice(0, Math.max(count, 1)).map((line) => cut(line, size, w - 2 * edge));
  if (lines.every((line) => line.length < 2)) return undefined;
  const [left, right] = [x + edge, x + w - edge];
  const across = label.across === "left" ? left : label.across === "right" ? right : (left + right) / 2;
  const top = count <= 1 ? y + h / 2 : y + size * 0.85;
  return { box, lines, size, at: [across, top], across: label.across, bold: false, on: "box" };
}

/** The places where a name may stand, the best first. */
function* namesOf(box: FarBox, label: FarLabel, least: number, zoom: number): Generator<PlacedLabel> {
  const [x, y, w, h] = box.rect;
  const size = Math.max(label.size, least);
  const middle = x + w / 2;
  const long = width(label.text, size, label.bold);
  const one = (text: string, at: number, on: "box" | "ground" | "over"): PlacedLabel => ({
    box, lines: [text], size, at: [middle, at], across: "centre", bold: label.bold, on,
  });
  if (long <= w - 2 && h >= size * 0.9) yield one(label.text, y + h / 2, "box");
  // The value of a slider says more than its name.
  if (label.short !== undefined && width(label.short, size, label.bold) <= w - 2) {
    yield one(label.short, y + h / 2, h >= size * 0.9 ? "box" : "over");
  }
  const text = cut(label.text, size, Math.max(w, LONGEST / zoom));
  yield one(text, y - size * 0.65, "ground");
  yield one(text, y + h + size * 0.65, "ground");
  const rest = cut(label.text, size, w - 2);
  if (rest.length > 3 && h >= size * 0.9) yield one(rest, y + h / 2, "box");
}

/** The message of a component on its dark band. */
function bandOf(box: FarBox, least: number): PlacedLabel | undefined {
  if (!box.strip) return undefined;
  const [x, y, w, h] = box.rect;
  const size = least * 0.95;
  const wide = Math.max(textWidth(box.strip, size) + size * 0.8, w);
  const rect: Rect = [x + w / 2 - wide / 2, y + h, wide, size * 1.3];
  return { box, lines: [box.strip], size, at: [x + w / 2, y + h + size * 0.65], across: "centre", bold: false, on: rect };
}

/** Rectangles by the cells of a grid that they lie in, to find those that meet one. */
class Occupied {
  #cells = new Map<string, Rect[]>();
  #side: number;

  constructor(least: number) {
    this.#side = least * 8;
  }

  *#keys([x, y, w, h]: Rect): Generator<string> {
    const cell = (at: number) => Math.floor(at / this.#side);
    for (let i = cell(x); i <= cell(x + w); i++) for (let j = cell(y); j <= cell(y + h); j++) yield `${i},${j}`;
  }

  add(rect: Rect): void {
    for (const key of this.#keys(rect)) {
      const known = this.#cells.get(key);
      if (known) known.push(rect);
      else this.#cells.set(key, [rect]);
    }
  }

  /** Whether one of them, but for this one, meets a rectangle. */
  meets(rect: Rect, except?: Rect): boolean {
    for (const key of this.#keys(rect)) {
      if (this.#cells.get(key)?.some((one) => one !== except && meets(one, rect))) return true;
    }
    return false;
  }
}
