/** The pictures of components that stand for those of plug-ins of terrains, pictures, voxels and tweens. */

import { circle, dot, hotDot, line, poly, rect } from "../lines";
import { faint, hot, ink, shade, tint } from "../piece";
import * as s from "../shapes";
import { of } from "./plugins";
import type { Tab } from "./tab";

const frame = rect(3, 3, 18, 18);
const arrow = of([hot(line(4, 20, 20, 4), line(11, 4, 20, 4, 20, 13))]);
const colors = of([shade(circle(9, 9, 6)), ink(circle(9, 9, 6), circle(15, 15, 6))]);
const contours = of([ink(circle(12, 12, 9), circle(12, 12, 5)), hotDot(12, 12)]);
const curve = of(s.wave);
const ditch = of([tint(poly(8, 8, 16, 8, 12, 18)), ink(line(2, 8, 8, 8, 12, 18, 16, 8, 22, 8))]);
const domain = of([ink(line(3, 12, 21, 12), line(3, 7, 3, 17), line(21, 7, 21, 17))]);
const grey = of([shade(rect(3, 3, 9, 18)), ink(frame)]);
const grid = of([faint(line(9, 3, 9, 21), line(15, 3, 15, 21), line(3, 9, 21, 9), line(3, 15, 21, 15)), ink(frame)]);
const hills = of([ink(line(2, 19, 8, 8, 13, 15, 17, 10, 22, 19)), faint(line(2, 19, 22, 19))]);
const list = of([ink(line(8, 5, 21, 5), line(8, 12, 21, 12), line(8, 19, 21, 19)), dot(4, 5, 4, 12, 4, 19)]);
const mesh = of(s.mesh);
const mound = of([tint(poly(7, 17, 17, 17, 12, 6)), ink(line(2, 17, 7, 17, 12, 6, 17, 17, 22, 17))]);
const numbers = of([ink(line(9, 3, 7, 21), line(17, 3, 15, 21), line(4, 9, 21, 9), line(3, 15, 20, 15))]);
const patch = of([shade(poly(3, 17, 9, 5, 21, 7, 16, 20)), ink(line(3, 17, 9, 5, 21, 7, 16, 20, 3, 17))]);
const pixels = of([shade(rect(3, 3, 6, 6), rect(9, 9, 6, 6), rect(15, 3, 6, 6), rect(3, 15, 6, 6)), ink(frame)]);
const plane = of([ink(poly(2, 16, 9, 6, 22, 6, 15, 16)), hotDot(12, 11)]);
const points = of([dot(6, 6, 18, 5, 13, 12, 5, 17, 19, 18)]);
const read = of([ink(frame), hotDot(9, 9), faint(line(9, 3, 9, 21), line(3, 9, 21, 9))]);
const rings = of([shade(circle(9, 12, 6)), ink(circle(9, 12, 6), circle(15, 12, 6))]);
const sheet = of([ink(line(5, 2, 15, 2, 20, 7, 20, 22, 5, 22, 5, 2)), faint(line(15, 2, 15, 7, 20, 7))]);
const shown = of([ink(frame), hot(poly(9, 7, 17, 12, 9, 17))]);
const slope = of([ink(poly(3, 20, 21, 20, 21, 6)), hot(line(8, 11, 15, 5))]);
const solid = of(s.box);
const turned = of([faint(rect(3, 9, 12, 12)), ink(rect(9, 3, 12, 12))]);
const waves = of([ink("M2 9C6 3 8 3 12 9C16 15 18 15 22 9"), faint("M2 16C6 10 8 10 12 16C16 22 18 22 22 16")]);

export const bison: Tab = {
  Analysis: {
    Aspect: hills("As"),
    CutFill: hills("CF"),
    Elev: hills("El"),
    Slope: hills("Sl"),
  },
  Anno: {
    Contour: contours("Co"),
    "Slope Point": contours("SP"),
    "Spot Elevation": contours("SE"),
  },
  "Mesh Edit": {
    "Mesh Point": mesh("MP"),
  },
};

export const bitmapPlus: Tab = {
  Create: {
    "Build Bitmap": pixels("BB"),
    "Procedural Cellular": pixels("PC"),
    "Procedural Fractal Pass": pixels("PP"),
    "Procedural Noise": pixels("PN"),
  },
  File: {
    "Open Bitmap": sheet("OB"),
    "Save Bitmap": sheet("SB"),
  },
  Transform: {
    "Crop Image": turned("CI"),
    "Mirror Image": turned("MI"),
    "Resize Image": turned("RI"),
    "Scale Image": turned("SI"),
  },
  Filter: {
    "Grayscale Filter": grey("GF"),
  },
  Analysis: {
    "Bitmap Properties": read("BP"),
    "Deconstruct Bitmap": read("DB"),
    "Evaluate Bitmap": read("EB"),
    "Get Pixel": read("GP"),
  },
  Visualize: {
    "Prev Image": shown("PI"),
  },
};

