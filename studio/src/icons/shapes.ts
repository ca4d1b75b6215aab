/** What components work on: the subjects of pictures, each as large as a picture allows. */

import { circle, dot, ellipse, line, path, poly, rect, speck, type Cubic } from "./lines";
import { faint, fill, hotFill, ink, shade, tint, type Drawing } from "./piece";

// Curves that pictures share. What is added to them is placed by their parameters.
export const WAVE: Cubic = [[3, 18], [8, -10], [16, 34], [21, 6]];
export const ARCH: Cubic = [[3, 19], [5, 4], [19, 4], [21, 19]];
export const RISE: Cubic = [[3, 20], [11, 20], [18, 14], [20, 4]];

export const wave = ink(path(WAVE));
export const arch = ink(path(ARCH));

// A sheet in space, bent both ways; its corners are (2,16), (8,5), (22,7) and (16,19).
const SHEET = "M2 16C6 13 11 22 16 19C17 14 19 10 22 7C17 10 13 2 8 5C6 8 4 12 2 16Z";
const SHEET_LINES = "M5 10.5C9.5 7.5 14.5 16 19 13M9 17.5C10 13 12.5 9 15 6.5";
export const sheet: Drawing = [shade(SHEET), ink(SHEET)];
export const grid: Drawing = [sheet, faint(SHEET_LINES)];
export const hotSheet: Drawing = [tint(SHEET), ink(SHEET)];
export const sheetOutline = SHEET;

// A flat piece, lying.
const FLAT = poly(2, 17, 8, 7, 22, 7, 16, 17);
export const flat: Drawing = [shade(FLAT), ink(FLAT)];
export const hotFlat: Drawing = [tint(FLAT), ink(FLAT)];
export const flatOutline = FLAT;

/** A plane: a flat piece with its axes. */
export const plane: Drawing = [shade(FLAT), ink(FLAT), ink(line(12, 12, 17, 12) + line(12, 12, 14, 9))];

// A cube, seen from a corner: middle (12,11), eight units wide each way.
const BOX_TOP = poly(12, 3, 20, 7, 12, 11, 4, 7);
const BOX_RING = poly(12, 3, 20, 7, 20, 16, 12, 20, 4, 16, 4, 7);
const BOX_LINES = line(4, 7, 12, 11, 20, 7) + line(12, 11, 12, 20);
export const boxRing = BOX_RING;
export const boxTop = BOX_TOP;
export const boxLines = BOX_LINES;
export const boxLeft = poly(4, 7, 12, 11, 12, 20, 4, 16);
export const box: Drawing = [shade(BOX_TOP), ink(BOX_RING, BOX_LINES)];
export const bareBox: Drawing = [ink(BOX_RING, BOX_LINES)];
export const ghostBox: Drawing = [faint(BOX_RING, BOX_LINES)];

/** A solid: a cube without its near corner. */
export const brep: Drawing = [
  shade(poly(8, 9, 16, 9, 12, 15)),
  ink(BOX_RING, line(4, 7, 8, 9), line(20, 7, 16, 9), line(12, 15, 12, 20), poly(8, 9, 16, 9, 12, 15)),
];

// A net of triangles about (12,12).
const NET_RING = poly(3, 9, 10, 3, 20, 6, 21, 15, 13, 21, 4, 17);
const NET_LINES = [line(3, 9, 12, 12, 20, 6), line(10, 3, 12, 12, 13, 21), line(4, 17, 12, 12, 21, 15)];
export const netRing = NET_RING;
export const netLines = NET_LINES.join("");
export const mesh: Drawing = [shade(poly(10, 3, 20, 6, 12, 12)), ink(NET_RING), ink(...NET_LINES)];
export const bareMesh: Drawing = [ink(NET_RING, ...NET_LINES)];
export const ghostMesh: Drawing = [faint(NET_RING, ...NET_LINES)];

/** A cube gone soft. */
const SOFT = "M12 3C18.5 3 21 5.5 21 12S18.5 21 12 21S3 18.5 3 12S5.5 3 12 3Z";
export const softRing = SOFT;
export const softLines = "M4 7.5C9 11 15 11 20 7.5M12 10V21";
export const subd: Drawing = [shade(SOFT), ink(SOFT, softLines)];

export const ball: Drawing = [shade(circle(12, 12, 9)), ink(circle(12, 12, 9)), faint("M3 12C3 16.5 21 16.5 21 12")];
export const tube: Drawing = [
  shade("M5 6V18C5 21.5 19 21.5 19 18V6C19 9.5 5 9.5 5 6Z"),
  ink(ellipse(12, 6, 7, 2.5), "M5 6V18C5 21.3 19 21.3 19 18V6"),
];
export const disc: Drawing = [shade(circle(12, 12, 9)), ink(circle(12, 12, 9))];
/** A flat region without a name. */
const BLOB = "M4 12C4 5 11 3 15 5S21 10 20 14S13 21 9 20S4 16 4 12Z";
export const blob: Drawing = [shade(BLOB), ink(BLOB)];

export const axes: Drawing = [ink(line(4, 20, 4, 3)), ink(line(4, 20, 21, 20))];

/** A row of a list: a dot and a line. */
export const row = (y: number): Drawing => [speck(4, y), ink(line(8.5, y, 20, y))];

/** A column of cells; `filled` are coloured, by their number from above. */
export function cells(x: number, count: number, filled: readonly number[] = [], size = 5, top = 12 - (count * size) / 2): Drawing {
  return Array.from({ length: count }, (_, k) => {
    const y = top + k * size;
    return filled.includes(k) ? [hotFill(rect(x + 1, y + 1, size - 2, size - 2)), ink(rect(x, y, size, size))] : ink(rect(x, y, size, size));
  });
}

/** A data tree: a stem and branches that end in items. */
export const tree: Drawing = [ink(line(3, 12, 8, 12), "M8 12C12 12 10 5 14 5H18", "M8 12H18", "M8 12C12 12 10 19 14 19H18"), dot(20, 5, 20, 12, 20, 19)];

export const page: Drawing = [ink("M5 2H15L20 7V22H5Z", "M15 2V7H20")];

/** A clock's face. */
export const clock: Drawing = [ink(circle(12, 12, 9)), ink(line(12, 6, 12, 12, 16, 14))];
/** A sheet of a calendar. */
export const calendar: Drawing = [ink(rect(3, 5, 18, 16)), ink(line(8, 2, 8, 6), line(16, 2, 16, 6)), fill(rect(3, 5, 18, 5))];
/** Two rings that overlap, and the parts they make. */
export const LEFT_RING = circle(8.5, 12, 6.5);
export const RIGHT_RING = circle(15.5, 12, 6.5);
export const LENS = "M12 6.5A6.5 6.5 0 0 1 12 17.5A6.5 6.5 0 0 1 12 6.5Z";
export const LEFT_MOON = "M12 6.5A6.5 6.5 0 1 0 12 17.5A6.5 6.5 0 0 1 12 6.5Z";
export const RIGHT_MOON = "M12 6.5A6.5 6.5 0 1 1 12 17.5A6.5 6.5 0 0 0 12 6.5Z";
/** The outline of both rings together. */
export const BOTH_RINGS = "M12 6.5A6.5 6.5 0 1 0 12 17.5A6.5 6.5 0 1 0 12 6.5Z";
