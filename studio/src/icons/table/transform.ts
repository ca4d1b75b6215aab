/** The pictures of the Transform tab: faint what was, in the accent colour what becomes of it. */

import { arc, arrow, circle, dot, head, hotDot, line, poly, rect, speck, turnArrow } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, fade, heat, hot, hotFill, ink, place, shade, small, tint, turn, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

// What is transformed: a house's front, which shows by its roof how it stands.
const HOUSE = "M-3.5 4V-1L0 -4.5L3.5 -1V4Z";
const house = (x: number, y: number, scale = 1): Drawing => place([shade(HOUSE), ink(HOUSE)], x, y, scale);
const was = (x: number, y: number, scale = 1): Drawing => place(faint(HOUSE), x, y, scale);
const becomes = (x: number, y: number, scale = 1): Drawing => place([tint(HOUSE), hot(HOUSE)], x, y, scale);
const matrix: Drawing = ink("M6 3H3V17H6", "M14 3H17V17H14");
const block = (x: number, y: number, size: number): Drawing => ink(rect(x, y, size, size));

export const transform: Tab = {
  Affine: {
    "Box Mapping": [place(s.ghostBox, -1, -1, 0.55), place(heat(s.bareBox), 9, 7, 0.7), ink(arrow(3, 15, 9, 20, 3))],
    "Camera Obscura": [house(4.5, 8), turn(becomes(19, 15, 1), 180, 19, 15), faint(line(4, 3, 20, 20), line(4, 13, 20, 10)), hotDot(11.5, 11)],
    "Orient Direction": [faint(arrow(3, 21, 12, 21, 3)), was(6, 15, 0.9), turn([becomes(14, 8, 1.2), hot(arrow(9, 15, 20, 15, 3.5))], -35, 14, 11)],
    Project: [place(s.flat, 0, 4), place(ink(HOUSE), 12, 6, 1), hot(line(8, 17, 16, 17, 15, 14, 12, 12.5, 9, 14, 8, 17)), hot(arrow(3, 4, 3, 13, 3), arrow(21, 3, 21, 9, 3))],
    "Project Along": [place(s.flat, 0, 4), place(ink(HOUSE), 8, 6, 1), hot(line(11, 17, 18, 17, 18, 14, 15, 12.5, 12, 14, 11, 17)), hot(arrow(14, 2, 20, 8, 3), arrow(2, 8, 6, 15, 3))],
    "Rectangle Mapping": [faint(rect(2, 3, 8, 7)), heat([shade(rect(11, 10, 11, 11)), ink(rect(11, 10, 11, 11))]), ink(arrow(6, 13, 10, 17, 3), line(4, 8, 8, 5)), hot(line(14, 18, 19, 13))],
    Scale: [faint(rect(3, 14, 7, 7)), hot(rect(3, 3, 18, 18)), ink(arrow(9, 15, 17, 7, 4)), dot(3, 21)],
    "Scale NU": [faint(rect(3, 14, 7, 7)), hot(rect(3, 8, 18, 13)), ink(arrow(10, 17, 20, 17, 3), arrow(6, 14, 6, 9, 2.5)), dot(3, 21)],
    Shear: [faint(rect(3, 6, 11, 14)), tint(poly(3, 20, 14, 20, 22, 6, 11, 6)), hot(poly(3, 20, 14, 20, 22, 6, 11, 6)), ink(arrow(9, 2.5, 18, 2.5, 3))],
    "Shear Angle": [faint(rect(3, 6, 11, 14)), hot(poly(3, 20, 14, 20, 22, 6, 11, 6)), ink(arc(3, 20, 10, -90, -60)), ink(line(3, 20, 3, 6))],
    "Triangle Mapping": [faint(poly(2, 11, 10, 11, 6, 3)), heat([shade(poly(10, 21, 22, 19, 19, 8)), ink(poly(10, 21, 22, 19, 19, 8))]), ink(arrow(8, 12, 13, 17, 3))],
  },
  Array: {
    "Box Array": [hot(s.boxRing, s.boxLines), faint(line(8, 5, 16, 9, 16, 18), line(16, 5, 8, 9, 8, 18), line(4, 11.5, 12, 15.5, 20, 11.5)), hotFill(poly(8, 13.5, 12, 15.5, 12, 20, 8, 18))],
    "Curve Array": [faint("M2 19C6 8 14 18 22 5"), turn(house(4, 15, 0.8), -20, 4, 15), turn(becomes(11.5, 11, 0.8), 10, 11.5, 11), turn(becomes(19, 7, 0.8), -40, 19, 7)],
    Kaleidoscope: [...[0, 120, 240].map((a) => turn([ink(poly(12, 11, 7, 3, 12, 3))], a)), ...[0, 120, 240].map((a) => turn([tint(poly(12, 11, 12, 3, 17, 3)), hot(poly(12, 11, 12, 3, 17, 3))], a))],
    "Linear Array": [house(4.5, 12, 0.85), becomes(12, 12, 0.85), becomes(19.5, 12, 0.85), ink(arrow(3, 20, 21, 20, 3))],
    "Polar Array": [dot(12, 12), house(12, 4, 0.7), ...[72, 144, 216, 288].map((a) => turn(becomes(12, 4, 0.7), a))],
    "Rectangular Array": [block(3, 15, 6), heat([block(3, 3, 6), block(15, 3, 6), block(15, 15, 6)]), ink(arrow(10, 18, 14, 18, 2.5), arrow(6, 14, 6, 10, 2.5))],
  },
  Euclidean: {
    Mirror: [ink(poly(3, 19, 9, 19, 9, 5)), dash(line(12, 2, 12, 22)), tint(poly(21, 19, 15, 19, 15, 5)), hot(poly(21, 19, 15, 19, 15, 5))],
    Move: [faint(rect(3, 13, 8, 8)), tint(rect(13, 3, 8, 8)), hot(rect(13, 3, 8, 8)), ink(arrow(7, 17, 16, 8, 3.5))],
    "Move Away From": [hotFill(circle(5, 19, 2.5)), faint(rect(7, 10, 6, 6)), tint(rect(15, 2, 7, 7)), hot(rect(15, 2, 7, 7)), ink(arrow(8, 16, 17, 7, 3.5))],
    "Move To Plane": [place(s.flat, 0, 6), faint(rect(8, 1, 7, 5)), tint(rect(8, 14, 7, 5)), hot(rect(8, 14, 7, 5)), ink(arrow(11.5, 6, 11.5, 13, 3))],
    Orient: [place(fade(s.flat), -1, 10, 0.5), was(6, 11, 0.75), turn([place(s.flat, 11, 7, 0.5), becomes(17, 7.5, 1)], 25, 17, 10), ink("M5 6C6 3 9 2 11 3.5", head(11.5, 4, 1, 0.8, 3))],
    Rotate: [faint(rect(8, 13, 13, 6)), turn([tint(rect(8, 13, 13, 6)), hot(rect(8, 13, 13, 6))], -50, 5, 16), dot(5, 18), ink(turnArrow(5, 18, 17, -10, -35, 3))],
    "Rotate 3D": [ink(line(12, 1, 12, 23)), tint(poly(12, 7, 20, 4, 20, 14, 12, 17)), hot(poly(12, 7, 20, 4, 20, 14, 12, 17)), faint(poly(12, 7, 4, 5, 4, 15, 12, 17)), ink("M6 19C8 21.5 16 21.5 18 19", head(18.5, 18.5, 1, -1, 3))],
    "Rotate Axis": [ink(line(7, 22, 17, 2)), dot(7, 22, 17, 2), faint(circle(5, 9, 3)), tint(circle(19, 15, 3.5)), hot(circle(19, 15, 3.5)), hot("M3 14C4 19 9 21 14 19.5", head(14.5, 19.3, 1, -0.3, 3.5))],
    "Rotate Direction": [faint(arrow(4, 20, 21, 20, 3.5)), hot(arrow(4, 20, 9, 4, 3.5)), ink(turnArrow(4, 20, 11, -8, -60, 3)), dot(4, 20)],
    "Sanity XForm": [faint(rect(4, 4, 16, 16)), hot("M6 3C11 6 15 1 20 6S17 12 21 18S12 18 8 21S7 14 3 12S4 6 6 3Z"), dot(9.5, 10, 15, 10), ink("M8 15C10 13 13 17 16 14")],
  },
  Morph: {
    "Bend Deform": [faint(rect(3, 3, 5, 18)), tint("M3 21C3 10 10 4 21 4V9C13 9 8 13 8 21Z"), hot("M3 21C3 10 10 4 21 4V9C13 9 8 13 8 21Z")],
    "Blend Box": [hot("M4 4L20 6M4 4L6 19M20 6L17 19M6 19L17 19"), ink("M3 4C9 1 15 8 21 6", "M5 19C9 16 14 22 18 19"), faint("M10 4L10 18M15 5.5L14 20")],
    "Box Morph": [place(s.ghostBox, -1, -1, 0.55), ink(arrow(11, 5, 15, 6, 2.5)), tint("M9 12L18 9L22 12L13 15Z"), hot("M9 12L18 9L22 12L13 15Z", "M9 12C11 15 8 17 10 19L15 23L20 20C22 17 20 15 22 12", "M13 15C15 18 13 20 15 23")],
    Flow: [faint(line(2, 20, 22, 20)), faint(rect(4, 15, 4, 5), rect(16, 15, 4, 5)), ink("M2 11C8 -2 14 18 22 4"), turn(hot(rect(3.5, 3.5, 4, 4)), -60, 4, 7), turn(hot(rect(11, 3.5, 4, 4)), 45, 13, 5)],
    Maelstrom: [ink("M12 12C14 10 16 13 13 15S6 13 8 8S18 4 20 11S15 22 9 21"), hotDot(12, 12), hot("M4 4C2 8 2 12 3 15", head(3.5, 16, 0.5, 2, 3.5))],
    "Map to Surface": [place(s.sheet, 0, 4), ink("M8 2C12 5 15 0 19 2"), hot("M7 15C10 11 13 18 17 13"), hot(arrow(13, 5, 13, 11, 3))],
    "Mirror Curve": [ink("M12 1C7 8 17 16 12 23"), faint(rect(2, 9, 5, 6)), tint("M17 8C19 8 22 9 22 10L21 16C19 16 18 16 17 15Z"), hot("M17 8C19 8 22 9 22 10L21 16C19 16 18 16 17 15Z")],
    "Mirror Curve f8452dc8": [ink("M12 1C7 8 17 16 12 23"), dot(4, 12), hotDot(20, 12), dash(line(4, 12, 20, 12))],
    "Mirror Surface": [ink("M9 4C12 7 8 14 11 21L16 18C13 12 17 7 14 2Z"), shade("M9 4C12 7 8 14 11 21L16 18C13 12 17 7 14 2Z"), dot(3, 12), hotDot(21, 12), dash(line(4, 12, 20, 12))],
    "Mirror Surface 6ce1aa3c": [ink("M9 4C12 7 8 14 11 21L16 18C13 12 17 7 14 2Z"), shade("M9 4C12 7 8 14 11 21L16 18C13 12 17 7 14 2Z"), faint(rect(1, 9, 5, 5)), tint(rect(18, 9, 5, 5)), hot(rect(18, 9, 5, 5))],
    "Point Deform": [faint(line(2, 16, 22, 16), line(4, 22, 9, 11), line(12, 22, 14, 11), line(20, 22, 19, 11)), hot("M2 16C9 16 9 4 12 4S15 16 22 16"), ink(arrow(12, 13, 12, 6, 3)), hotDot(12, 4)],
    "Spatial Deform": [hot("M3 5C9 9 15 1 21 5", "M3 12C9 16 15 8 21 12", "M3 19C9 23 15 15 21 19"), ink("M5 3C8 9 2 15 5 21", "M12 3C15 9 9 15 12 21", "M19 3C22 9 16 15 19 21")],
    "Spatial Deform (custom)": [small([hot("M3 5C9 9 15 1 21 5", "M3 12C9 16 15 8 21 12", "M3 19C9 23 15 15 21 19"), ink("M5 3C8 9 2 15 5 21", "M12 3C15 9 9 15 12 21", "M19 3C22 9 16 15 19 21")]), mark.sign("f")],
    Splop: [place(s.sheet, 0, 4), tint("M8 14C9 10 14 9 16 12S12 18 10 17S7 16 8 14Z"), hot("M8 14C9 10 14 9 16 12S12 18 10 17S7 16 8 14Z"), ink(circle(12, 3.5, 2.5)), ink(arrow(12, 6, 12, 10.5, 2.5))],
    Sporph: [place(s.flat, -1, -3, 0.55), place(s.sheet, 8, 9, 0.68), hot(circle(5.5, 3.7, 1.5), circle(16, 17, 2.5)), ink("M12 3C17 3 18 6 18 9", head(18, 10, 0, 1, 3))],
    Stretch: [faint(rect(8, 8, 8, 8)), tint(rect(9, 3, 6, 18)), hot(rect(9, 3, 6, 18)), ink(arrow(4, 14, 4, 21, 3), arrow(4, 10, 4, 3, 3))],
    "Surface Box": [shade("M3 17C8 13 15 22 21 17L18 21H6Z"), ink("M3 17C8 13 15 22 21 17"), hot(line(3, 17, 4, 6), line(21, 17, 20, 6), "M4 6C9 2 15 10 20 6"), ink(arrow(12, 16, 12, 9, 3))],
    "Surface Morph": [place(s.sheet, 0, 6, 0.95), hot(poly(7, 13, 12, 15, 11, 8, 7, 6), poly(12, 15, 17, 13, 17, 6, 11, 8)), hot(line(7, 6, 13, 4, 17, 6))],
    Taper: [faint(rect(5, 3, 14, 18)), tint(poly(9, 3, 15, 3, 19, 21, 5, 21)), hot(poly(9, 3, 15, 3, 19, 21, 5, 21)), ink(arrow(2, 6, 7, 6, 2.5), arrow(22, 6, 17, 6, 2.5))],
    Twist: [hot("M7 3C7 9 17 15 17 21", "M17 3C17 9 7 15 7 21"), tint("M7 3C7 8 12 10 12 12C12 10 17 8 17 3Z"), ink(line(7, 3, 17, 3), line(7, 21, 17, 21)), ink(turnArrow(12, 12, 9, -30, 30, 3))],
    "Twisted Box": [hot("M8 3L19 5L16 9L4 7Z"), ink("M4 7L7 17L15 21L21 15L19 5", "M16 9L15 21"), hotDot(8, 3, 19, 5, 16, 9, 4, 7, 7, 17, 15, 21, 21, 15)],
  },
  Util: {
    Compound: [matrix, hot(line(10, 6, 10, 14), line(6, 10, 14, 10)), mark.equals],
    Group: [dash(rect(2, 2, 20, 20)), ink(circle(8, 9, 3.5)), tint(rect(11, 11, 8, 8)), hot(rect(11, 11, 8, 8))],
    "Inverse Transform": [matrix, word("-1", 19.5, 5, 6, hot), ink(line(6.5, 13, 13.5, 7)), speck(7, 7, 13, 13)],
    "Merge Group": [dash(rect(2, 2, 12, 12)), dash(rect(10, 10, 12, 12)), hotFill(rect(11, 11, 3, 3)), ink(circle(7, 7, 2)), hot(circle(17, 17, 2))],
    Split: [place([matrix, ink(line(6.5, 13, 13.5, 7))], 0, 0, 0.8), hot(arrow(15, 9, 22, 9, 3), arrow(9, 15.5, 9, 22.5, 3), line(15, 15, 19, 19)), hotDot(19.5, 19.5)],
    "Split Group": [dash(rect(2, 2, 20, 20)), hot(line(12, 2, 12, 22)), ink(circle(7, 12, 3)), tint(rect(14.5, 9, 5, 6)), hot(rect(14.5, 9, 5, 6))],
    Transform: [faint(rect(2, 12, 9, 9)), tint(poly(10, 5, 20, 2, 22, 12, 13, 15)), hot(poly(10, 5, 20, 2, 22, 12, 13, 15)), ink("M8 9C4 8 4 5 8 3", head(9, 2.5, 1, -0.5, 3))],
    "Transform Matrix": [ink("M7 3H3V21H7", "M17 3H21V21H17"), hotDot(8, 7, 12, 12, 16, 17), speck(12, 7, 16, 7, 8, 12, 16, 12, 8, 17, 12, 17)],
    Ungroup: [faint(rect(5, 5, 14, 14)), ink(circle(5, 6, 3.5)), tint(rect(14, 14, 8, 8)), hot(rect(14, 14, 8, 8)), hot(arrow(11, 11, 8, 8.5, 2))],
  },
};
