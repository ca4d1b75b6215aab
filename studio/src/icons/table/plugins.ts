/** The pictures of components that stand for those of plug-ins: what a panel works on, and two letters of the name. */

import { circle, dot, hotDot, line, poly, rect } from "../lines";
import * as mark from "../marks";
import { faint, hot, ink, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

/** A picture of a panel: its subject, small, with letters in the corner. */
export const of = (subject: Drawing) => (letters: string): Drawing => [small(subject), mark.sign(letters)];

const pulled = of([ink(line(4, 18, 18, 6)), hotDot(4, 18, 18, 6)]);
const body = of([s.bareBox, dot(12, 11)]);
const bent = of([ink(line(3, 19, 12, 7, 21, 17)), hot("M8 12C10 15 14 15 16 12")]);
const round = of([faint(circle(12, 12, 8)), dot(12, 4, 20, 12, 12, 20, 4, 12)]);
const apart = of([ink(circle(8, 12, 5), circle(18, 12, 5)), hot(line(13, 4, 13, 20))]);
const taut = of([ink(line(3, 12, 21, 12)), hotDot(3, 12, 21, 12)]);
const net = of([ink(s.netRing), faint(s.netLines), hotDot(12, 12)]);
const held = of([s.wave, hotDot(12, 12)]);
const pinned = of([ink(line(12, 4, 12, 16)), hotDot(12, 18), tint(poly(6, 2, 18, 2, 12, 6))]);
const rest = of([ink("M3 4C5 22 19 22 21 4"), hotDot(3, 4, 21, 4), dot(12, 17.5)]);
const mesh = of(s.mesh);
const points = of([dot(6, 6, 18, 5, 13, 12, 5, 17, 19, 18)]);
const panels = of([shade(rect(3, 3, 9, 9), rect(12, 12, 9, 9)), ink(rect(3, 3, 18, 18), line(12, 3, 12, 21), line(3, 12, 21, 12))]);
const frame = of([ink(rect(3, 3, 18, 18), line(3, 3, 21, 21), line(21, 3, 3, 21))]);
const shown = of([ink("M2 12C6 5 18 5 22 12C18 19 6 19 2 12Z", circle(12, 12, 3))]);
const wave = of(s.wave);
const soft = of(s.subd);
const solid = of(s.box);
const rows = of([ink(rect(3, 4, 18, 16), line(3, 9, 21, 9), line(3, 14, 21, 14), line(9, 4, 9, 20))]);
const globe = of([ink(circle(12, 12, 9), line(3, 12, 21, 12), line(12, 3, 12, 21)), faint("M12 3C6 8 6 16 12 21M12 3C18 8 18 16 12 21")]);
/** Paths and branches. */
export const branched = of([ink(line(4, 12, 10, 12), line(10, 5, 10, 19), line(10, 5, 18, 5), line(10, 12, 18, 12), line(10, 19, 18, 19)), dot(4, 12, 19, 5, 19, 12, 19, 19)]);

export const human: Tab = {
  Display: {
    "Custom Preview Lineweights": shown("CP"),
    "Custom Preview Materials": shown("CM"),
    "Render Curve to Screen": shown("RC"),
    "Render Mesh to Screen": shown("RM"),
    "Render Point to Screen": shown("RP"),
    "Render Text to Screen": shown("RT"),
    "Screen-Oriented Mesh": shown("SM"),
    "Screen-Oriented Text": shown("ST"),
  },
  Creation: {
    "Bake Geometry": solid("BG"),
    CreateAttributes: solid("CA"),
    CreateHatch: panels("CH"),
    "Define Block": solid("DB"),
    JustifiedText3d: shown("JT"),
  },
  "Document Info": {
    "Layer Table": rows("LT"),
    "Linetype Table": rows("LY"),
    "Material Table": rows("MT"),
  },
  "Document Modifications": {
    "Modify Object Attributes": solid("MO"),
  },
  Misc: {
    Box2BoxXform: solid("BB"),
    "Convert To Document Units": taut("DU"),
    "Dispatch Multiple": branched("DM"),
    "Filter By Item": rows("FI"),
    PassSequentially: rows("PS"),
  },
  Reference: {
    "Dynamic Geometry Pipeline": solid("DP"),
    "Explode Blocks": solid("EB"),
    "Explode Blocks Recursively": solid("ER"),
    "Hatch Explode": panels("HE"),
    "Object Attributes": solid("OA"),
    "Read 3dm File": solid("R3"),
    "Reinstate Tree": branched("RT"),
    "Sort Objects By Type": branched("SO"),
    "Text Object Info": shown("TI"),
  },
};

export const kangaroo2: Tab = {
  Elder: {
    AnchorSpring: pulled("AS"),
    Bend: pulled("Be"),
    CurvePull: pulled("CP"),
    Equalize: pulled("Eu"),
    Hinge: pulled("Hi"),
    "Kangaroo Settings": pulled("KS"),
    KangarooPhysics: pulled("KP"),
    Laplacian: pulled("La"),
    Planarize: pulled("Pl"),
    PowerLaw: pulled("PL"),
    Pressure: pulled("Pr"),
    PullToMesh: pulled("PM"),
    PullToSurf: pulled("PS"),
    SpringsFromLine: pulled("SL"),
    SpringsFromMesh: pulled("SM"),
    UnaryForce: pulled("UF"),
    ZombieKangaroo: pulled("ZK"),
  },
  "Goals-6dof": {
    RigidPointSet: body("RP"),
  },
  "Goals-Angle": {
    Angle: bent("An"),
    AngleSnap: bent("AS"),
    ClampAngle: bent("CA"),
    EqualAngle: bent("EA"),
    Rod: bent("Ro"),
  },
  "Goals-Co": {
    CoCircular: round("CC"),
    CoLinear: round("CL"),
    CoPlanar: round("CP"),
    CoSpherical: round("CS"),
  },
  "Goals-Col": {
    Collider: apart("Co"),
    CurvePointCollide: apart("Ci"),
    SolidPointCollide: apart("SP"),
    SphereCollide: apart("SC"),
  },
  "Goals-Lin": {
    ClampLength: taut("Ce"),
    ConstantTension: taut("CT"),
    Direction: taut("Di"),
    DynamicWeight1d: taut("DW"),
    EqualLength: taut("EL"),
    "Length(Line)": taut("LL"),
    LengthRatio: taut("LR"),
    LengthSnap: taut("LS"),
    PlasticLength: taut("PL"),
  },
  "Goals-Mesh": {
    CyclicQuad: net("CQ"),
    EdgeLengths: net("Ee"),
    Hinge: net("Hi"),
    NoFoldThrough: net("NF"),
    Planarize: net("Pl"),
    PlasticHinge: net("PH"),
    PolygonArea: net("PA"),
    Pressure: net("Pr"),
    Smooth: net("Sm"),
    SoapFilm: net("SF"),
    TangentialSmooth: net("TS"),
    VertexLoads: net("VL"),
    Volume: net("Vo"),
    Wind: net("Wi"),
    TangentIncircles: net("TI"),
  },
  "Goals-On": {
    OnCurve: held("OC"),
    OnMesh: held("OM"),
    OnPlane: held("OP"),
  },
  "Goals-Pt": {
    Anchor: pinned("Ac"),
    AnchorXYZ: pinned("AX"),
    Bomb: pinned("Bo"),
    Coincident: pinned("Cn"),
    Floor: pinned("Fl"),
    FloorFriction: pinned("FF"),
    Load: pinned("Lo"),
    MagnetSnap: pinned("MS"),
    PlasticAnchor: pinned("Pn"),
    Transform: pinned("Tr"),
  },
  Goals: {
    "Length(Pts)": pulled("LP"),
    RigidBody: pulled("RB"),
  },
  Main: {
    BouncySolver: rest("BS"),
    Grab: rest("Gr"),
    Show: rest("Sh"),
    "Soft & Hard Solver": rest("SH"),
    Solver: rest("So"),
    StepSolver: rest("SS"),
    ZombieSolver: rest("ZS"),
  },
  Mesh: {
    Bipartite: mesh("Bi"),
    ByParent: mesh("BP"),
    Checkerboard: mesh("Ch"),
    "Combine&Clean": mesh("Cl"),
    Diagonalize: mesh("Da"),
    FoldAngle: mesh("FA"),
    HingePoints: mesh("HP"),
    MeshCorners: mesh("MC"),
    MeshTurn: mesh("MT"),
    NakedVertices: mesh("NV"),
    PlanarityAnalysis: mesh("Pa"),
    Refine: mesh("Re"),
    Stripper: mesh("St"),
    Unroller: mesh("Un"),
    VertexNeighbours: mesh("VN"),
    WarpWeft: mesh("WW"),
  },
  Utility: {
    DotDisplay: points("DD"),
    SplitAtCorners: points("SA"),
    interconnectPoints: points("iP"),
    removeDuplicateLines: points("rD"),
    removeDuplicatePts: points("rP"),
  },
};

export const lunchbox: Tab = {
  "LunchBox Panels": {
    "Diamond Grid": panels("DG"),
    "Diamond Panels": panels("DP"),
    "Hexagon Cells": panels("HC"),
    "Quad Grid": panels("QG"),
    "Quad Panels": panels("QP"),
    "Random Quad Panels": panels("RQ"),
    "Skewed Quads": panels("SQ"),
    "Staggered Quad Panels": panels("SP"),
    "Triangle Panels B": panels("TP"),
    "Triangle Panels C": panels("TC"),
    "Triangular Panels A": panels("TA"),
  },
  "LunchBox Structure": {
    "2D Truss": frame("2T"),
    "Braced Grid 1D Structure": frame("BG"),
    "Braced Grid 2D Structure": frame("BS"),
    "Diagrid Structure": frame("DS"),
    "Grid Structure": frame("GS"),
    "Hexagonal Structure": frame("HS"),
    "Space Truss Structure 1": frame("S1"),
    "Space Truss Structure 2": frame("S2"),
  },
  Math: {
    "3D Supershape": soft("SS"),
    "Conoid Surface": soft("Co"),
    "Enneper Surface": soft("En"),
    "Helicoid Surface": soft("He"),
    "Hyperbolic Paraboloid": soft("HP"),
    "Klein Surface": soft("Kl"),
    "Mobius Surface": soft("Mo"),
    "Torus Surface": soft("To"),
    "Platonic Cube": solid("PC"),
    "Platonic Dodecahedron": solid("PD"),
    "Platonic Icosahedron": solid("PI"),
    "Platonic Octahedron": solid("PO"),
    "Platonic Tetrahedron": solid("PT"),
  },
  Generate: {
    Attractor: points("At"),
    "Attractor Wave": wave("AW"),
    "Constant Quad Subdivide": panels("CQ"),
    "Panel Frame": panels("PF"),
    "Subdivide Quad": panels("QS"),
    "Subdivide Triangle": panels("ST"),
  },
  Util: {
    "Arc Divide": bent("AD"),
    "Brep Join with Tolerance": solid("BJ"),
    "Create RTree": points("RT"),
    "Deconstruct Wireframe": net("DW"),
    "Flatness Check": panels("FC"),
    "Mesh Edges (with Tolerance)": mesh("ME"),
    "Mesh Reduce": mesh("MR"),
    "Patch Surface": soft("PS"),
    "Random Split List": branched("RS"),
    "Rebuild Surface": soft("Re"),
    "Relative Coordinates": points("RC"),
    "Reverse Surface Direction": soft("Rv"),
    "RTree Closest Point": points("CP"),
    "RTree Points in Range": points("PR"),
    "Sort Adjacent Brep Faces": solid("SA"),
    "Sort Duplicate Curves": wave("SC"),
    "Sort Duplicate Points": points("SP"),
    "Sort Duplicate Values": rows("SV"),
  },
  Mesh: {
    "Mesh Extrude": mesh("MX"),
    "Mesh Offset": mesh("MO"),
    "Mesh to Nurbs": mesh("MN"),
  },
  Data: {
    "Convert JSON to XML": branched("JX"),
    "Convert XML to JSON": branched("XJ"),
    "Create CSV": rows("CC"),
    "Read CSV": rows("RV"),
    "Read XML by Tag": branched("RX"),
  },
  "Machine Learning": {
    "Gaussian Mixture": points("GM"),
    "K-Means Clustering": points("KM"),
    "Linear Regression": taut("LR"),
    "Logistic Regression": wave("Lo"),
    "Multivariate Linear Regression": taut("ML"),
  },
  Workflow: {
    "Excel Reader": rows("ER"),
    "Excel Write": rows("EW"),
  },
};

export const ghowl: Tab = {
  GEO: {
    "Format Geo": globe("FG"),
    "Geo to XYZ": globe("GX"),
    "XYZ to Geo": globe("XG"),
  },
  KML: {
    "KML Exporter": globe("KE"),
    "KML Style": globe("KS"),
  },
  Spreadsheet: {
    "Spreadsheet Reader": rows("SR"),
    "Spreadsheet Writer": rows("SW"),
  },
  UDP: {
    "OSC Channel": wave("OC"),
    "OSC Dispatch": wave("OD"),
  },
  XML: {
    "Write XML": branched("WX"),
    "Xml Parser": branched("XP"),
  },
};

export const editree: Tab = {
  EdiTree: {
    "Divide List": branched("DL"),
    "Partition List Adv": branched("PL"),
    "Split List Multi": branched("SL"),
    SubTree: branched("ST"),
  },
};

export const treefrog: Tab = {
  TreeFrog: {
    "Assign Paths": branched("AP"),
    "Graft By Data": branched("GD"),
    "Match Paths": branched("MP"),
    "Path Description": branched("PD"),
  },
};

export const heteroptera: Tab = {
  Fundamental: {
    "Domain (Symmetric)": taut("DS"),
    "Domain Expand": taut("DE"),
    "Domain Expand (Symmetric)": taut("ES"),
  },
  Geometry: {
    Center: points("Ce"),
    "Evaluate Rectangle": panels("ER"),
  },
  Maths: {
    "Closest Numbers": points("CN"),
    "Intersect Domains": taut("ID"),
    "Numbers On Grid": rows("NG"),
  },
  Uncertainty: {
    "Careless Range": taut("CR"),
    Dice: points("Di"),
    "Gaussian Random": wave("GR"),
  },
  Utilities: {
    "Allocate By Domain": branched("AD"),
    "Allocate By Index": branched("AI"),
    "Allocate By Keys": branched("AK"),
    "Allocate By Value": branched("AV"),
    "Empty Structure": branched("ES"),
    "Extend Path": branched("EP"),
  },
  Vectors: {
    "Plane By Line": pulled("PL"),
  },
};

export const meshedit: Tab = {
  Analysis: {
    "Mesh Area": mesh("MA"),
    "Mesh NakedEdge": mesh("MN"),
    "Mesh Volume": mesh("MV"),
  },
  Create: {
    "Mesh from Points": mesh("Mf"),
  },
  Edit: {
    "Mesh ConvertQuads": mesh("MC"),
    "Mesh CullUnusedVertices": mesh("Mu"),
    "Mesh Explode": mesh("ME"),
    "Mesh Flip": mesh("MF"),
    "Mesh Triangulate": mesh("MT"),
    "Mesh UnifyNormals": mesh("UN"),
    "Mesh WeldVertices": mesh("MW"),
  },
  Triangulation: {
    "3D ConvexHull": mesh("CH"),
    "Convex Hull Points": points("HP"),
  },
};

export const telepathy: Tab = {
  Params: {
    "Remote Receiver": wave("RR"),
    "Remote Sender": wave("RS"),
  },
};

export const weaverbird: Tab = {
  "Wb Create": {
    "Mesh From Lines (Weave Back)": mesh("Wk"),
    Tile: mesh("Ti"),
  },
  "Wb Define": {
    "Mesh Antiprism": solid("MA"),
    "Mesh Dipyramid": solid("MD"),
    "Mesh Mesh Icosahedron": solid("MI"),
    "Mesh Prism": solid("MP"),
    "Mesh Pyramid": solid("My"),
    "Polylines Dodecahedron": solid("PD"),
  },
  "Wb Extract": {
    "Dual graph": mesh("Dg"),
    "Face Polylines": mesh("FP"),
    "Join Meshes and Weld": mesh("oi"),
    "Mesh Edges": mesh("ME"),
    "Naked boundary": mesh("Nb"),
    "Reroute Faces": mesh("RF"),
    "Reroute Faces by Pattern": mesh("RP"),
    "Unify face windings": mesh("Uf"),
    "Vertices Component": mesh("VC"),
  },
  "Wb Smoothen": {
    "Blur Mesh": soft("BM"),
    "Laplacian Smoothing": soft("LS"),
    "LaplacianHC Smoothing": soft("LH"),
  },
  "Wb SubD": {
    "Catmull-Clark Subdivision": soft("CC"),
    "Constant Quads Split Subdivision": soft("CQ"),
    "Inner Polygons Subdivision": soft("IP"),
    "Loop Subdivision": soft("Lu"),
    "Midedge Subdivision": soft("MS"),
    "Sierpinski Triangles Subdivision": soft("ST"),
    "Split Polygons Subdivision": soft("SP"),
    "Split Triangles Subdivision": soft("SS"),
  },
  "Wb Transform": {
    "Bevel Edges": solid("BE"),
    "Bevel Vertices": solid("BV"),
    "Mesh Thicken": solid("MT"),
    "Mesh Window": solid("MW"),
    "Offset Mesh": solid("OM"),
    "Picture Frame": solid("PF"),
    "Sierpinski Carpet": solid("SC"),
    "Stellate/Cumulation": solid("Su"),
  },
};
