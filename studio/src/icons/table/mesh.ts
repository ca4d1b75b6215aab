/** The pictures of the Mesh tab. */

import { arrow, circle, dot, ellipse, hotDot, hotSpeck, line, poly, rect, span, speck } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, fill, hot, hotFill, ink, place, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

const smallMesh = small(s.mesh);
const spokes = s.netLines;
const face = poly(4, 18, 20, 18, 11, 4);
const cell = poly(8, 8, 15, 7, 18, 13, 13, 18, 7, 15);
// A row of mesh faces, lying.
const strip = line(2, 17, 8, 7, 22, 7, 16, 17) + line(2, 17, 16, 17);
const quadNet: Drawing = [ink(rect(3, 3, 18, 18)), ink(line(9, 3, 9, 21), line(15, 3, 15, 21), line(3, 9, 21, 9), line(3, 15, 21, 15))];
const points = dot(6, 6, 18, 5, 13, 12, 5, 17, 19, 18);
const droplets = "M7 3.5C12 3.5 12 8 13 9.5S21 9.5 21 15.5S11 21 10 16.5S2 14 2 8.5S4 3.5 7 3.5Z";
const slider = (subject: Drawing, at: number): Drawing => [small(subject), hot(line(13, 20, 23, 20)), hotFill(circle(at, 20, 2.25))];

