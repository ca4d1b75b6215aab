/** The pictures of the Vector tab. */

import { arc, arrow, circle, dot, ellipse, head, hotDot, hotSpeck, line, ngon, poly, rays, rect, span, speck, turnArrow } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, hot, hotFill, ink, place, shade, small, tint, turn, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

// A plane with its axes; the axes can be apart from it.
const smallPlane = small([s.flat, ink(line(12, 12, 17, 12), line(12, 12, 14, 9))]);
const axisPair = hot(line(12, 12, 17.5, 12), line(12, 12, 14.5, 8));
const x = (cx: number, cy: number, r = 3): string => line(cx - r, cy - r, cx + r, cy + r) + line(cx + r, cy - r, cx - r, cy + r);
const field = ink("M2 6C7 3 11 9 16 5", "M2 11C7 8 11 14 16 10", "M2 16C6 13 9 18 12 16");
const vector = ink(arrow(4, 20, 19, 5, 5));
const hexagons = (tone: (...paths: string[]) => Drawing): Drawing => tone(ngon(8.5, 6.5, 4, 6), ngon(15.5, 6.5, 4, 6), ngon(12, 12.5, 4, 6), ngon(5, 12.5, 4, 6), ngon(19, 12.5, 4, 6), ngon(8.5, 18.5, 4, 6), ngon(15.5, 18.5, 4, 6));

