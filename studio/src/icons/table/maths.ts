/** The pictures of the Maths tab. */

import { arc, arrow, circle, dot, hotDot, hotSpeck, line, poly, rect, span, speck, turnArrow } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, fill, heat, hot, hotFill, ink, place, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

// Domains: a line between two brackets.
const bracket = (y: number, from = 3, to = 21): Drawing => ink(line(from, y - 4, from, y + 4), line(to, y - 4, to, y + 4), line(from, y, to, y));
const square = ink(rect(3, 3, 18, 18));
const smallSquare: Drawing = small(square);

// Matrices: two brackets and rows of dots.
const brackets = ink("M7 3H3V21H7", "M17 3H21V21H17");
const nine = speck(8, 7, 12, 7, 16, 7, 8, 12, 12, 12, 16, 12, 8, 17, 12, 17, 16, 17);

// Gates, after the signs of circuits.
const and = "M5 4H11C22 4 22 20 11 20H5Z";
const or = "M4 4C12 4 17 6 20 12C17 18 12 20 4 20C7.5 15 7.5 9 4 4Z";
const leads = ink(line(0.5, 8, 5, 8), line(0.5, 16, 5, 16));
const bubble = hot(circle(21, 12, 2));
const gate = (path: string, ...more: Drawing[]): Drawing => [shade(path), ink(path), leads, ...more];

// Graphs of functions below their names.
const trig = (name: string, curve: string): Drawing => [word(name, 12, 5.5, 6), faint(line(2, 16.5, 22, 16.5)), hot(curve)];

const triangle = ink(poly(3, 20, 21, 20, 9, 4));
const script = (letter: string): Drawing => [word("F", 6, 12, 11), word(letter, 16, 12, 11, hot)];
const plane: Drawing = [ink(line(4, 2, 4, 20, 22, 20))];
const early = (text: string): Drawing => [word("f", 12, 6, 8), word(text, 12, 17, 7, hot)];
const date: Drawing = s.calendar;
const smallDate = small(date);
// Values as bars.
const columns = (heights: readonly number[], tone: typeof fill): Drawing =>
  heights.map((height, k) => tone(rect(3 + k * 4, 21 - height, 2.5, height)));