export const docofossor: Tab = {
  Absolute: {
    "Cut & Fill In Path": ditch("CP"),
    "Cut & Fill In Surface": ditch("CS"),
    "Cut In Path": ditch("CI"),
    "Cut In Point": ditch("IC"),
    "Cut In Surface": ditch("IS"),
    "Fill In Path": ditch("FP"),
    "Fill In Point": ditch("FI"),
    "Fill In Surface": ditch("FS"),
  },
  Generative: {
    Noise: waves("No"),
    "Sine Wave": waves("SW"),
  },
  Analysis: {
    "Shortest Path": slope("SP"),
    "Slope Vector": slope("SV"),
  },
  Geometry: {
    "Grid Mesh": mesh("GM"),
    "Grid Points": mesh("GP"),
  },
  Grid: {
    "Grid Addition": grid("GA"),
    "Grid Compare": grid("GC"),
    "Grid Filter": grid("GF"),
    "Grid Global": grid("GG"),
    "Grid Info": grid("GI"),
    "Grid Interpolation": grid("IG"),
    "Grid Region": grid("GR"),
    "Grid Shift": grid("GS"),
    "Grid Smooth": grid("SG"),
  },
  "I-O": {
    "Empty Grid": sheet("EG"),
    "Export ASC": sheet("EC"),
    "Export DF": sheet("EF"),
    "Export XYZ": sheet("EZ"),
    "Import ASC": sheet("IC"),
    "Import DF": sheet("IF"),
    "Import Points": sheet("IP"),
    "Import XYZ": sheet("IZ"),
  },
  Relative: {
    "Cut On Area": mound("CA"),
    "Cut On Path": mound("CP"),
    "Cut On Point": mound("CO"),
    "Fill On Area": mound("FA"),
    "Fill On Path": mound("FP"),
    "Fill On Point": mound("FO"),
  },
};

export const noise4D: Tab = {
  Noise: {
    "Cellular Noise": pixels("CN"),
    "Cubic Noise": pixels("NC"),
    "Fractal Noise": pixels("FN"),
    "Perlin Noise": pixels("PN"),
    "Simplex Noise": pixels("SN"),
    "Value Noise": pixels("VN"),
    "White Noise": pixels("WN"),
  },
};

