/** The pictures of Dendro's, jSwan's, ColorPlus's, EleFront's and TreeSloth's components. */

import { circle, dot, hotDot, line, poly, rect } from "../lines";
import { faint, hot, ink, shade } from "../piece";
import { branched, of } from "./plugins";
import type { Tab } from "./tab";

const volume = of([faint(line(3, 9, 21, 9), line(3, 15, 21, 15), line(9, 3, 9, 21), line(15, 3, 15, 21)), ink(circle(12, 12, 7))]);
const sets = of([shade(circle(9, 12, 6)), ink(circle(9, 12, 6)), hot(circle(15, 12, 6))]);
const braces = of([ink("M9 3C5 3 8 12 4 12C8 12 5 21 9 21", "M15 3C19 3 16 12 20 12C16 12 19 21 15 21"), hotDot(12, 12)]);
const swatch = of([shade(rect(3, 6, 6, 12)), ink(rect(3, 6, 18, 12), line(9, 6, 9, 18), line(15, 6, 15, 18)), hot(line(12, 3, 12, 21))]);
const list = of([ink(poly(4, 4, 20, 4, 20, 8, 4, 8), poly(4, 16, 20, 16, 20, 20, 4, 20)), dot(12, 11, 12, 13)]);
const found = of([ink(circle(10, 10, 6)), hot(line(14, 14, 21, 21))]);
const tag = of([ink(poly(3, 12, 10, 5, 21, 5, 21, 19, 10, 19)), hotDot(8, 12)]);

export const elefront: Tab = {
  "01 Reference": {
    "Reference by BakeName": found("RB"),
    "Reference by Color": found("RC"),
    "Reference by Key": found("RK"),
    "Reference by Key and Value": found("RV"),
    "Reference by Layer": found("RL"),
    "Reference by Name": found("RN"),
    "Reference by Type": found("RT"),
    "Reference by User Atributes": found("RU"),
    "Reference Block by Name": found("BN"),
  },
  "02 Filter": {
    "Filter By Color": found("FC"),
    "Filter By Layer": found("FL"),
    "Filter By Name": found("FN"),
    "Filter By Type": found("FT"),
    "Filter By User Attributes": found("FU"),
    "Sort By Key": found("SK"),
  },
  "03 Attributes": {
    "Attach Attributes": tag("AA"),
    "Create Attributed Geometry": tag("AG"),
    "Deconstruct Attributes": tag("XK"),
    "Define Color": tag("DC"),
    "Define Layer": tag("DL"),
    "Define Object Attributes": tag("DA"),
    "Detach Attributes": tag("XA"),
    "Get All Keys/Values": tag("KV"),
    "Get Elefront Attributes": tag("GA"),
    "Get Rhino Attributes": tag("RA"),
    "Get User Attributes": tag("UA"),
    "Get User Value": tag("UV"),
    "Modify Attributes": tag("MA"),
    "Modify Elefront Attributes": tag("ME"),
    "Modify Rhino Object Attributes": tag("MR"),
    "Object Attributes": tag("OA"),
    "Remove User Attributes": tag("RU"),
  },
  "04 Annotations": {
    "Create Hatch": tag("CH"),
    "Create Text": tag("CX"),
    "Create Text Dot": tag("CT"),
    "Deconstruct Hatch": tag("XH"),
    "Deconstruct Text": tag("XT"),
    "Define Hatch": tag("DH"),
    "Define Text Dot": tag("TD"),
    "Define Text Object": tag("TO"),
  },
  "05 Blocks": {
    "Deconstruct Block": tag("XB"),
    "Define Block": tag("DB"),
    "Explode Block": tag("EB"),
    "Get Block Info": tag("BI"),
    "Insert Block": tag("IB"),
  },
  "06 Bake": {
    "Bake Objects": tag("BO"),
  },
  "07 Trees": {
    "Clean Parallel": branched("CP"),
    "Create Tree": branched("CT"),
    "Duplicate Data Match": branched("DD"),
    "Get Matching Branches": branched("MB"),
    "Graft Parallel": branched("GP"),
    "Shift To Depth": branched("SD"),
    ShiftMatch: branched("SM"),
    "Shortest List Clean": branched("SL"),
  },
  "09 Files": {
    "Deconstruct FilePath": tag("FP"),
  },
};

export const dendro: Tab = {
  Boolean: {
    "Volume Difference": sets("VD"),
    "Volume Intersection": sets("VI"),
    "Volume Union": sets("VU"),
  },
  Convert: {
    "Curve to Volume": volume("CV"),
    "Mesh to Volume": volume("MV"),
    "Points To Volume": volume("PV"),
    "Volume to Mesh": volume("VM"),
  },
  Filters: {
    "Blend Volumes": volume("BV"),
    "Offset Volume": volume("OV"),
    "Smooth Volume": volume("SV"),
  },
  Parameters: {
    Volume: volume("Vo"),
    "Volume Settings": volume("VS"),
  },
  Settings: {
    "Create Settings": volume("CS"),
  },
};

export const jswan: Tab = {
  JSON: {
    "Deserialize Json": braces("DP"),
    "Deserialize Keys and Values": braces("DK"),
    "Merge Json": braces("ME"),
    "Serialize Json": braces("SP"),
    "Serialize Keys and Values": braces("SK"),
  },
};

export const colorplus: Tab = {
  Colour: {
    "Average Colors": swatch("AC"),
    "Colour Ole": swatch("CO"),
    "Invert Color": swatch("IC"),
    "To Hex": swatch("TH"),
    "To Ole": swatch("TO"),
    "Tween Colors": swatch("TC"),
  },
  Gradient: {
    "Construct Gradient": swatch("CG"),
  },
  Preview: {
    "Itemize Colors": swatch("It"),
    "Preview Colors": swatch("PC"),
  },
};

export const treesloth: Tab = {
  List: {
    "First/Last": list("FL"),
    "List Compare": list("LC"),
    "Sort Tree": branched("ST"),
    "Trim Data Ends": branched("TD"),
    Unweave: list("Un"),
  },
  Sequence: {
    "Cull Multiple": list("CM"),
  },
  Tree: {
    "Add Unmatched": branched("AU"),
    "Append Element": branched("AE"),
    "Clone Structure": branched("CS"),
    "Divide Branches": branched("DB"),
    "Explode at Index": branched("EI"),
    "Filter Unmatched": branched("FU"),
    "Flip Last": branched("FL"),
    "Isolate Unique Paths": branched("IU"),
    "Prepend Element": branched("PE"),
    "Renumber Paths": branched("RP"),
    "Shift Paths": branched("SP"),
    "Stack Trees": branched("Sk"),
  },
};
