/** The pictures of the Display tab. */

import { arc, arrow, circle, dot, head, hotDot, hotSpeck, line, poly, rect, span, speck } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { faint, fill, hot, hotFill, ink, place, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

/** Three discs of which the middle is shared, and the letters of a colour space. */
const discs: Drawing = [tint(circle(8, 6.5, 4.5)), hotFill(circle(12, 6.5, 2)), ink(circle(8, 6.5, 4.5), circle(16, 6.5, 4.5))];
const space = (letters: string, wide = 7): Drawing => [discs, word(letters, 12, 18, wide)];
const apart = (letters: string): Drawing => [word(letters, 12, 6, letters.length > 3 ? 5.5 : 7), hot(line(12, 11, 12, 14), arrow(12, 14, 4, 20, 3), arrow(12, 14, 20, 20, 3), arrow(12, 14, 12, 21, 3))];
const papers: Drawing = [ink(rect(2, 2, 16, 14))];
const projected: Drawing = [ink(poly(5, 6, 10, 3, 15, 6, 15, 12, 10, 15, 5, 12), line(5, 6, 10, 9, 15, 6), line(10, 9, 10, 15))];

export const display: Tab = {
  Colour: {
    Addition: [ink(circle(6, 12, 4)), hotFill(circle(18, 12, 4)), hot(line(12, 9.5, 12, 14.5), line(9.5, 12, 14.5, 12))],
    "Colour CMYK": [discs, word("CMYK", 12, 18, 5.5)],
    "Colour HSL": space("HSL"),
    "Colour HSV": space("HSV"),
    "Colour L*ab": space("Lab"),
    "Colour LCH": space("LCH"),
    "Colour RGB": space("RGB"),
    "Colour RGB (f)": [discs, word("RGB", 8, 18, 6), word("f", 21, 18, 7, hot)],
    "Colour XYZ": space("XYZ"),
    "Split AHSL": apart("AHSL"),
    "Split AHSV": apart("AHSV"),
    "Split ARGB": apart("ARGB"),
  },
  Dimensions: {
    "Aligned Dimension": [ink(line(3, 21, 20, 12)), hot(span(3, 13, 18, 5, 3), line(2, 11, 5, 17), line(17, 3, 20, 9))],
    "Angular Dimension": [ink(line(18, 4, 4, 20, 22, 20)), hot(arc(4, 20, 12, -49, 0), head(16, 20, 0, 1, 3), head(12, 11, -1, -0.9, 3))],
    "Angular Dimensions (Mesh)": [ink(poly(3, 20, 21, 20, 11, 3)), faint(line(11, 3, 13, 20)), hot(arc(3, 20, 6, -65, 0), arc(21, 20, 6, 180, 240), arc(11, 3, 5, 60, 115))],
    "Arc Dimension": [ink(arc(12, 23, 10, 200, 340)), hot(arc(12, 23, 15, 222, 318), head(1, 13, -1, 1, 3), head(23, 13, 1, 1, 3)), hot(arc(12, 23, 15, 222, 318))],
    "Circular Dimension": [ink(circle(12, 12, 9)), hot(span(6, 18, 18, 6, 3)), word("R", 8, 8, 5, hot)],
    "Gradient Hatch": [ink(rect(3, 3, 18, 18)), shade(rect(9, 3, 12, 18)), tint(rect(13, 3, 8, 18)), hotFill(rect(17, 4, 3, 16))],
    "Line Dimension": [ink(line(4, 18, 20, 18)), dot(4, 18, 20, 18), hot(span(4, 8, 20, 8, 3), line(4, 5, 4, 14), line(20, 5, 20, 14))],
    "Linear Dimension": [ink(line(4, 20, 20, 13)), hot(span(4, 6, 20, 6, 3), line(4, 3, 4, 16), line(20, 3, 20, 10))],
    Make2D: [place(s.ghostBox, 0, -1, 0.6), ink(poly(10, 13, 17, 10, 22, 14, 22, 20, 15, 23, 10, 19)), hot(line(10, 13, 15, 17, 22, 14), line(15, 17, 15, 23))],
    "Make2D Parallel View": [small([shade(s.boxTop), ink(s.boxRing, s.boxLines)]), hot(line(14, 15, 23, 15), line(14, 19, 23, 19), line(14, 23, 23, 23))],
    "Make2D Perspective View": [small([shade(s.boxTop), ink(s.boxRing, s.boxLines)]), hot(line(23, 14, 14, 19, 23, 23), line(14, 19, 23, 19))],
    "Make2D Rhino View": [papers, place(projected, 0.5, 0.3, 0.95), hot(line(6, 20, 14, 20), line(10, 16, 10, 20)), mark.eye],
    "Marker Dimension": [ink(line(3, 21, 13, 11)), hot(head(3, 21, -1, 1, 4)), hot(rect(12, 3, 10, 8)), hot(line(15, 7, 19, 7))],
    "Pattern Hatch": [ink(rect(3, 3, 18, 18)), hot(line(3, 9, 9, 3), line(3, 15, 15, 3), line(3, 21, 21, 3), line(9, 21, 21, 9), line(15, 21, 21, 15))],
    "Serial Dimension": [ink(line(3, 20, 21, 20)), dot(3, 20, 9, 20, 15, 20, 21, 20), hot(line(3, 15, 3, 4), line(3, 13, 9, 13, 9, 16), line(3, 9, 15, 9, 15, 16), line(3, 5, 21, 5, 21, 16))],
    "Text Tag": [hot("M3 6H15L22 12L15 18H3Z"), word("T", 9, 12, 6), hotSpeck(17.5, 12)],
    "Text Tag 3D": [place(s.flat, 0, 5), hot(line(6, 7, 18, 7), line(6, 7, 6, 9), line(18, 7, 18, 9), line(12, 7, 11, 18)), ink(line(9, 18, 14, 18))],
  },
  Graphs: {
    "Bar Graph": [ink(line(3, 3, 3, 21, 22, 21)), fill(rect(6, 13, 3, 6)), hotFill(rect(11, 6, 3, 13)), fill(rect(16, 10, 3, 9))],
    "Image Gallery": [ink(rect(2, 3, 9, 8), rect(13, 3, 9, 8), rect(2, 13, 9, 8), rect(13, 13, 9, 8)), hot("M3 20L6 16L10 20", "M14 10L17 6L21 10"), hotSpeck(17.5, 16.5)],
    Legend: [hotFill(rect(3, 3, 4, 4)), tint(rect(3, 10, 4, 4)), ink(rect(3, 10, 4, 4)), ink(rect(3, 17, 4, 4)), ink(line(11, 5, 21, 5), line(11, 12, 19, 12), line(11, 19, 21, 19))],
    "Pie Chart": [ink(circle(11, 13, 8.5)), ink(line(11, 13, 5, 19), line(11, 13, 2.5, 13)), hotFill("M13 11V2.5A8.5 8.5 0 0 1 21.5 11Z")],
    "Quick Graph": [ink(line(3, 3, 3, 21, 22, 21)), hot(line(5, 17, 9, 9, 13, 13, 20, 4)), hotSpeck(9, 9, 13, 13)],
    "Value Tracker": [ink(rect(2, 4, 20, 16)), hot(line(2, 14, 7, 14, 9, 8, 13, 17, 16, 10, 18, 12)), hotDot(18, 12), faint(line(18, 4, 18, 20))],
  },
  Preview: {
    "Cloud Display": [hotFill(circle(7, 8, 3), circle(15, 6, 2), circle(18, 14, 3.5), circle(9, 17, 2)), speck(12, 12, 20, 7, 4, 14, 14, 20)],
    "Create Material": [shade(circle(12, 12, 9)), ink(circle(12, 12, 9)), hotFill(circle(9, 8.5, 2.5)), tint("M12 21A9 9 0 0 0 21 12C17 14 14 17 12 21Z"), hot("M20 10C16 13 13 16 11 20")],
    "Custom Curve Preview": [hot("M3 15C8 1 13 22 21 5"), ink(circle(18.5, 18.5, 3.5)), tint(circle(18.5, 18.5, 3.5)), ink(line(3, 21, 11, 21))],
    "Custom Preview": [small([shade(circle(11, 11, 9)), ink(circle(11, 11, 9)), tint("M11 2A9 9 0 0 1 11 20C17 16 17 6 11 2Z")]), mark.eye],
    "Dot Display": [faint(circle(7, 8, 4.5), circle(17, 15, 5)), hotFill(circle(7, 8, 3), circle(17, 15, 4), circle(18, 5, 2))],
    "Symbol (Advanced)": [ink(circle(10, 10, 7.5)), hotFill(circle(10, 10, 4.5)), mark.gear],
    "Symbol (Simple)": [ink(circle(12, 12, 9)), hot(line(12, 6, 12, 18), line(6, 12, 18, 12))],
    "Symbol Display": [ink(circle(6, 6, 4)), hotFill(circle(6, 6, 1.5)), hot(line(14, 10, 22, 10), line(18, 6, 18, 14)), ink(rect(5, 15, 7, 7)), speck(18, 20)],
  },
  Test: {
    "Test Crash": [hot(poly(12, 1, 14.5, 7, 21, 4, 18, 10.5, 23, 13, 17, 15, 18, 22, 12, 18, 6, 22, 7, 15, 1, 13, 6, 10.5, 3, 4, 9.5, 7)), word("!", 12, 12, 8)],
  },
  Vector: {
    "Point List": [dot(4, 9, 12, 17, 19, 7), word("0", 8, 5, 5, hot), word("1", 15, 13.5, 5, hot), word("2", 21.5, 13, 4, hot)],
    "Point Order": [dot(3, 19, 9, 6, 16, 17, 21, 4), hot(arrow(3, 19, 8, 8.5, 3), arrow(9, 6, 15, 15, 3), arrow(16, 17, 20, 6.5, 3))],
    "Vector Display": [hot(arrow(5, 20, 19, 5, 5)), ink(circle(5, 20, 2)), faint(line(10, 21, 21, 10))],
    "Vector Display Ex": [hot(line(4, 21, 15, 9)), hotFill(poly(20, 3, 18, 12, 11, 6)), tint(rect(15, 16, 6, 5)), ink(rect(15, 16, 6, 5))],
  },
  Viewport: {
    "Viewport Display": [ink(rect(2, 3, 20, 15)), place([hot(s.boxRing, s.boxLines)], 6, 4.5, 0.5), ink(line(7, 22, 17, 22), line(12, 18, 12, 22))],
  },
};