export const vectors: Tab = {
  Colour: {
    "Blend Colours": [ink(circle(6, 12, 4)), tint(circle(12, 12, 4)), hotFill(circle(18, 12, 4)), ink(circle(18, 12, 4)), hot(arrow(4, 20, 20, 20, 3))],
  },
  Field: {
    "Break Field": [field, hot(line(18, 2, 12, 22)), hot(arrow(18, 14, 22, 12, 3), arrow(18, 20, 22, 22, 3))],
    "Direction Display": [ink(rect(2, 2, 20, 20)), hot(arrow(5, 9, 9, 5, 2.5), arrow(14, 7, 19.5, 7, 2.5), arrow(6, 15, 7, 20, 2.5), arrow(14, 19, 19, 15, 2.5))],
    "Evaluate Field": [field, hotDot(16, 17), hot(arrow(16, 17, 22, 12, 3))],
    "Field Line": [faint("M2 6C8 2 12 10 22 5", "M2 20C8 16 12 24 22 19"), hot("M2 13C8 9 12 17 21 12", head(22, 11.5, 2, -1)), dot(2.5, 13)],
    "Line Charge": [ink(line(12, 3, 12, 21)), hot(arrow(14, 7, 21, 7, 3), arrow(14, 12, 21, 12, 3), arrow(14, 17, 21, 17, 3), arrow(10, 7, 3, 7, 3), arrow(10, 12, 3, 12, 3), arrow(10, 17, 3, 17, 3))],
    "Merge Fields": [ink("M2 5C7 2 9 12 15 12", "M2 12H15", "M2 19C7 22 9 12 15 12"), hot("M14 12C17 10 18 14 21 12", head(22, 11.5, 2, -1, 3.5))],
    "Perpendicular Display": [ink(rect(2, 2, 20, 20)), tint("M2 2H22V9C15 15 9 6 2 14Z"), hot("M2 14C9 6 15 15 22 9"), speck(8, 17.5, 15, 17.5), hot(line(14, 4.5, 14, 7.5), line(12.5, 6, 15.5, 6))],
    "Point Charge": [hotDot(12, 12), ...[0, 60, 120, 180, 240, 300].map((a) => turn(ink(arrow(16, 12, 22, 12, 3)), a - 30))],
    "Scalar Display": [ink(rect(2, 2, 20, 20)), tint(circle(12, 12, 7.5)), hotFill(circle(12, 12, 3.5)), hot(circle(12, 12, 7.5))],
    "Spin Force": [hotDot(12, 12), ink(turnArrow(12, 12, 8.5, 195, 335, 4), turnArrow(12, 12, 8.5, 15, 155, 4))],
    "Tensor Display": [ink(rect(2, 2, 20, 20)), hot(line(5, 8, 9, 5), line(13, 8, 19, 6), line(5, 18, 7, 13), line(12, 19, 19, 14)), hotSpeck(5, 8, 13, 8, 5, 18, 12, 19)],
    "Vector Force": [ink(line(5, 4, 5, 20)), hot(arrow(5, 6, 20, 6, 4), arrow(5, 12, 15, 12, 4), arrow(5, 18, 20, 18, 4))],
  },
  Grid: {
    "Freeform Cloud": [s.blob, hotSpeck(8, 9, 12, 7, 16, 8, 8, 14, 13, 12, 17, 13, 11, 17, 15, 17)],
    Hexagonal: [hexagons(ink), tint(ngon(12, 12.5, 4, 6))],
    "Populate 2D": [ink(rect(3, 3, 18, 18)), hotSpeck(7, 7, 12, 6, 17, 8, 8, 12, 14, 12, 18, 14, 6, 17, 12, 18, 17, 18)],
    "Populate 3D": [s.ghostBox, ink(s.boxRing), hotSpeck(8, 9, 12, 7, 16, 9, 7, 14, 12, 13, 17, 13, 9, 16, 14, 17)],
    "Populate Geometry": [ink(circle(12, 12, 9.5)), hotSpeck(12, 4, 6, 7, 18, 7, 9, 11, 15, 11, 5, 14, 19, 14, 11, 16, 15, 18.5)],
    Radial: [ink(circle(12, 12, 3.5), circle(12, 12, 9.5)), faint(circle(12, 12, 6.5)), hot(rays(12, 12, [0, 60, 120, 180, 240, 300], 3.5, 9.5))],
    Rectangular: [ink(rect(2, 4, 20, 16)), hot(line(12, 4, 12, 20), line(2, 9.5, 22, 9.5), line(2, 14.5, 22, 14.5))],
    "Spherical Cloud": [ink(circle(12, 12, 9.5)), dash(ellipse(12, 12, 9.5, 3.5)), hotSpeck(8, 7, 13, 5, 16, 9, 10, 11, 6, 16, 12, 17, 17, 16)],
    Square: [ink(rect(3, 3, 18, 18)), hot(line(9, 3, 9, 21), line(15, 3, 15, 21), line(3, 9, 21, 9), line(3, 15, 21, 15))],
    Triangular: [ink(poly(12, 3, 22, 21, 2, 21)), hot(poly(7, 12, 17, 12, 12, 21)), tint(poly(7, 12, 17, 12, 12, 21))],
  },
  Plane: {
    "Adjust Plane": [s.flat, faint(arrow(11, 12, 11, 2, 3)), hot(arrow(11, 12, 17, 3, 3.5))],
    "Align Plane": [s.flat, axisPair, hot(arrow(4, 3, 14, 3, 3))],
    "Align Planes": [small(s.flat), place(s.flat, 6, 8, 0.75), hot(arrow(7, 9, 11, 9, 2.5), arrow(14, 17, 18.5, 17, 2.5))],
    "Construct Plane": [s.flat, axisPair, hotDot(12, 12)],
    "Deconstruct Plane": [smallPlane, mark.axis],
    "Flip Plane": [s.flat, hot(span(12, 2, 12, 22, 3.5))],
    "Line + Line": [s.flat, hot(line(7, 14.5, 18, 9), line(9, 9, 15, 15))],
    "Line + Pt": [s.flat, hot(line(6, 15, 15, 15)), hotDot(15, 9.5)],
    "Plane 3Pt": [s.flat, hotDot(8, 7, 2, 17, 16, 17)],
    "Plane Closest Point": [place(s.flat, 0, 4), dot(12, 3), hot(line(12, 5, 12, 16)), hotDot(12, 16)],
    "Plane Coordinates": [s.flat, dash(line(7, 12, 14, 12, 16, 8.5)), hotDot(16, 8.5), word("x", 6, 21, 4, hot), word("y", 19.5, 15, 4, hot)],
    "Plane Fit": [s.flat, hotSpeck(8, 5, 11, 10, 15, 6, 9, 15, 13, 13.5, 17, 11, 6, 13, 14, 19.5)],
    "Plane Normal": [place(s.flat, 0, 3), hot(arrow(12, 15, 12, 2, 4)), hotDot(12, 15)],
    "Plane Offset": [place([s.flat], 0, 4), place(hot(s.flatOutline), 0, -4), faint(arrow(12, 15, 12, 9, 3))],
    "Plane Origin": [place([dash(s.flatOutline)], -0.5, 3.5, 0.8), place(s.flat, 5, 0, 0.8), hotDot(14.6, 9.6)],
    "Rotate Plane": [s.flat, hot(turnArrow(12, 12, 5, 140, 400, 3.5))],
    "XY Plane": [place(s.flat, 0, -1, 0.9), word("X", 8, 20, 5.5, hot), word("Y", 14.5, 20, 5.5, hot)],
    "XZ Plane": [shade(rect(5, 2, 14, 12)), ink(rect(5, 2, 14, 12)), word("X", 8, 20, 5.5, hot), word("Z", 14.5, 20, 5.5, hot)],
    "YZ Plane": [shade(poly(7, 7, 15, 2, 15, 12, 7, 16)), ink(poly(7, 7, 15, 2, 15, 12, 7, 16)), word("Y", 8, 20.5, 5.5, hot), word("Z", 14.5, 20.5, 5.5, hot)],
  },
  Point: {
    Barycentric: [shade(poly(3, 20, 21, 20, 10, 4)), ink(poly(3, 20, 21, 20, 10, 4)), faint(line(3, 20, 11, 14.5, 21, 20), line(11, 14.5, 10, 4)), hotDot(11, 14.5)],
    "Closest Point": [dot(4, 20), speck(8, 5, 19, 5, 20, 17), hotDot(12, 12), hot(line(4, 20, 12, 12))],
    "Closest Points": [dot(5, 19), speck(20, 4, 21, 17), hotDot(7, 7, 16, 14), hot(line(5, 19, 7, 7), line(5, 19, 16, 14)), faint(arc(5, 19, 13, -100, 0))],
    "Construct Point": [ink(line(4, 3, 4, 20, 21, 20)), faint(line(15, 20, 15, 8, 4, 8)), hotDot(15, 8), hot(line(15, 4, 15, 12), line(11, 8, 19, 8))],
    "Coordinate Mask": [word("X", 4.5, 12, 7, hot), word("Y", 12, 12, 7), word("Z", 19.5, 12, 7, hot), ink(line(9, 18, 15, 6))],
    "Cull Duplicates": [dot(4, 5, 20, 6, 5, 19), hotDot(14, 14), faint(circle(16, 16, 2), circle(13, 17, 2)), hot(circle(14.5, 15.5, 6))],
    Deconstruct: [ink(x(8, 8, 4)), dot(8, 8), word("x", 5, 20, 5, hot), word("y", 12, 20, 5, hot), word("z", 19, 20, 5, hot), hot(arrow(14, 8, 21, 8, 3))],
    "Deconstruct Point": [ink(line(4, 3, 4, 20, 21, 20)), dot(15, 8), hot(arrow(15, 10, 15, 19, 3), arrow(13, 8, 5, 8, 3))],
    Distance: [dot(4, 20, 20, 4), hot(line(6, 18, 18, 6), line(1, 17, 7, 23), line(17, 1, 23, 7))],
    "Grid Hexagonal [OBSOLETE]": [speck(7, 5, 13, 5, 4, 11, 10, 11, 16, 11, 7, 17, 13, 17, 19, 17)],
    "Grid Rectangular [OBSOLETE]": [speck(5, 5, 12, 5, 19, 5, 5, 12, 12, 12, 19, 12, 5, 19, 12, 19, 19, 19)],
    "Numbers to Points": [word("1", 3, 5, 5), word("2", 3, 12, 5), word("3", 3, 19, 5), hot(arrow(7, 12, 13, 12, 3)), ink(x(18.5, 12, 3.5)), hotDot(18.5, 12)],
    "Point Cylindrical": [faint(ellipse(12, 19, 9, 3), ellipse(12, 6, 9, 3)), ink(line(12, 19, 12, 6, 18, 8)), hotDot(18.5, 8)],
    "Point Groups": [hot(circle(7.5, 8, 5.5)), hot(circle(17, 17, 5)), dot(6, 7, 9, 9, 16, 16, 19, 18), speck(18, 5, 5, 19)],
    "Point Oriented": [place(s.flat, 0, 3), hot(line(9, 15, 15, 15), line(9, 15, 11.5, 11)), dash(line(9, 15, 16, 4)), hotDot(16.5, 3.5)],
    "Point Polar": [ink(line(3, 20, 21, 20)), ink(line(3, 20, 17, 7)), hot(arc(3, 20, 10, -43, 0)), hotDot(17, 7)],
    "Points to Numbers": [ink(x(5.5, 12, 3.5)), hotDot(5.5, 12), hot(arrow(10.5, 12, 16.5, 12, 3)), word("1", 21, 5, 5), word("2", 21, 12, 5), word("3", 21, 19, 5)],
    "Project Point": [place(s.sheet, 0, 6, 0.9), dot(11, 3), hot(arrow(11, 5, 11, 15, 3.5)), hotDot(11, 17)],
    "Pull Point": [ink("M4 21C12 20 18 14 19 3"), dot(6, 7), hot(arrow(7, 8, 14, 14.5, 3.5)), hotDot(15, 15)],
    "Sort Along Curve": [ink("M2 17C8 8 16 8 22 17"), hotDot(4.5, 8.5, 12, 5, 19.5, 8.5), word("1", 6, 20.5, 5), word("2", 12, 18, 5), word("3", 18, 20.5, 5)],
    "Sort Points": [dot(4, 18), dot(9, 8, 15, 15, 20, 5), hot(arrow(4, 18, 8, 10, 3), arrow(9, 8, 14, 14, 3), arrow(15, 15, 19, 7, 3))],
    "To Polar": [faint(line(3, 20, 21, 20)), hot(arrow(3, 20, 17, 7, 3.5)), hot(arc(3, 20, 10, -43, 0)), dot(17, 7, 3, 20)],
  },
  Vector: {
    Addition: [ink(arrow(3, 20, 7, 6, 3.5), arrow(7, 6, 20, 3, 3.5)), hot(arrow(3, 20, 20, 6, 4))],
    Amplitude: [ink(arrow(4, 20, 13, 11, 4)), hot(arrow(14, 10, 20, 4, 4)), word("A", 18, 18, 6, hot)],
    Angle: [ink(arrow(4, 20, 21, 20, 3.5), arrow(4, 20, 15, 5, 3.5)), hot(arc(4, 20, 9, -54, 0))],
    "Cross Product": [ink(arrow(10, 15, 21, 18, 3.5), arrow(10, 15, 3, 21, 3.5)), hot(arrow(10, 15, 10, 2, 4)), faint(poly(10, 15, 17, 17, 13, 21, 6, 18.5))],
    "Deconstruct Vector": [ink(arrow(4, 20, 18, 5, 4)), hot(line(4, 20, 18, 20, 18, 7)), hotDot(18, 20)],
    Divide: [vector, mark.leans],
    "Dot Product": [ink(arrow(3, 20, 21, 20, 3.5), arrow(3, 20, 15, 5, 3.5)), dash(line(15, 6, 15, 20)), hotDot(15, 20), hot(line(3, 20, 14, 20))],
    "Mass Addition": [ink(arrow(3, 20, 4, 11, 3), arrow(4, 11, 10, 6, 3), arrow(10, 6, 19, 3, 3)), hot(arrow(3, 20, 20, 7, 4))],
    Multiply: [small([ink(arrow(4, 21, 20, 5, 6))]), mark.times],
    Reverse: [ink(arrow(4, 15, 15, 4, 4)), hot(arrow(20, 9, 9, 20, 4))],
    Rotate: [faint(arrow(3, 20, 21, 18, 3.5)), ink(arrow(3, 20, 9, 3, 4)), hot(turnArrow(3, 20, 13, -12, -56, 3.5))],
    "Solar Incidence": [hotFill(circle(6.5, 6.5, 3.5)), hot(rays(6.5, 6.5, [0, 90, 180, 270, 135, 225, 315], 5, 6.5)), ink(arrow(11, 11, 19, 19, 4)), ink(line(8, 22, 22, 22))],
    "Unit Vector": [ink(arrow(4, 20, 18, 6, 4)), word("1", 8, 9, 7, hot), hot(arc(4, 20, 19, -65, -25))],
    "Unit X": [ink(arrow(3, 12, 20, 12, 5)), word("X", 11, 19, 6.5, hot), dot(3, 12)],
    "Unit Y": [ink(arrow(3, 20, 15, 6, 5)), word("Y", 18, 16, 6.5, hot), dot(3, 20)],
    "Unit Z": [ink(arrow(8, 21, 8, 4, 5)), word("Z", 17, 12, 6.5, hot), dot(8, 21)],
    "Vector 2Pt": [ink(arrow(5, 19, 17, 7, 4)), hotDot(4, 20, 20, 4)],
    "Vector Length": [ink(arrow(6, 17, 18, 5, 4)), hot(line(8, 22, 21, 9), line(6, 20, 10, 24), line(19, 7, 23, 11))],
    "Vector XYZ": [hot(arrow(9, 14, 9, 3, 3), arrow(9, 14, 21, 14, 3), arrow(9, 14, 3, 20, 3)), ink(arrow(9, 14, 18, 6, 3.5))],
  },
};