export const pufferfish: Tab = {
  Curve: {
    "Average Curve": curve("AC"),
    "Bounding Rectangle": curve("BR"),
    "Close Curve": curve("CC"),
    "Curve Degree": curve("CD"),
    "Curve Length At": curve("CA"),
    "Curve Length Between": curve("LB"),
    "Is Curve Linear": curve("IL"),
    "Mesh Naked Edges": curve("ME"),
    "Net On Surface": curve("NS"),
    "Offset Curve": curve("OC"),
    "Parameter Curve Divide Surface": curve("PS"),
    "Parameter Rectangle Grid": curve("PG"),
    "Parameter Surface Grid": curve("SP"),
    "Rebuild Curve": curve("RC"),
    "Remap Curve Domain": curve("RD"),
    "Reparameterize Curve": curve("CR"),
    "Tween Consecutive Curves": curve("TC"),
    "Tween Through Curves": curve("TT"),
    "Tween Two Curves": curve("CT"),
    "Weighted Average Curve": curve("WC"),
  },
  Point: {
    "Are Points Collinear": points("PL"),
    "Are Points Coplanar": points("PC"),
    "Curve Middle Point": points("CP"),
    "Parameter Point Divide Surface": points("PS"),
    "Parameter Point On Surface": points("PP"),
    "Tween Consecutive Points": points("TP"),
    "Tween Through Points": points("TT"),
    "Tween Two Points": points("PT"),
  },
  Plane: {
    "Average Plane": plane("AP"),
    "Flip Plane": plane("FP"),
    "Offset Plane": plane("OP"),
    "Parameter Plane Divide Surface": plane("PS"),
    "Parameter Plane On Surface": plane("PP"),
    "Tween Consecutive Planes": plane("TP"),
    "Tween Through Planes": plane("TT"),
    "Tween Two Planes": plane("PT"),
    "Weighted Average Plane": plane("WP"),
  },
  Surface: {
    "Average Surface": patch("AS"),
    "Is Polysurface Closed": patch("IC"),
    "Is Surface Closed": patch("IS"),
    "Is Surface Collapsed": patch("SI"),
    "Offset Surface": patch("OS"),
    "Parameter Subdivide Surface": patch("PS"),
    "Reparameterize Surface": patch("RS"),
    "Surface Degree": patch("SD"),
    "Swap Surface Directions": patch("SS"),
    "Tween Consecutive Surfaces": patch("TS"),
    "Tween Through Surfaces": patch("TT"),
    "Tween Two Surfaces": patch("ST"),
    "Weighted Average Surface": patch("WS"),
  },
  Mesh: {
    "Average Mesh": mesh("AM"),
    "Blend Two Meshes": mesh("BM"),
    "Close Mesh": mesh("CM"),
    "Displace Mesh": mesh("DM"),
    "Is Mesh Closed": mesh("IC"),
    "Is Mesh Disjoint": mesh("ID"),
    "Mesh Statistics": mesh("MS"),
    "Offset Mesh": mesh("OM"),
    "Parameter Extrude Mesh": mesh("PM"),
    "Parameter Loft Mesh": mesh("PL"),
    "Parameter Pipe Mesh": mesh("PP"),
    "Parameter Plane Mesh": mesh("MP"),
    "Parameter Surface Mesh": mesh("PS"),
    "Reduce Mesh": mesh("RM"),
    "Tween Consecutive Meshes": mesh("TM"),
    "Tween Through Meshes": mesh("TT"),
    "Tween Two Meshes": mesh("MT"),
    "Voxel Mesh": mesh("VM"),
    "Weighted Average Mesh": mesh("WM"),
  },
  List: {
    "Dispatch Indices": list("DI"),
    "Last Index": list("LI"),
    "List Indices": list("IL"),
  },
  Number: {
    "Curve Graph Mapper": numbers("CM"),
    "Deconstruct Number": numbers("DN"),
    "Default Angle Tolerance": numbers("DT"),
    "Document Angle Tolerance": numbers("DA"),
    "Document Distance Tolerance": numbers("DD"),
    "Equality Within Tolerance": numbers("ET"),
    "Highest & Lowest Numbers": numbers("HN"),
    "Invert Boolean": numbers("IB"),
    "Last Index Range": numbers("LR"),
    "Linearize Numbers": numbers("LN"),
    "List Length Range": numbers("LL"),
    "Mass Division": numbers("MD"),
    "Mass Subtraction": numbers("MS"),
    "Odd & Even Numbers": numbers("ON"),
    "Partition Number": numbers("PN"),
    Percentage: numbers("Pe"),
    "Reparameterize Numbers": numbers("RN"),
    "Reparameterized Range": numbers("RR"),
    "Round To Decimal Place": numbers("RP"),
    "Round To Factor": numbers("RF"),
    "Round To Nearest": numbers("RT"),
    "Tween Consecutive Numbers": numbers("TN"),
    "Tween Through Numbers": numbers("TT"),
    "Tween Two Numbers": numbers("NT"),
    "X Minus One": numbers("XO"),
    "X Plus One": numbers("XP"),
    "Zero Distance Tolerance": numbers("ZT"),
  },
  Domain: {
    "Average Domain": domain("AD"),
    "Slide Within Domain": domain("SD"),
    "Tween Consecutive Domains": domain("TD"),
    "Tween Through Domains": domain("TT"),
    "Tween Two Domains": domain("DT"),
    "Two Way Domain": domain("TW"),
    "Weighted Average Domain": domain("WD"),
  },
  Vector: {
    "Closest Vector": arrow("CV"),
    "Tween Consecutive Vectors": arrow("TV"),
    "Tween Through Vectors": arrow("TT"),
    "Tween Two Vectors": arrow("VT"),
  },
  Color: {
    "Color To Point": colors("CP"),
    "Grayscale Color": colors("GC"),
    "Invert Color": colors("IC"),
    "Tween Consecutive Colors": colors("TC"),
    "Tween Through Colors": colors("TT"),
    "Tween Two Colors": colors("CT"),
  },
  Transform: {
    "Average Transform": turned("AT"),
    "Tween Consecutive Transforms": turned("TT"),
    "Tween Through Transforms": turned("Tw"),
    "Tween Two Transforms": turned("Te"),
    "Weighted Average Transform": turned("WT"),
  },
};

export const voxelTools: Tab = {
  Analysis: {
    "Hull from Marching Cubes": grid("HC"),
    "VoxelGrid Dimensions": grid("VD"),
    "VoxelGrid From List": grid("VL"),
    "VoxelGrid Statistics": grid("VS"),
    "VoxelGrid To Boxes": grid("VB"),
    "VoxelGrid To Mesh Hull": grid("VH"),
    VoxelGridToList: grid("VG"),
  },
  Boolean: {
    "VoxelGrid Boolean Exclusive": rings("VE"),
    "VoxelGrid Boolean Intersect": rings("VI"),
    "VoxelGrid Boolean Invert": rings("VB"),
    "VoxelGrid Boolean Subtract": rings("VS"),
    "VoxelGrid Boolean Union": rings("VU"),
  },
  Create: {
    "Create VoxelGrid": solid("CG"),
    VoxelGrid: solid("VG"),
    VoxelateGeometry: solid("GV"),
  },
};
