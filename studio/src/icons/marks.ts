/** What components do: marks that stand in the lower right corner of a picture, in the accent colour. */

import { arrow, circle, line, poly, rect, span, turnArrow } from "./lines";
import { hot, hotFill, place, tint, type Drawing } from "./piece";
import { word } from "./letters";

/** Where marks stand: they reach four units from there. */
const CORNER = 18.5;
const mark = (drawing: Drawing): Drawing => place(drawing, CORNER, CORNER);

export const plus = mark(hot(line(-4, 0, 4, 0), line(0, -4, 0, 4)));
export const minus = mark(hot(line(-4, 0, 4, 0)));
export const times = mark(hot(line(-3, -3, 3, 3), line(3, -3, -3, 3)));
export const equals = mark(hot(line(-4, -1.5, 4, -1.5), line(-4, 2, 4, 2)));
export const check = mark(hot(line(-4, 0, -1, 3, 4, -3)));
export const ask = mark(word("?", 0, 0, 8, hot));
export const goesOut = mark(hot(arrow(-4, 0, 4, 0)));
export const upDown = mark(hot(span(0, -4, 0, 4)));
export const turns = mark(hot(turnArrow(0, 0, 3.5, -60, 220, 3)));
export const reverses = mark(hot(arrow(-4, -2, 4, -2, 3), arrow(4, 2, -4, 2, 3)));
export const sorts = mark(hot(line(-4, -3, 4, -3), line(-4, 0, 1.5, 0), line(-4, 3, -1.5, 3)));
export const area = mark([tint(rect(-4, -4, 8, 8)), hot(rect(-4, -4, 8, 8), line(-4, 0, 0, -4), line(-4, 4, 4, -4), line(0, 4, 4, 0))]);
export const volume = mark(hot(poly(0, -4.5, 4, -2.5, 4, 2.5, 0, 4.5, -4, 2.5, -4, -2.5), line(-4, -2.5, 0, -0.5, 4, -2.5), line(0, -0.5, 0, 4.5)));
export const leans = mark(hot(line(-4, 4, 4, -4)));
export const eye = mark([hot("M-5 0C-2.5 -4 2.5 -4 5 0C2.5 4 -2.5 4 -5 0Z"), hotFill(circle(0, 0, 1.5))]);
export const lens = mark(hot(circle(-1, -1, 3), line(1.5, 1.5, 4.5, 4.5)));
export const gear = mark(hot(circle(0, 0, 2.5), line(0, -4.5, 0, -2.5), line(0, 2.5, 0, 4.5), line(-4.5, 0, -2.5, 0), line(2.5, 0, 4.5, 0)));
export const triangle = mark([tint(poly(0, -4, 4.5, 4, -4.5, 4)), hot(poly(0, -4, 4.5, 4, -4.5, 4))]);
export const bars = mark(hotFill(rect(-4.5, 1, 2.25, 3.5), rect(-1.25, -1.5, 2.25, 6), rect(2, -4, 2.25, 8.5)));
export const axis = mark(hot(line(-3.5, -4, -3.5, 3.5, 4, 3.5), line(-3.5, 3.5, 2, -2)));
/** Something that is read in. */
export const tray = mark(hot("M-4.5 1V4H4.5V1", arrow(0, -5, 0, 1, 3)));
/** A letter or sign in the corner. */
export const sign = (text: string, height = 7.5): Drawing => place(word(text, 0, 0, height, hot), CORNER - (text.length > 1 ? 1 : 0), CORNER);