export const meshes: Tab = {
  Analysis: {
    "Deconstruct Face": [ink(poly(3, 14, 14, 14, 8, 3)), hotDot(3, 14, 14, 14, 8, 3), mark.goesOut],
    "Deconstruct Mesh": [ink(poly(2, 4, 10, 2, 8, 9)), ink(poly(13, 3, 22, 5, 16, 10)), ink(poly(3, 14, 10, 12, 8, 20)), hotDot(14, 16, 20, 14, 18, 21)],
    "Face Boundaries": [hot(poly(3, 7, 10, 3, 10, 10), poly(13, 3, 20, 6, 13, 10), poly(4, 20, 11, 14, 13, 21), poly(14, 13, 21, 9, 20, 18)), faint(line(3, 10, 4, 17))],
    "Face Circles": [ink(face), hot(circle(11.8, 13, 8.9)), hotDot(11.8, 13)],
    "Face Normals": [place(ink(poly(2, 17, 8, 9, 15, 17), poly(8, 9, 22, 10, 15, 17)), 0, 3), hot(arrow(8, 17, 7, 8, 3), arrow(15, 15, 17, 4, 3)), hotSpeck(8, 17, 15, 15)],
    "Mesh Closest Point": [smallMesh, dot(20.5, 20.5), hot(line(20, 20, 13, 12)), hotDot(12.5, 11.5)],
    "Mesh Depth": [ink(s.netRing), faint(spokes), hot(span(8, 5, 9, 18.5, 3), span(16, 5.5, 17, 17, 3))],
    "Mesh Edges": [s.bareMesh, hot(s.netRing)],
    "Mesh Eval": [s.bareMesh, hotDot(15, 10), hot(arrow(15, 10, 19, 1.5, 3))],
    "Mesh Inclusion": [ink(s.netRing), faint(spokes), hotDot(12, 12), mark.ask],
  },
  Primitive: {
    "Construct Mesh": [ink(poly(3, 17, 9, 4, 15, 16)), hotDot(3, 17, 9, 4, 15, 16), mark.plus],
    "Mesh Box": [s.bareBox, hot(line(8, 5, 16, 9, 16, 18), line(16, 5, 8, 9, 8, 18), line(4, 11.5, 12, 15.5, 20, 11.5))],
    "Mesh Colours": [ink(s.netRing, spokes), hotFill(poly(10, 3, 20, 6, 12, 12)), tint(poly(3, 9, 10, 3, 12, 12), poly(12, 12, 21, 15, 13, 21)), shade(poly(4, 17, 12, 12, 13, 21))],
    "Mesh Plane": [ink(strip), hot(line(4, 13.7, 18, 13.7), line(6, 10.3, 20, 10.3), line(6.7, 17, 12.7, 7), line(11.3, 17, 17.3, 7))],
    "Mesh Quad": [tint(poly(4, 18, 7, 4, 20, 6, 18, 20)), ink(poly(4, 18, 7, 4, 20, 6, 18, 20)), hotDot(4, 18, 7, 4, 20, 6, 18, 20)],
    "Mesh Sphere": [ink(circle(12, 12, 9)), hot(ellipse(12, 12, 4, 9), line(3, 12, 21, 12), "M5 6.5C9 8 15 8 19 6.5", "M5 17.5C9 16 15 16 19 17.5")],
    "Mesh Sphere Ex": [ink(circle(12, 12, 9)), hot("M6 6C9 8 15 8 18 6", "M6 18C9 16 15 16 18 18", "M6 6C8 9 8 15 6 18", "M18 6C16 9 16 15 18 18", line(12, 7.5, 12, 16.5), line(7.5, 12, 16.5, 12))],
    "Mesh Spray": [ink(rect(3, 10, 8, 12), line(5, 10, 5, 7, 9, 7, 9, 10)), tint(rect(3, 14, 8, 5)), hotSpeck(12, 5, 15, 3, 15, 7, 18.5, 2, 18.5, 5, 18.5, 9, 22, 3, 22, 7)],
    "Mesh Triangle": [tint(face), ink(face), hotDot(4, 18, 20, 18, 11, 4)],
  },
  Triangulation: {
    "Convex Hull": [tint(poly(4, 8, 12, 3, 21, 8, 19, 19, 6, 20)), hot(poly(4, 8, 12, 3, 21, 8, 19, 19, 6, 20)), dot(4, 8, 12, 3, 21, 8, 19, 19, 6, 20), speck(10, 10, 15, 9, 13, 15)],
    "Delaunay Edges": [hot(poly(6, 6, 18, 5, 19, 18, 5, 17), line(6, 6, 13, 12, 18, 5), line(5, 17, 13, 12, 19, 18)), points],
    "Delaunay Mesh": [shade(poly(6, 6, 18, 5, 19, 18, 5, 17)), tint(poly(6, 6, 18, 5, 13, 12), poly(5, 17, 13, 12, 19, 18)), ink(poly(6, 6, 18, 5, 19, 18, 5, 17), line(6, 6, 13, 12, 18, 5), line(5, 17, 13, 12, 19, 18)), hotDot(6, 6, 18, 5, 13, 12, 5, 17, 19, 18)],
    "Facet Dome": [shade("M3 18L5 10L12 4L19 10L21 18Z"), ink("M3 18L5 10L12 4L19 10L21 18Z", line(5, 10, 10, 12, 12, 4), line(10, 12, 15, 11, 12, 4), line(15, 11, 19, 10), line(3, 18, 10, 12, 12, 18, 15, 11, 21, 18)), hotDot(12, 4)],
    MetaBall: [tint(droplets), hot(droplets), dot(7, 8.5, 15.5, 15.5)],
    "MetaBall(t)": [hot(droplets), ink(circle(7, 8.5, 2.5), circle(15.5, 15.5, 2.5)), word("t", 18, 5, 6, hot)],
    "MetaBall(t) Custom": [hot(droplets), ink(circle(7, 8.5, 2.5), circle(15.5, 15.5, 4)), word("q", 18, 4, 6, hot)],
    OcTree: [s.bareBox, tint(poly(12, 11, 16, 9, 16, 13.5, 12, 15.5)), hot(line(16, 9, 16, 18), line(12, 15.5, 20, 11.5), line(16, 9, 12, 7, 8, 9), line(16, 5, 12, 7)), hotSpeck(14, 12.25)],
    "Proximity 2D": [points, hot(line(6, 6, 13, 12, 18, 5), line(13, 12, 19, 18), line(5, 17, 13, 12))],
    "Proximity 3D": [s.ghostBox, dot(7, 8, 17, 8, 8, 15, 16, 16, 12, 11), hot(line(7, 8, 12, 11, 17, 8), line(8, 15, 12, 11, 16, 16))],
    "Quad Remesh": [ink("M2 7C8 2 16 2 22 7V18C16 13 8 13 2 18Z"), hot("M2 12.5C8 7.5 16 7.5 22 12.5", line(7, 4.5, 7, 15), line(12, 3.5, 12, 14), line(17, 4.5, 17, 15))],
    "Quad Remesh Settings": [small([ink("M2 7C8 2 16 2 22 7V18C16 13 8 13 2 18Z", "M2 12.5C8 7.5 16 7.5 22 12.5", line(8.5, 4.5, 8.5, 15), line(15.5, 4.5, 15.5, 15))]), mark.gear],
    "Quadmesh Settings": [small(quadNet), mark.gear],
    QuadTree: [ink(rect(3, 3, 18, 18)), ink(line(12, 3, 12, 21), line(3, 12, 21, 12)), hot(line(16.5, 3, 16.5, 12), line(12, 7.5, 21, 7.5)), hotSpeck(14.3, 5.3, 18.7, 9.7, 14.3, 9.7), speck(7.5, 16.5)],
    Substrate: [ink(rect(2, 2, 20, 20)), hot(line(2, 8, 22, 6), line(9, 7.3, 11, 22), line(10, 14.5, 22, 13), line(17, 6.5, 18, 13.5), line(15, 14, 16, 22), line(5, 7.7, 6, 22))],
    TriRemesh: [ink(poly(7, 3, 17, 3, 22, 12, 17, 21, 7, 21, 2, 12)), hot(line(2, 12, 22, 12), line(7, 3, 17, 21), line(17, 3, 7, 21))],
    Voronoi: [ink(rect(3, 3, 18, 18)), tint(cell), hot(poly(8, 8, 15, 7, 18, 13, 13, 18, 7, 15), line(8, 8, 6, 3), line(15, 7, 17, 3), line(18, 13, 21, 13), line(13, 18, 14, 21), line(7, 15, 3, 17)), dot(12, 12)],
    "Voronoi 3D": [s.bareBox, tint(poly(8, 9, 12, 11, 12, 16, 8, 17)), hot(line(8, 5, 10, 8, 8, 9, 4, 12), line(10, 8, 16, 9, 20, 12), line(16, 9, 15, 14, 12, 16), line(8, 9, 8, 13, 12, 16), line(8, 13, 6, 17), line(15, 14, 17, 17.5))],
    "Voronoi Cell": [tint(cell), hot(cell), dot(12, 12), speck(4, 5, 20, 4, 22, 18, 12, 22, 3, 19)],
    "Voronoi Groups": [ink(poly(3, 3, 21, 3, 21, 21, 3, 21)), hot(line(12, 3, 11, 8, 14, 13, 12, 21)), faint(line(3, 11, 7, 12, 11, 8), line(7, 12, 8, 21), line(14, 13, 21, 12), line(17, 3, 18, 12.5)), hotSpeck(6, 7, 5, 17), speck(15, 8, 17.5, 17)],
  },
  Util: {
    "Align Vertices": [ink(poly(2, 19, 8, 4, 11, 18)), ink(poly(13, 18, 16, 4, 22, 19)), hot(circle(12, 18, 4)), hotSpeck(12, 18)],
    "Blur Mesh": [ink(s.netRing), tint(circle(12, 12, 6)), hotFill(circle(12, 12, 2.5)), faint(spokes), dash(circle(12, 12, 6))],
    "Cull Faces": [smallMesh, mark.triangle, hot(line(14, 22, 23, 15))],
    "Cull Vertices": [small(s.bareMesh), hot(circle(18.5, 18.5, 2)), hot(line(14.5, 22.5, 22.5, 14.5))],
    "Delete Faces": [ink(s.netRing, spokes), dash(poly(10, 3, 20, 6, 12, 12)), hot(line(12, 5, 17, 10), line(17, 5, 12, 10))],
    "Delete Vertices": [ink(s.netRing), faint(spokes), hot(line(9, 9, 15, 15), line(15, 9, 9, 15))],
    "Disjoint Mesh": [ink(poly(2, 12, 9, 3, 10, 13), poly(2, 12, 10, 13, 6, 20)), ink(poly(22, 12, 15, 3, 14, 13), poly(22, 12, 14, 13, 18, 20)), hot(line(12, 2, 12, 22))],
    Exposure: [hotFill(circle(5, 5, 3)), hot(line(9, 6, 14, 8), line(8, 8, 12, 12), line(6, 9, 8, 14)), place(s.bareMesh, 9, 9, 0.62)],
    "Flip Mesh": [place(s.mesh, 0, 3, 0.8), mark.upDown, hot(arrow(18.5, 10, 18.5, 2, 3))],
    "Mesh Brep": [small(s.brep), hot(poly(13, 22, 18, 13, 23, 22), line(15.5, 17.5, 20.5, 17.5, 18, 22, 15.5, 17.5))],
    "Mesh Join": [ink(poly(2, 12, 9, 3, 12, 12), poly(2, 12, 12, 12, 7, 21)), ink(poly(22, 12, 15, 3, 12, 12), poly(22, 12, 12, 12, 17, 21)), hotDot(12, 12), hot(arrow(1.5, 5, 5, 8, 2.5), arrow(22.5, 5, 19, 8, 2.5))],
    "Mesh Shadow": [place(s.bareMesh, 0, -1, 0.68), fill("M6 20C9 16 19 16 23 19C21 22 9 23 6 20Z"), hotFill(circle(20, 4, 2.5)), hot(line(18, 7, 16, 10))],
    "Mesh Split Plane": [place(s.bareMesh, 0, -1.5), tint(poly(1, 15, 8, 10, 23, 10, 16, 15)), hot(poly(1, 15, 8, 10, 23, 10, 16, 15))],
    "Mesh Surface": [s.sheet, hot("M5 10.5C9.5 7.5 14.5 16 19 13M9 17.5C10 13 12.5 9 15 6.5"), hot(line(2, 16, 12, 12, 22, 7), line(5, 10.5, 15, 6.5), line(9, 17.5, 19, 13))],
    Occlusion: [dot(4, 12), ink(poly(11, 3, 15, 7, 12, 11)), hot(line(4, 12, 11, 7)), faint(line(13, 7, 20, 2)), hot(arrow(4, 12, 22, 13, 3), arrow(4, 12, 18, 21, 3))],
    Quadrangulate: [ink(poly(4, 4, 20, 4, 20, 20, 4, 20)), faint(line(4, 20, 20, 4)), tint(rect(4, 4, 16, 16)), hot(line(9, 9, 15, 15), line(15, 9, 9, 15))],
    "Settings (Custom)": [small(s.bareMesh), hot(line(14, 15, 23, 15), line(14, 21, 23, 21)), hotDot(17, 15, 20, 21)],
    "Settings (Quality)": slider(quadNet, 21.5),
    "Settings (Speed)": slider(ink(poly(3, 20, 20, 20, 12, 4)), 14.5),
    "Simple Mesh": [ink(poly(12, 3, 20, 7, 20, 16, 12, 20, 4, 16, 4, 7)), ink(line(4, 7, 12, 11, 20, 7), line(12, 11, 12, 20)), hot(line(4, 16, 12, 11, 20, 16))],
    "Smooth Mesh": [faint(line(2, 18, 6, 6, 10, 16, 14, 5, 18, 16, 22, 8)), hot("M2 16C6 8 8 12 12 11S18 11 22 9"), ink(line(2, 22, 22, 22)), dot(2, 16, 12, 11, 22, 9)],
    Triangulate: [ink(poly(4, 4, 20, 4, 20, 20, 4, 20)), tint(poly(4, 20, 20, 4, 20, 20)), hot(line(4, 20, 20, 4))],
    "Unify Mesh": [place(ink(poly(2, 17, 8, 9, 15, 17), poly(8, 9, 22, 10, 15, 17)), 0, 4), hot(arrow(8, 17, 8, 7, 3), arrow(15, 17, 15, 7, 3)), hot(line(6, 3, 17, 3))],
    "Unweld Mesh": [ink(poly(2, 20, 5, 5, 10, 20)), ink(poly(22, 20, 19, 5, 14, 20)), hot(arrow(10, 12, 8, 12, 0.1), span(7.5, 12, 16.5, 12, 3))],
    "Weld Mesh": [ink(poly(2, 20, 12, 5, 12, 20)), ink(poly(22, 20, 12, 5, 12, 20)), hotDot(12, 5, 12, 20), hot(line(12, 5, 12, 20))],
  },
};