export const maths: Tab = {
  Domain: {
    Bounds: [bracket(17), speck(7, 7, 10, 4, 13, 8, 18, 6), hot(line(3, 9, 3, 11), line(21, 9, 21, 11)), hotSpeck(3, 7, 21, 5)],
    "Bounds 2D": [dash(rect(3, 3, 18, 18)), speck(8, 8, 12, 14, 15, 10, 9, 17), hotDot(3, 14, 21, 8, 10, 3, 14, 21)],
    "Consecutive Domains": [ink(line(2, 8, 2, 16), line(8, 8, 8, 16), line(15, 8, 15, 16), line(22, 8, 22, 16), line(2, 12, 22, 12)), hot("M2 6C4 2 6 2 8 6", "M8 6C10 2 13 2 15 6", "M15 6C17 2 20 2 22 6")],
    "Construct Domain": [bracket(12), hotDot(3, 12, 21, 12)],
    "Construct Domain²": [square, hot(span(4, 12, 20, 12, 3), span(12, 4, 12, 20, 3)), hotDot(3, 21)],
    "Construct Domain² 9083b87f": [square, hotDot(3, 12, 21, 12, 12, 3, 12, 21)],
    "Deconstruct Domain": [bracket(7), hot(arrow(3, 13, 3, 21, 3), arrow(21, 13, 21, 21, 3))],
    "Deconstruct Domain² f0adfc96": [smallSquare, hot(span(2.5, 21, 15.5, 21, 2.5), span(21, 2.5, 21, 15.5, 2.5))],
    "Deconstruct Domain²": [smallSquare, hotDot(2.5, 21, 15.5, 21, 21, 2.5, 21, 15.5)],
    "Divide Domain": [bracket(12), hot(line(7.5, 9, 7.5, 15), line(12, 9, 12, 15), line(16.5, 9, 16.5, 15))],
    "Divide Domain²": [square, hot(line(9, 3, 9, 21), line(15, 3, 15, 21), line(3, 9, 21, 9), line(3, 15, 21, 15))],
    "Find Domain": [place(bracket(8, 2, 9), 0, 0), place(bracket(8, 9, 16), 0, 0), hotDot(12.5, 8), mark.lens],
    Includes: [bracket(16), hotDot(12, 16), hot(arrow(12, 3, 12, 12, 3.5))],
    "Remap Numbers": [place(bracket(5, 7, 17), 0, 0), bracket(19), hot(line(7, 9, 3, 15), line(17, 9, 21, 15)), dot(12, 5), hotDot(12, 19)],
  },
  Matrix: {
    "Construct Matrix": [brackets, heat(nine)],
    "Deconstruct Matrix": [small([brackets, nine]), mark.goesOut],
    "Display Matrix": [ink(rect(2, 4, 20, 16)), ink(line(2, 9, 22, 9), line(9, 4, 9, 20)), hot(line(2, 14.5, 22, 14.5), line(15.5, 4, 15.5, 20))],
    "Invert Matrix": [small([brackets, nine]), word("-1", 19, 5, 6, hot)],
    "Swap Columns": [brackets, speck(12, 7, 12, 12, 12, 17), hotSpeck(8, 7, 8, 12, 8, 17, 16, 7, 16, 12, 16, 17), hot(span(8, 2, 16, 2, 2.5))],
    "Swap Rows": [brackets, speck(8, 12, 12, 12, 16, 12), hotSpeck(8, 7, 12, 7, 16, 7, 8, 17, 12, 17, 16, 17), hot(span(21.5, 7, 21.5, 17, 2.5))],
    "Transpose Matrix": [brackets, speck(8, 7, 12, 12, 16, 17), hot(turnArrow(12, 12, 6, -60, -15, 3), turnArrow(12, 12, 6, 120, 165, 3))],
  },
  Operators: {
    Absolute: [ink(line(4, 4, 4, 20), line(20, 4, 20, 20)), word("x", 12, 11, 10, hot)],
    Addition: [hot(line(12, 3, 12, 21), line(3, 12, 21, 12)), dot(5, 5, 19, 19)],
    Division: [hot(line(3, 12, 21, 12)), dot(12, 5, 12, 19), ink(circle(12, 5, 1), circle(12, 19, 1))],
    Equality: [hot(line(4, 9, 20, 9), line(4, 15, 20, 15))],
    Factorial: [word("n", 8, 11, 12), word("!", 17, 12, 13, hot)],
    "Gate And": gate(and, hotDot(11, 12)),
    "Gate Majority": gate(and, word("2", 8.5, 12, 5, hot), word("3", 14, 12, 5, hot), ink(line(0.5, 12, 5, 12))),
    "Gate Nand": gate("M4 4H9C20 4 20 20 9 20H4Z", hot(circle(20, 12, 2.5))),
    "Gate Nor": gate(or, bubble),
    "Gate Not": [ink(line(0.5, 12, 5, 12)), shade(poly(5, 4, 18, 12, 5, 20)), ink(poly(5, 4, 18, 12, 5, 20)), hot(circle(20.5, 12, 2.5))],
    "Gate Or": gate(or),
    "Gate Xnor": gate(or, bubble, hot("M1 4C4.5 9 4.5 15 1 20")),
    "Gate Xor": gate(or, hot("M1 4C4.5 9 4.5 15 1 20")),
    "Integer Division": [word("5", 5, 7, 7), word("2", 19, 17, 7), hot(line(16, 3, 8, 21), line(19, 3, 11, 21))],
    "Larger Than": [hot(line(5, 4, 19, 12, 5, 20))],
    "Mass Addition": [hot("M18 6V3H5L12 12L5 21H18V18")],
    "Mass Multiplication": [hot("M3 4H21", "M7 4V21", "M17 4V21")],
    Modulus: [ink(line(18, 4, 6, 20)), hot(circle(7, 7, 3), circle(17, 17, 3))],
    Multiplication: [hot(line(5, 5, 19, 19), line(19, 5, 5, 19))],
    Negative: [hot(line(2, 12, 10, 12)), word("x", 17, 11, 10)],
    Power: [word("x", 8, 13, 12), word("n", 18, 5, 7, hot)],
    "Relative Differences": [ink(line(2, 20, 7, 14, 12, 17, 17, 7, 22, 4)), dot(7, 14, 12, 17, 17, 7), hot(span(20, 8, 20, 16, 2.5))],
    "Series Addition": [fill(rect(3, 16, 3, 5), rect(8.5, 12, 3, 9), rect(14, 8, 3, 13)), hotFill(rect(19, 3, 3, 18)), hot(line(3, 8, 9, 8), line(6, 5, 6, 11))],
    Similarity: [hot("M4 8C8 3 16 13 20 7", "M4 14C8 9 16 19 20 13"), faint(line(4, 20, 20, 20))],
    "Smaller Than": [hot(line(19, 4, 5, 12, 19, 20))],
    Subtraction: [hot(line(3, 12, 21, 12)), dot(5, 5, 19, 19)],
  },
  Polynomials: {
    Cube: [word("x", 8.5, 13, 13), word("³", 18.5, 7.5, 12, hot)],
    "Cube Root": [hot("M3 13L6 12L9 20L13 4H22"), word("3", 4.5, 5.5, 6, hot), word("x", 16.5, 13.5, 8)],
    "Log N": [word("log", 9, 10, 8), word("n", 19, 17, 6, hot)],
    Logarithm: [word("log", 9, 10, 8), word("1", 17.5, 18, 5, hot), word("0", 21, 18, 5, hot)],
    "Natural logarithm": [word("ln", 9, 10, 10), word("e", 19, 17, 6, hot)],
    "One Over X": [word("1", 12, 5.5, 7), hot(line(4, 12, 20, 12)), word("x", 12, 17, 9)],
    "Power of 10": [word("1", 4, 13, 10), word("0", 11, 13, 10), word("x", 20, 4.5, 7, hot)],
    "Power of 2": [word("2", 8, 13, 12), word("x", 18, 5, 8, hot)],
    "Power of E": [word("e", 8, 12, 13), word("x", 18, 5, 8, hot)],
    Square: [word("x", 8.5, 13, 13), word("²", 18.5, 7.5, 12, hot)],
    "Square Root": [hot("M2 13L5 12L9 20L13 4H22"), word("x", 16.5, 13.5, 8)],
  },
  Script: {
    "Eval [OBSOLETE]": early("x"),
    "Evaluate Expression [OBSOLETE]": early("="),
    "F(a,b,c,d) [OBSOLETE]": early("abc"),
    "F(x) [OBSOLETE]": early("(x)"),
    "F(x,y) [OBSOLETE]": early("xy"),
    "F(x,y,z) [OBSOLETE]": early("xyz"),
    Evaluate: [word("f", 5, 10, 11), word("=", 13, 11, 9, hot), word("?", 20, 11, 9)],
    Expression: [word("x", 5, 11, 9), hot(line(9.5, 12, 14.5, 12), line(12, 9.5, 12, 14.5)), word("y", 19, 11, 9)],
    F1: script("1"),
    F2: script("2"),
    F3: script("3"),
    F4: script("4"),
    F5: script("5"),
    F6: script("6"),
    F7: script("7"),
    F8: script("8"),
    Variable: [ink(rect(3, 3, 18, 18)), word("x", 12, 11, 11, hot)],
  },
  Time: {
    "Combine Date & Time": [small(date), place(heat(s.clock), 10.5, 10.5, 0.55)],
    "Construct Date": [date, hot(line(12, 12, 12, 19), line(8.5, 15.5, 15.5, 15.5))],
    "Construct Exotic Date": [date, shade(rect(3, 10, 18, 11)), hotFill("M13 11A5 5 0 1 0 16.5 18.5A5 5 0 0 1 13 11Z")],
    "Construct Smooth Time": [ink(circle(12, 12, 9)), hot("M12 12L12 5A7 7 0 0 1 18.5 9.5Z"), tint("M12 12L12 5A7 7 0 0 1 18.5 9.5Z"), dot(12, 12)],
    "Construct Time": [small(s.clock), mark.plus],
    "Date Range": [ink(rect(2, 4, 8, 8), rect(14, 4, 8, 8)), fill(rect(2, 4, 8, 2.5), rect(14, 4, 8, 2.5)), hot(span(3, 18, 21, 18, 3)), hotSpeck(9, 18, 15, 18)],
    "Deconstruct Date": [smallDate, mark.goesOut],
    "Interpolate Date": [ink(rect(2, 4, 8, 8), rect(14, 4, 8, 8)), fill(rect(2, 4, 8, 2.5), rect(14, 4, 8, 2.5)), hot(line(3, 19, 21, 19)), hotDot(12, 19)],
  },
  Trig: {
    ArcCosine: trig("acos", "M6 10C6 14 12 16 12 16.5S18 19 18 23"),
    ArcSine: trig("asin", "M18 10C18 14 12 16 12 16.5S6 19 6 23"),
    ArcTangent: trig("atan", "M2 21C11 21 9 16.5 12 16.5S13 12 22 12"),
    Centroid: [triangle, faint(line(3, 20, 15, 12), line(21, 20, 6, 12), line(9, 4, 12, 20)), hotDot(11, 14.7)],
    Circumcentre: [ink(circle(12, 12, 9.5)), ink(poly(4, 17, 20, 17, 9, 3)), hotDot(12, 12)],
    CoSecant: trig("csc", "M4 11C4 14.5 8 14.5 9.5 14.5S11.5 13 11.5 11M12.5 22C12.5 18.5 16 18.5 17 18.5S20 20 20 22"),
    CoTangent: trig("cot", "M4 11C4 16 6 16.5 7.5 16.5S11 17 11 22M13 11C13 16 15 16.5 16.5 16.5S20 17 20 22"),
    Cosine: trig("cos", "M2 11.5C6 11.5 8 21.5 12 21.5S18 11.5 22 11.5"),
    Degrees: [ink(line(20, 5, 3, 19, 21, 19)), hot(arc(3, 19, 9, -39, 0)), word("°", 20, 13, 14, hot)],
    Incentre: [triangle, hot(circle(11, 14.5, 5)), hotDot(11, 14.5)],
    Orthocentre: [triangle, faint(line(9, 4, 9, 20), line(3, 20, 16, 13), line(21, 20, 6, 12)), hotDot(9, 15.5)],
    Radians: [ink(line(20, 5, 3, 19, 21, 19)), hot(arc(3, 19, 9, -39, 0)), word("π", 18, 12.5, 7, hot)],
    "Right Trigonometry": [ink(poly(4, 20, 20, 20, 4, 4)), hot("M4 15H9V20"), hot(arc(20, 20, 5, 180, 225))],
    Secant: trig("sec", "M8 11C8 14.5 10.5 14.5 12 14.5S16 14.5 16 11M2 19C5 19 5.5 20 5.5 23M22 19C19 19 18.5 20 18.5 23"),
    Sinc: trig("sinc", "M2 17C4 15.5 5.5 18.5 7.5 18S10 10 12 10S14.5 18 16.5 18S20 15.5 22 17"),
    Sine: trig("sin", "M2 16.5C5 9 8 9 12 16.5S19 24 22 16.5"),
    Tangent: trig("tan", "M3 23C5 17 6.5 16.5 7.5 16.5S10 16 11.5 10M12.5 23C14 17 15.5 16.5 16.5 16.5S19 16 21 10"),
    "Triangle Trigonometry": [triangle, hot(arc(3, 20, 5, -69, 0), arc(21, 20, 5, 180, 232), arc(9, 4, 5, 53, 110))],
  },
  Util: {
    Average: [columns([6, 14, 9, 17, 11], fill), hot(line(2, 10, 23, 10))],
    "Blur Numbers": [columns([6, 14, 9, 17, 11], shade), hot("M3 15C6 6 9 14 12 11S18 4 22 10"), faint(line(2, 21, 22, 21))],
    "Complex Argument": [plane, ink(arrow(4, 20, 18, 6)), hot(arc(4, 20, 9, -45, 0))],
    "Complex Components": [plane, dot(17, 7), hot(line(17, 7, 17, 20), line(17, 7, 4, 7))],
    "Complex Conjugate": [faint(line(3, 3, 3, 21), line(3, 12, 22, 12)), ink(arrow(3, 12, 18, 4, 3)), hot(arrow(3, 12, 18, 20, 3))],
    "Complex Modulus": [plane, hot(span(4, 20, 19, 5, 3.5)), dot(19, 5)],
    "Create Complex": [plane, faint(line(17, 7, 17, 20), line(17, 7, 4, 7)), hotDot(17, 7), word("i", 9, 13, 7, hot)],
    Epsilon: [word("ε", 12, 10, 16, hot)],
    Extremes: [columns([6, 0, 9, 0, 11], fill), hotFill(rect(7, 18, 2.5, 3), rect(15, 3, 2.5, 18))],
    "Golden Ratio": [word("φ", 12, 9, 13, hot)],
    "Interpolate data": [ink(line(4, 18, 20, 6)), dot(4, 18, 20, 6), hotDot(13, 11.25), dash(line(13, 12, 13, 22))],
    Maximum: [columns([6, 14, 9, 0, 11], fill), hotFill(rect(15, 3, 2.5, 18)), hot(line(10, 3, 22, 3))],
    Minimum: [columns([0, 14, 9, 17, 11], fill), hotFill(rect(3, 16, 2.5, 5)), hot(line(2, 16, 12, 16))],
    "Natural logarithm": [word("e", 12, 10, 15, hot)],
    Pi: [word("π", 12, 9, 15, hot)],
    Round: [ink(line(3, 20, 3, 15, 9, 15, 9, 10, 15, 10, 15, 5, 21, 5)), hot("M3 20L21 3")],
    "Smooth Numbers": [ink(line(2, 15, 6, 7, 9, 17, 13, 6, 16, 15, 19, 6, 22, 10)), hot("M2 20C8 21 14 16 22 17")],
    Truncate: [columns([0, 9, 11, 14, 0], fill), faint(rect(3, 15, 2.5, 6), rect(19, 4, 2.5, 17)), hot(line(1.5, 13, 7, 22), line(17, 13, 23, 22))],
    "Weighted Average": [ink(line(3, 9, 21, 9), line(12, 9, 12, 21), line(8, 21, 16, 21)), ink(rect(3, 5, 4, 4)), hotFill(rect(14, 1.5, 7, 7.5))],
  },
};

export const scalar: Tab = {
  Util: { Mean: [faint(line(2, 20, 22, 20)), speck(5, 16, 9, 8, 15, 14, 19, 5), hot(line(2, 11, 22, 11))] },
};