/**
 * What a picture is made of: paths, each of a tone. A picture is 24 units wide and high; paths have absolute commands
 * only (M L H V C Q S A Z), so that they can be moved, scaled, turned and flipped.
 */

/** Lines and areas in the colour of the text (ink, faint, dash, fill, shade) and in the accent (hot, hotFill, tint). */
export type Tone = "shade" | "tint" | "faint" | "dash" | "ink" | "hot" | "fill" | "hotFill";

export type Piece = readonly [tone: Tone, path: string];
export type Drawing = readonly (Piece | Drawing)[];

/** From the back to the front. */
export const TONES: readonly Tone[] = ["shade", "tint", "faint", "dash", "ink", "hot", "fill", "hotFill"];

const toned =
  (tone: Tone) =>
  (...paths: readonly string[]): Drawing =>
    paths.map((path): Piece => [tone, path]);

export const ink = toned("ink");
export const hot = toned("hot");
export const faint = toned("faint");
export const dash = toned("dash");
export const fill = toned("fill");
export const hotFill = toned("hotFill");
export const shade = toned("shade");
export const tint = toned("tint");

export function isPiece(part: Piece | Drawing): part is Piece {
  return typeof part[0] === "string";
}

/** All pieces, one after the other. */
export function pieces(drawing: Drawing): Piece[] {
  return drawing.flatMap((part): Piece[] => (isPiece(part) ? [part] : pieces(part)));
}

/** One path for each tone of a drawing, from the back to the front. */
export function layers(drawing: Drawing): Piece[] {
  const all = pieces(drawing);
  return TONES.flatMap((tone): Piece[] => {
    const path = all.flatMap((piece) => (piece[0] === tone ? [piece[1]] : [])).join("");
    return path === "" ? [] : [[tone, path]];
  });
}

const ACCENT: Partial<Record<Tone, Tone>> = { ink: "hot", faint: "hot", dash: "hot", fill: "hotFill", shade: "tint" };
const WITHDRAWN: Partial<Record<Tone, Tone>> = { ink: "faint", hot: "faint", fill: "faint", hotFill: "faint", tint: "shade" };

function retoned(drawing: Drawing, tones: Partial<Record<Tone, Tone>>): Drawing {
  return pieces(drawing).map(([tone, path]): Piece => [tones[tone] ?? tone, path]);
}

/** The same in the accent colour. */
export const heat = (drawing: Drawing): Drawing => retoned(drawing, ACCENT);
/** The same in the background: what was there before, or what something is measured by. */
export const fade = (drawing: Drawing): Drawing => retoned(drawing, WITHDRAWN);

/** A number as it stands in a path: in steps of a twentieth, so that drawings stay short. */
export function n(value: number): string {
  return String(Math.round(value * 20) / 20);
}

/** x' = a x + c y + e, y' = b x + d y + f. */
type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

/** Moved, after being scaled about the origin. */
export function place(drawing: Drawing, x: number, y: number, scale = 1): Drawing {
  return mapped(drawing, [scale, 0, 0, scale, x, y]);
}

/** Turned clockwise about a point. */
export function turn(drawing: Drawing, degrees: number, x = 12, y = 12): Drawing {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return mapped(drawing, [c, s, -s, c, x - c * x + s * y, y - s * x - c * y]);
}

/** Left and right exchanged. */
export function flip(drawing: Drawing): Drawing {
  return mapped(drawing, [-1, 0, 0, 1, 24, 0]);
}

/** Drawn smaller in the upper left corner, so that there is room for a mark in the lower right one. */
export function small(drawing: Drawing): Drawing {
  return mapped(drawing, [0.75, 0, 0, 0.75, 0, 0]);
}

function mapped(drawing: Drawing, matrix: Matrix): Drawing {
  return pieces(drawing).map(([tone, path]): Piece => [tone, mapPath(path, matrix)]);
}

function mapPath(path: string, [a, b, c, d, e, f]: Matrix): string {
  let [x, y] = [0, 0];
  let out = "";
  const to = (px: number, py: number) => {
    [x, y] = [px, py];
    return `${n(a * px + c * py + e)} ${n(b * px + d * py + f)}`;
  };
  for (const [, command = "", rest = ""] of path.matchAll(/([A-Z])([^A-Z]*)/g)) {
    const numbers = (rest.match(/-?\d*\.?\d+/g) ?? []).map(Number);
    const at = (k: number) => numbers[k] ?? 0;
    if (command === "Z") out += "Z";
    else if (command === "H") for (const px of numbers) out += `L${to(px, y)}`;
    else if (command === "V") for (const py of numbers) out += `L${to(x, py)}`;
    else if (command === "A") {
      const scale = Math.sqrt(Math.abs(a * d - b * c));
      const turned = at(2) + (Math.atan2(b, a) * 180) / Math.PI;
      const sweep = a * d - b * c < 0 ? 1 - at(4) : at(4);
      const angle = at(0) === at(1) ? 0 : turned;
      out += `A${n(at(0) * scale)} ${n(at(1) * scale)} ${n(angle)} ${at(3)} ${sweep} ${to(at(5), at(6))}`;
    } else {
      const pairs = [];
      for (let k = 0; k + 1 < numbers.length; k += 2) pairs.push(to(at(k), at(k + 1)));
      out += command + pairs.join(" ");
    }
  }
  return out;
}
