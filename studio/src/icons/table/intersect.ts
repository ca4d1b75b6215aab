/** The pictures of the Intersect tab: both partners, and what they share in the accent colour. */

import { arrow, circle, dot, hotDot, line, poly, rect } from "../lines";
import { dash, faint, hot, hotFill, ink, place, shade, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

const tilted = poly(1, 15, 8, 8, 23, 8, 16, 15);
// A plane on edge, seen from the side.
const upright = poly(10, 2, 17, 6, 17, 22, 10, 17);
const curve = "M2 19C7 18 7 5 12 5S16 15 22 13";
const ghostMesh: Drawing = [ink(s.netRing), faint(s.netLines)];

// A block and a ball that share a part.
const BALL = "M9 10A6.5 6.5 0 1 1 14 16";
const SOLIDS = {
  block: poly(8, 10, 14, 13, 14, 19, 8, 22, 2, 19, 2, 13),
  ball: circle(15.5, 8.5, 6.5),
  shared: "M9.2 10.6L14 13V14.8C11.500 14.200 9.700 12.800 9.2 10.6Z",
  union: `${BALL}V19L8 22L2 19V13L8 10Z`,
  difference: ["M9.2 10.6C9.7 12.8 11.5 14.2 14 14.8V19L8 22L2 19V13L8 10Z", line(2, 13, 8, 16, 11, 14.5), line(8, 16, 8, 22)],
} as const;

export const intersect: Tab = {
  Mathematical: {
    "Brep | Line": [s.bareBox, hotDot(7, 14.5, 17, 9), ink(line(1, 18, 7, 14.5), line(17, 9, 23, 5.5)), faint(line(7, 14.5, 17, 9))],
    "Brep | Plane": [s.bareBox, tint(poly(4, 12, 12, 8, 20, 12, 12, 16)), hot(poly(4, 12, 12, 8, 20, 12, 12, 16))],
    Contour: [s.ghostBox, ink(s.boxRing), hot(line(4, 10, 12, 14, 20, 10), line(4, 13, 12, 17, 20, 13), line(4, 16, 12, 20, 20, 16))],
    "Contour (ex)": [s.ghostBox, ink(s.boxRing), hot(line(4, 8.5, 12, 12.5, 20, 8.5), line(4, 10.5, 12, 14.5, 20, 10.5), line(4, 15, 12, 19, 20, 15))],
    "Curve | Line": [ink(curve), ink(line(1, 10, 23, 10)), hotDot(7.5, 10, 16, 10)],
    "Curve | Line [OBSOLETE]": [ink(curve), ink(line(1, 8, 23, 12)), hotDot(7.5, 10)],
    "Curve | Plane": [place([shade(upright), ink(upright)], -2, 0), ink("M1 14C5 10 8 9 11 11"), faint("M11 11L15 12.5"), ink("M15 12.5C18 13 20 9 23 8"), hotDot(11.5, 11.5)],
    IsoVist: [tint(poly(12, 2, 18, 5, 14, 10, 22, 12, 18, 20, 11, 22, 6, 18, 2, 12, 8, 10, 5, 5)), hot(poly(12, 2, 18, 5, 14, 10, 22, 12, 18, 20, 11, 22, 6, 18, 2, 12, 8, 10, 5, 5)), dot(12, 14)],
    "IsoVist Ray": [dot(4, 19), ink("M14 3C15 8 18 12 22 14"), hot(arrow(4, 19, 15.5, 8, 3.5)), faint(line(16, 7, 21, 2)), hotDot(15.5, 7.7)],
    "Line | Line": [ink(line(3, 20, 21, 4), line(3, 6, 21, 18)), hotDot(12, 12)],
    "Line | Plane": [s.flat, ink(line(12, 1, 12, 12)), faint(line(12, 12, 12, 17)), ink(line(12, 17, 12, 23)), hotDot(12, 12)],
    "Mesh | Plane": [ghostMesh, hot(line(3, 14, 9, 11, 14, 14, 21, 10)), tint(poly(3, 9, 3.5, 14, 9, 11, 14, 14, 21, 10, 20, 6, 10, 3))],
    "Mesh | Ray": [place(ghostMesh, 5, 3, 0.8), hot(arrow(1, 5, 12, 11, 4)), dot(2, 5.5), hotDot(14, 12)],
    "Plane Region": [faint(line(1, 8, 23, 4), line(3, 2, 8, 22), line(2, 16, 22, 22), line(18, 1, 20, 23)), tint(poly(4.5, 7.3, 18.4, 4.8, 19.7, 21, 7, 17.5)), hot(poly(4.5, 7.3, 18.4, 4.8, 19.7, 21, 7, 17.5))],
    "Plane | Plane": [shade(tilted), ink(tilted), ink(upright), shade(upright), hot(line(10, 15, 17, 8))],
    "Plane | Plane | Plane": [ink(tilted), ink(upright), shade(tilted, upright), hot(line(10, 15, 17, 8)), ink(line(1, 4, 23, 20)), hotDot(13, 12)],
    "Surface | Line": [place(s.sheet, 0, 2), ink(line(12, 1, 12, 13)), faint(line(12, 13, 12, 20)), hotDot(12, 13.5)],
  },
  Physical: {
    "Brep | Brep": [place(s.bareBox, -1.5, 5.5, 0.75), place(s.bareBox, 7, -1, 0.75), hot(line(10, 13, 13.5, 11, 13.5, 15)), hotDot(10, 10, 13.5, 15)],
    "Brep | Curve": [s.bareBox, ink("M1 20C3 17 5 16 7 14"), hot("M7 14C10 11 13 14 16 10"), ink("M16 10C19 6 20 4 23 3"), hotDot(7, 14, 16, 10)],
    Clash: [ink(circle(7, 14, 5), circle(17, 14, 5)), hot(line(12, 2, 12, 7), line(6, 4, 8, 7), line(18, 4, 16, 7)), hotDot(12, 14)],
    "Collision Many|Many": [ink(rect(2, 2, 7, 7), rect(6, 6, 7, 7), rect(11, 11, 7, 7), rect(15, 15, 7, 7)), hotFill(rect(6, 6, 3, 3), rect(11, 11, 2, 2), rect(15, 15, 3, 3))],
    "Collision One|Many": [ink(rect(7, 7, 10, 10)), ink(rect(2, 2, 7, 7), rect(15, 3, 6, 6), rect(14, 15, 7, 7)), hotFill(rect(7, 7, 2, 2), rect(15, 7, 2, 2), rect(14, 15, 3, 2))],
    "Curve | Curve": [ink("M2 18C8 18 8 6 22 6", "M3 4C10 5 12 20 21 19"), hotDot(10.5, 11.5)],
    "Curve | Self": [ink("M3 20C6 8 22 -2 21 9S4 12 8 17S17 19 21 18"), hotDot(9.3, 11.5)],
    "Mesh | Curve": [ghostMesh, ink("M1 17C4 17 5 15 7 14"), hot("M7 14C10 12 12 8 16 9"), ink("M16 9C19 10 20 4 23 3"), hotDot(7, 14, 16, 9)],
    "Mesh | Mesh": [ink(poly(2, 10, 8, 2, 16, 6, 14, 15, 5, 17), poly(10, 11, 18, 7, 22, 14, 18, 22, 9, 20)), faint(line(2, 10, 14, 15), line(8, 2, 14, 15), line(10, 11, 18, 22), line(22, 14, 9, 20)), hot(line(15, 8.5, 10, 11, 9.6, 16)), hotDot(15, 8.5, 9.6, 16)],
    "Multiple Curves": [ink("M2 16C8 15 14 8 22 8", "M4 3C8 8 10 16 10 22", "M22 20C18 12 14 8 13 2"), hotDot(8.7, 13, 15, 9.2)],
    "Surface Split": [place(s.sheet, 0, 0), hot("M11 3C9 9 13 14 10 20"), hot(arrow(7, 3, 2, 3, 2.5), arrow(16, 21.5, 22, 21.5, 2.5))],
    "Surface | Curve": [place(s.sheet, 0, 2), ink("M3 3C5 9 9 9 10 13"), faint("M10 13C11 16 12 19 14 20"), ink("M18 2C17 6 16 8 16 11"), hotDot(10, 13, 16, 11.5)],
  },
  Region: {
    "Split with Brep": [s.ghostBox, ink(line(1, 19, 7, 15), line(17, 9, 23, 5)), hot(line(7, 15, 17, 9)), hotDot(7, 15, 17, 9)],
    "Split with Breps": [place(s.ghostBox, -1, 6, 0.6), place(s.ghostBox, 10, -1, 0.6), ink(line(1, 21, 5, 17.5), line(9, 14, 14, 9.5), line(20, 4, 23, 2)), hot(line(5, 17.5, 9, 14), line(14, 9.5, 20, 4)), hotDot(5, 17.5, 9, 14, 14, 9.5, 20, 4)],
    "Trim with Brep": [s.bareBox, faint(line(1, 19, 7, 15), line(17, 9, 23, 5)), hot(line(7, 15, 17, 9))],
    "Trim with Breps": [place(s.bareBox, -1, 6, 0.6), place(s.bareBox, 10, -1, 0.6), faint(line(1, 21, 23, 2)), hot(line(5, 17.5, 9, 14), line(14, 9.5, 20, 4))],
    "Trim with Region": [shade(circle(12, 12, 7.5)), faint(circle(12, 12, 7.5)), ink(line(1, 17, 5, 14.5), line(19, 8, 23, 6)), hot(line(5, 14.5, 19, 8)), hotDot(5, 14.5, 19, 8)],
    "Trim with Regions": [shade(circle(7, 8, 5), circle(17, 16, 5)), faint(circle(7, 8, 5), circle(17, 16, 5)), ink(line(1, 2, 3.5, 4.5), line(10.5, 11.5, 13.5, 13), line(20, 20, 22, 22)), hot(line(3.5, 4.5, 10.5, 11.5), line(13.5, 13, 20, 20))],
  },
  Shape: {
    "Boundary Volume": [dash(rect(2, 2, 20, 20)), tint(s.boxRing), place(hot(s.boxRing, s.boxLines), 2.5, 2.5, 0.8)],
    "Box Slits": [place(s.bareBox, -1, 3, 0.85), hot("M12 2V13H16V2", line(12, 13, 12, 18))],
    "Solid Difference": [tint(...SOLIDS.difference), ink(...SOLIDS.difference), faint(SOLIDS.ball)],
    "Solid Intersection": [faint(SOLIDS.block, SOLIDS.ball), hotFill(SOLIDS.shared)],
    "Solid Union": [tint(SOLIDS.union), ink(SOLIDS.union, line(2, 13, 8, 16, 10, 15), line(8, 16, 8, 22))],
    "Split Brep": [s.bareBox, hot("M15 1L9 9L16 14L9 23")],
    "Split Brep Multiple": [s.bareBox, hot("M11 1L5 9L12 14L5 23M19 1L13 9L20 14L13 23")],
    "Trim Solid": [s.ghostBox, ink(line(4, 12, 4, 16, 12, 20, 20, 16, 20, 12)), hot(poly(4, 12, 12, 8, 20, 12, 12, 16)), tint(poly(4, 12, 12, 8, 20, 12, 12, 16)), ink(line(12, 16, 12, 20))],
    "Mesh Difference": [tint(poly(2, 10, 8, 2, 16, 6, 15, 8.5, 10, 11, 9.6, 16, 5, 17)), ink(poly(2, 10, 8, 2, 16, 6, 15, 8.5, 10, 11, 9.6, 16, 5, 17), line(2, 10, 10, 11, 8, 2)), faint(poly(10, 11, 18, 7, 22, 14, 18, 22, 9, 20))],
    "Mesh Intersection": [faint(poly(2, 10, 8, 2, 16, 6, 14, 15, 5, 17), poly(10, 11, 18, 7, 22, 14, 18, 22, 9, 20)), tint(poly(10, 11, 15, 8.5, 14, 15, 9.6, 16)), hot(poly(10, 11, 15, 8.5, 14, 15, 9.6, 16), line(10, 11, 14, 15))],
    "Mesh Split": [ink(poly(2, 10, 8, 2, 13, 4.5, 10, 16, 5, 17), line(2, 10, 10, 16, 8, 2)), ink(poly(17, 6, 22, 14, 18, 22, 13, 18)), hot(line(17, 1, 9, 23))],
    "Mesh Union": [tint(poly(2, 10, 8, 2, 16, 6, 15.5, 8, 18, 7, 22, 14, 18, 22, 9, 20, 9.4, 16.5, 5, 17)), ink(poly(2, 10, 8, 2, 16, 6, 15.5, 8, 18, 7, 22, 14, 18, 22, 9, 20, 9.4, 16.5, 5, 17)), ink(line(2, 10, 12, 12, 8, 2), line(12, 12, 22, 14), line(9, 20, 12, 12, 18, 22))],
    "Region Difference": [faint(s.RIGHT_RING), tint(s.LEFT_MOON), hot(s.LEFT_MOON)],
    "Region Intersection": [ink(s.LEFT_RING, s.RIGHT_RING), hotFill(s.LENS)],
    "Region Slits": [tint("M2 4H22V12H14V8H10V12H2Z"), ink("M2 4H22V12H14V8H10V12H2Z"), hot("M8 22V14H16V22Z"), hot(line(12, 14, 12, 18))],
    "Region Union": [tint(s.BOTH_RINGS), hot(s.BOTH_RINGS)],
  },
};
