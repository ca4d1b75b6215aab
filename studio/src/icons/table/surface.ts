/** The pictures of the Surface tab. */

import { arc, arrow, circle, dot, ellipse, head, hotDot, hotSpeck, line, poly, rect, span, speck, turnArrow } from "../lines";
import { } from "../letters";
import * as mark from "../marks";
import { dash, faint, hot, ink, place, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

const smallBox = small(s.bareBox);
const smallBrep = small(s.brep);
const smallSubd = small(s.subd);
// A box whose edges are in the background, for edges that are picked from it.
const pale: Drawing = s.ghostBox;
const cubeCorners = [12, 3, 20, 7, 12, 11, 4, 7, 4, 16, 12, 20, 20, 16] as const;
const isoU = "M5 10.5C9.5 7.5 14.5 16 19 13";
const isoV = "M9 17.5C10 13 12.5 9 15 6.5";
/** The four sides of the sheet, as single curves. */
const SIDES = { near: "M2 16C6 13 11 22 16 19", right: "M16 19C17 14 19 10 22 7", far: "M8 5C13 2 17 10 22 7", left: "M2 16C4 12 6 8 8 5" };
const moments = hot(line(12, 2, 12, 22), line(2, 12, 22, 12), turnArrow(12, 12, 7.5, -60, 20, 3));
const plate = "M4 8C9 3 19 5 20 10S15 21 9 20S1 12 4 8Z";

export const surface: Tab = {
  Analysis: {
    Area: [shade(plate), ink(plate), hot(line(5, 14, 12, 5.5), line(6, 18, 17, 6), line(11, 19, 19.5, 9.5)), hotDot(12, 12)],
    "Area Moments": [shade(plate), ink(plate), moments],
    "Box Corners": [s.bareBox, hotDot(...cubeCorners)],
    "Box Properties": [smallBox, mark.sorts],
    "Brep Area": [smallBrep, mark.area],
    "Brep Area Moments": [smallBrep, mark.area, hot(turnArrow(18.5, 6, 3.5, -120, 150, 3))],
    "Brep Closest Point": [smallBrep, hot(line(14, 13, 20, 20)), hotDot(14, 12), dot(20.5, 20.5)],
    "Brep Edges": [pale, hot(line(4, 7, 12, 11, 20, 7), line(12, 11, 12, 20)), ink(s.boxRing)],
    "Brep Topology": [ink(line(4, 7, 12, 11, 20, 7), line(12, 11, 12, 20)), hotDot(12, 11), dot(4, 7, 20, 7, 12, 20), tint(s.boxLeft)],
    "Brep Volume": [smallBrep, mark.volume],
    "Brep Volume Moments": [smallBrep, mark.volume, hot(turnArrow(18.5, 6, 3.5, -120, 150, 3))],
    "Brep Wireframe": [hot(s.boxRing, s.boxLines), faint(line(8, 5, 16, 9, 16, 18), line(16, 5, 8, 9, 8, 18), line(4, 11.5, 12, 15.5, 20, 11.5))],
    "Deconstruct Box": [smallBox, mark.axis],
    "Deconstruct Brep": [tint(poly(12, 1, 19, 4.5, 12, 8, 5, 4.5)), ink(poly(12, 1, 19, 4.5, 12, 8, 5, 4.5), poly(2, 8.5, 9, 12, 9, 21, 2, 17.5), poly(22, 8.5, 15, 12, 15, 21, 22, 17.5)), hotDot(12, 14)],
    Dimensions: [place(s.flat, -1, -3, 0.95), hot(span(1, 19, 14, 19, 3), span(18, 17, 23, 8, 3))],
    "Evaluate Box": [s.bareBox, hotDot(14, 13), hot(line(14, 13, 12, 11), line(14, 13, 14, 19), line(14, 13, 18, 11))],
    "Evaluate Surface": [s.sheet, hot(arrow(12, 12, 12, 1, 3.5)), hotDot(12, 12)],
    "Is Planar": [s.flat, hot(line(3, 21, 10, 21)), mark.check],
    "Osculating Circles": [place(s.sheet, 0, 4), hot(ellipse(12, 9.5, 3, 6.5), ellipse(12, 12, 7.5, 3.5)), hotSpeck(12, 16)],
    "Point In Brep": [ink(s.boxRing), faint(s.boxLines), hotDot(13, 13)],
    "Point In Breps": [place(s.bareBox, -1, -1, 0.62), place(s.bareBox, 8.5, 8, 0.62), hotDot(6.5, 7, 16, 16), speck(19, 4)],
    "Point In Trim": [s.sheet, hot("M7 13C8 9 12 9 14 11S13 16 11 16S7 15 7 13Z"), hotDot(10.5, 13)],
    "Principal Curvature": [s.sheet, hot(span(6, 15, 18, 9.5, 3), span(10, 8, 14, 17, 3))],
    "Shape In Brep": [s.bareBox, tint(circle(12, 12, 4)), hot(circle(12, 12, 4))],
    "Surface Closest Point": [place(s.sheet, 0, 3), dot(19, 3), hot(line(19, 3, 13, 14)), hotDot(13, 14)],
    "Surface Curvature": [place(s.sheet, 0, 2), hot("M5 12C8 3 16 3 19 14"), hotDot(12, 6)],
    "Surface Inflection": [s.sheet, hot("M10 18C9 14 14 10 14 5.5"), dash("M5 16C6 12 8 9 10 6")],
    "Surface Points": [s.grid, hotDot(2, 16, 8, 5, 22, 7, 16, 19, 12, 11.75)],
    Volume: [s.bareBox, tint(s.boxRing), hotDot(12, 12)],
    "Volume Moments": [s.bareBox, hot(line(12, 1, 12, 23), turnArrow(12, 12, 8, 30, 150, 3.5)), hotDot(12, 12)],
  },
  Freeform: {
    "4Point Surface": [s.sheet, hotDot(2, 16, 8, 5, 22, 7, 16, 19)],
    "Boundary Surfaces": [tint(plate), hot(plate), shade(circle(12, 12, 3)), ink(circle(12, 12, 3))],
    "Control Point Loft": [s.sheet, hot(SIDES.near, SIDES.far), hotDot(6.5, 16.5, 11.5, 18.5, 12.5, 4.5, 17.5, 7)],
    "Edge Surface": [s.sheet, hot(SIDES.near, SIDES.far, SIDES.left, SIDES.right)],
    Extrude: [shade("M3 11V20C9 24 15 16 21 20V11C15 7 9 15 3 11Z"), ink(line(3, 11, 3, 20), line(21, 11, 21, 20), "M3 11C9 15 15 7 21 11"), hot("M3 20C9 24 15 16 21 20"), hot(arrow(12, 9, 12, 2, 3.5))],
    "Extrude Along": [shade("M3 9C8 4 14 9 21 4V12C14 17 8 12 3 17Z"), ink("M3 9C8 4 14 9 21 4", "M3 17C8 12 14 17 21 12", line(21, 4, 21, 12)), hot(line(3, 9, 3, 17), "M5 22C10 17 15 22 20 18", head(21, 17, 1, -1, 3))],
    "Extrude Angled": [shade(poly(8, 5, 16, 5, 21, 18, 3, 18)), ink(line(3, 18, 8, 5, 16, 5, 21, 18)), hot(line(3, 18, 21, 18)), faint(line(3, 18, 3, 5)), hot(arc(3, 18, 8, -90, -69))],
    "Extrude Linear": [shade(poly(4, 12, 14, 12, 20, 5, 10, 5)), ink(poly(4, 12, 14, 12, 20, 5, 10, 5), line(4, 12, 4, 20), line(14, 12, 14, 20, 20, 13, 20, 5)), hot(line(4, 20, 14, 20)), hot(arrow(4, 20, 4, 13, 3))],
    "Extrude Point": [shade(poly(12, 3, 21, 17, 12, 21, 3, 17)), ink(line(3, 17, 12, 3, 21, 17), line(12, 3, 12, 21)), hot(line(3, 17, 12, 21, 21, 17)), hotDot(12, 3)],
    "Fit Loft": [s.sheet, hot("M4.5 13C9 10 13 18 18 15", "M6.5 8.5C11 5 16 13 20.5 10"), hotSpeck(7, 19, 18, 5, 6, 4)],
    "Fragment Patch": [ink(poly(2, 9, 9, 3, 15, 7, 22, 5, 20, 17, 11, 21, 4, 17)), tint(poly(2, 9, 15, 7, 4, 17)), hot(line(2, 9, 15, 7, 4, 17), line(15, 7, 11, 21), line(15, 7, 20, 17))],
    Loft: [shade("M3 17C8 10 15 24 21 17L19 4C14 8 9 1 5 4Z"), ink(line(3, 17, 5, 4), line(21, 17, 19, 4)), hot("M3 17C8 11 15 23 21 17", "M4 10.5C9 6 14 15.5 20 10.5", "M5 4C9 1 14 8 19 4")],
    "Loft Options": [small([shade("M3 17C8 10 15 24 21 17L19 4C14 8 9 1 5 4Z"), ink(line(3, 17, 5, 4), line(21, 17, 19, 4), "M3 17C8 11 15 23 21 17", "M5 4C9 1 14 8 19 4")]), mark.gear],
    "Network Surface": [s.sheet, hot(isoU, isoV, SIDES.near, SIDES.far, SIDES.left, SIDES.right)],
    Patch: [s.sheet, hotSpeck(8, 9, 12, 11, 16, 11, 8, 14, 13, 15, 17, 8), hot("M10 7C12 9 15 9 17 8")],
    Pipe: [shade("M3 21C3 9 9 3 20 3L22 10C14 10 10 13 10 21Z"), ink("M3 21C3 9 9 3 20 3", "M10 21C10 13 14 10 21 10"), ink(ellipse(6.5, 21, 3.5, 1.5)), ink(ellipse(20.5, 6.5, 1.5, 3.5)), hot("M6.5 20C7 11 11 6.5 19 6.5")],
    "Pipe Variable": [shade("M2 20C5 10 9 6 19 2L22 13C14 13 11 15 6 22Z"), ink("M2 20C5 10 9 6 19 2", "M6 22C11 15 14 13 22 12"), hot(line(2, 20, 6, 22), ellipse(20.5, 7, 2, 5.5), "M6 10.5L12 15.5")],
    "Rail Revolution": [ink("M7 3C13 6 9 12 15 15"), hot("M3 18C6 13 18 13 21 18C18 23 6 23 3 18Z"), dash(line(5, 2, 5, 22)), hot(head(20, 16, 1, 1.5, 3)), shade("M7 3C13 6 9 12 15 15L21 18C18 23 6 23 3 18Z")],
    Revolution: [shade("M7 3C3 9 9 13 4 20H20C15 13 21 9 17 3Z"), ink("M7 3C3 9 9 13 4 20", ellipse(12, 3.5, 5, 1.75), "M4 20C8 22.5 16 22.5 20 20", "M17 3C21 9 15 13 20 20"), hot(line(12, 1, 12, 23), turnArrow(12, 12, 4.5, 160, 20, 3))],
    "Ruled Surface": [shade("M3 20L8 6C12 2 17 8 21 4L20 20C14 16 9 22 3 20Z"), ink("M8 6C12 2 17 8 21 4", "M3 20C9 22 14 16 20 20"), hot(line(3, 20, 8, 6), line(8.5, 20, 12.5, 5), line(14.5, 18.5, 17, 5.5), line(20, 20, 21, 4))],
    "Sum Surface": [s.sheet, hot(SIDES.near, SIDES.left), hotDot(2, 16), faint(SIDES.far)],
    "Surface From Points": [s.grid, hotDot(2, 16, 8, 5, 22, 7, 16, 19, 5, 10.5, 19, 13, 9, 17.5, 15, 6.5, 12, 11.75)],
    Sweep1: [shade("M2 14C8 14 12 8 20 4L22 12C15 16 12 20 6 22Z"), ink("M2 14C8 14 12 8 20 3", "M6 22C12 20 15 16 22 12"), hot("M2 14C7 15 3 20 6 22", "M20 3C24 5 19 10 22 12"), hot("M4 18C10 17 14 11 20 8")],
    Sweep2: [shade("M2 12C8 12 12 7 19 3L22 13C15 15 12 19 6 22Z"), hot("M2 12C8 12 12 7 19 3", "M6 22C12 19 15 15 22 13"), ink("M2 12C7 13 3 20 6 22", "M19 3C24 5 18 10 22 13", "M10.5 8.5C15 11 10 15 14 17")],
  },
  Primitive: {
    "Bounding Box": [dash(rect(3, 3, 18, 18)), tint("M7 12C6 6 12 3 16 5S22 12 18 17S8 21 7 12Z"), hot("M3 13C4 6 9 3 14 3S22 9 21 13S15 21 11 21S3 17 3 13Z")],
    "Box 2Pt": [s.bareBox, hotDot(4, 16, 20, 7)],
    "Box Rectangle": [s.bareBox, tint(poly(4, 16, 12, 20, 20, 16, 12, 12)), hot(line(4, 16, 12, 20, 20, 16)), hot(arrow(12, 19, 12, 12, 3))],
    "Center Box": [s.bareBox, hotDot(12, 11), hot(line(12, 11, 16, 13), line(12, 11, 8, 13), line(12, 11, 12, 6))],
    Cone: [shade("M3 18L12 2L21 18C21 22 3 22 3 18Z"), ink("M3 18L12 2L21 18"), hot(ellipse(12, 18, 9, 3.5)), hotDot(12, 18)],
    Cylinder: [s.tube, hot(ellipse(12, 6, 7, 2.5)), hotSpeck(12, 6), hot(line(12, 6, 12, 14))],
    "Domain Box": [place(s.bareBox, 3, -2, 0.9), hot(line(7, 14.5, 12, 17), line(22, 14.5, 17, 17), line(3.5, 4.5, 3.5, 12)), hotSpeck(5, 16, 13.5, 20, 23, 16, 15, 20, 3.5, 3, 3.5, 13.5)],
    "Plane Surface": [s.hotFlat, hot(line(2, 17, 16, 17), line(2, 17, 8, 7)), hotDot(2, 17)],
    "Plane Through Box": [faint(s.boxRing, s.boxLines), tint(poly(1, 14, 9, 8, 23, 8, 15, 14)), hot(poly(1, 14, 9, 8, 23, 8, 15, 14))],
    "Plane Through Shape": [ink(circle(12, 11, 7)), tint(poly(1, 15, 8, 9, 23, 9, 16, 15)), hot(poly(1, 15, 8, 9, 23, 9, 16, 15))],
    "Quad Sphere": [s.disc, hot("M6 6C9 8 15 8 18 6", "M6 18C9 16 15 16 18 18", "M6 6C8 9 8 15 6 18", "M18 6C16 9 16 15 18 18")],
    Sphere: [s.disc, hot("M3 12C3 16.5 21 16.5 21 12"), faint("M12 3C7.5 3 7.5 21 12 21"), hotDot(12, 12)],
    "Sphere 4Pt": [s.disc, faint("M3 12C3 16.5 21 16.5 21 12"), hotDot(12, 3, 4.5, 16.5, 19.5, 16.5, 13, 11)],
    "Sphere Fit": [s.disc, faint("M3 12C3 16.5 21 16.5 21 12"), hotSpeck(11, 2, 18, 5, 21.5, 11, 19, 18, 12, 21.5, 6, 18, 2.5, 13, 5, 7, 12, 10)],
  },
  SubD: {
    "Mesh from SubD": [faint(s.softRing), ink(s.boxRing), ink(s.boxLines), hot(line(4, 7, 12, 20), line(20, 7, 12, 20), line(4, 7, 20, 7))],
    MultiPipe: [shade("M4 3L9 3L12 9L15 3L20 3L15 12V21H9V12Z"), ink("M4 3C6 9 9 10 9 14V21", "M20 3C18 9 15 10 15 14V21", "M9 3C10 7 11 8 12 8S14 7 15 3"), hot(line(6.5, 3, 12, 12, 17.5, 3), line(12, 12, 12, 21)), hotDot(12, 12)],
    "SubD Box": [s.subd, hot(s.boxRing)],
    "SubD Control Polygon": [faint(s.softRing), hot(s.boxRing, s.boxLines), hotSpeck(...cubeCorners)],
    "SubD Edge Tags": [small([shade(s.softRing), ink(s.softRing), hot(s.softLines)]), hot("M13 14H20L23 18L20 22H13Z"), hot(line(16, 18, 19.5, 18))],
    "SubD Edges": [shade(s.softRing), faint(s.softRing), hot("M4 7.5C9 11 15 11 20 7.5M12 10V21")],
    "SubD Faces": [s.subd, tint("M4 7.5C9 11 15 11 20 7.5C18 1.5 6 1.5 4 7.5Z"), hot("M4 7.5C9 11 15 11 20 7.5C18 1.5 6 1.5 4 7.5Z")],
    "SubD Fuse": [shade("M3 11C3 3 14 3 14 9C22 9 22 21 14 21C7 21 9 17 7 16C4 15 3 13 3 11Z"), ink("M3 10C3 1 15 2 14.5 9C23 8 23 21 15 21C7 21 10 17 7.5 16.5C4 16 3 14 3 10Z"), hot("M8 16.5C8 11 10 9 14.5 9")],
    "SubD Vertex Tags": [smallSubd, hotDot(3.5, 5.5, 14.5, 5.5, 9, 7.5), hot("M13 14H20L23 18L20 22H13Z"), hotSpeck(16.5, 18)],
    "SubD Vertices": [s.subd, hotDot(4.5, 7.5, 19.5, 7.5, 12, 10, 12, 20.5)],
    "SubD from Mesh": [faint(s.boxRing, s.boxLines), hot(s.softRing, s.softLines)],
  },
  Util: {
    "Brep Join": [ink(poly(2, 6, 10, 10, 10, 21, 2, 17)), ink(poly(22, 6, 14, 10, 14, 21, 22, 17)), hot(arrow(3, 2.5, 10, 2.5, 3), arrow(21, 2.5, 14, 2.5, 3)), hot(line(12, 10, 12, 21))],
    "Cap Holes": [ink("M5 8V18C5 21.5 19 21.5 19 18V8"), dash(ellipse(12, 8, 7, 2.5)), tint(ellipse(12, 4, 7, 2.5)), hot(ellipse(12, 4, 7, 2.5))],
    "Cap Holes Ex": [ink(line(5, 8, 5, 16), line(19, 8, 19, 16)), tint(ellipse(12, 5, 7, 2.5), ellipse(12, 19, 7, 2.5)), hot(ellipse(12, 5, 7, 2.5), ellipse(12, 19, 7, 2.5)), faint("M5 9C5 12 19 12 19 9")],
    "Closed Edges": [faint(line(5, 6, 5, 18), line(19, 6, 19, 18)), hot(ellipse(12, 6, 7, 2.5), ellipse(12, 18, 7, 2.5)), hotDot(12, 8.5)],
    "Convex Edges": [faint(s.boxRing), hot(line(12, 11, 12, 20), line(4, 7, 12, 11, 20, 7)), hot(arrow(12, 9, 12, 2, 3), line(4, 2, 9, 2), line(15, 2, 20, 2))],
    "Copy Trim": [place(s.sheet, 0, -1, 0.62), hot(circle(7.5, 6.5, 2.5)), place(s.sheet, 9, 9, 0.62), hot(circle(16.5, 16.5, 2.5)), hot(turnArrow(8, 16, 4.5, 180, 70, 3))],
    "Divide Surface": [s.grid, hotDot(5, 10.5, 19, 13, 9, 17.5, 15, 6.5, 12, 11.75)],
    "Edges from Directions": [pale, hot(line(4, 7, 4, 16), line(12, 11, 12, 20), line(20, 7, 20, 16)), hot(arrow(22, 23, 22, 17, 2.5))],
    "Edges from Faces": [pale, tint(s.boxTop), hot(s.boxTop), hotDot(12, 7)],
    "Edges from Length": [pale, hot(line(4, 16, 12, 20)), hot(line(3, 18.5, 1.5, 21.5), line(11, 22.5, 12.5, 19.5), line(2.5, 20, 11.5, 23.5))],
    "Edges from Linearity": [ink("M4 7L12 3L20 7"), faint(line(4, 16, 12, 20, 20, 16), line(4, 7, 4, 16), line(20, 7, 20, 16)), hot(line(4, 7, 12, 11), line(12, 11, 12, 20)), dash("M12 11C15 13 17 12 20 7")],
    "Edges from Points": [pale, hot(line(12, 11, 12, 20)), hotDot(12, 15.5), dot(17, 15.5), hot(arrow(17, 15.5, 13.5, 15.5, 2))],
    "Fillet Edge": [ink("M4 7L12 3L20 7V16L12 20L4 16Z"), ink("M4 7L9.5 9.75", "M20 7L14.5 9.75", "M9.5 9.75V18.75", "M14.5 9.75V18.75"), tint(poly(9.5, 9.75, 12, 10.5, 14.5, 9.75, 14.5, 18.75, 12, 20, 9.5, 18.75)), hot("M9.5 9.75C11 12 13 12 14.5 9.75", line(12, 11.5, 12, 20))],
    Flip: [place(s.sheet, -1, 2, 0.8), hot(arrow(9, 11, 9, 2, 3.5)), hot(arrow(20, 12, 20, 22, 3.5))],
    Isotrim: [s.sheet, tint("M7 14C8 11 10 8.5 11 7C14 8 15 11 18 10.5C17 12 16 15 15 17C13 17 10 14 7 14Z"), hot("M7 14C8 11 10 8.5 11 7C14 8 15 11 18 10.5C17 12 16 15 15 17C13 17 10 14 7 14Z")],
    "Loft Options": [hot("M2 15C5 10 11 20 14 15", "M3 9C6 5 10 13 13 9", "M4 3C7 1 10 6 12 3"), mark.gear],
    "Merge Faces": [s.flat, dash(line(5, 12, 19, 12)), hot(arrow(12, 1.5, 12, 9, 3), arrow(12, 22, 12, 15, 3))],
    "Offset Surface": [place(s.sheet, 0, 4), place(hot(s.sheetOutline), 0, -3), faint(arrow(12, 16, 12, 10, 3))],
    "Offset Surface Loose": [place(s.sheet, 0, 4), place(hot(s.sheetOutline), 0, -3), hotDot(2, 13, 8, 2, 22, 4, 16, 16)],
    Retrim: [s.sheet, ink(circle(11, 4, 2.5)), hot("M8 14C7 11 11 9 14 11S14 16 12 16S9 16 8 14Z"), hot(arrow(11, 7, 11, 10.5, 2))],
    "Surface Frames": [s.sheet, ...[[6, 13], [13, 15], [10, 8], [17, 10]].map(([x = 0, y = 0]) => hot(line(x, y - 4, x, y, x + 4, y)))],
    Untrim: [faint(s.sheetOutline), dash("M7 14C7 10 11 8 15 10S14 16 12 16S7 17 7 14Z"), hot(arrow(8, 13, 4, 15.5, 3), arrow(15, 10.5, 20, 8, 3)), hotDot(12, 12)],
  },
};
