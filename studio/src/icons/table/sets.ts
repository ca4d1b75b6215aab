/** The pictures of the Sets tab. */

import { arrow, circle, dot, ellipse, head, hotDot, hotSpeck, line, rect, span, speck, turnArrow } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, fill, hot, hotFill, ink, place, shade, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

const { cells } = s;

/** A cross over a cell of a column of four. */
const crossed = (x: number, k: number): Drawing => hot(line(x, 2 + 5 * k, x + 5, 7 + 5 * k), line(x + 5, 2 + 5 * k, x, 7 + 5 * k));

// Sets are two rings that overlap.
const rings = ink(s.LEFT_RING, s.RIGHT_RING);
// A tree that leaves the lower right corner to a mark.
const smallTree: Drawing = [ink(line(2, 9, 6, 9), "M6 9C9 9 7 4 11 4H15", "M6 9H15", "M6 9C9 9 7 14 11 14H13"), dot(16, 4, 16, 9)];
// A path of a tree, between braces.
const braces = (inside: Drawing): Drawing => [word("{", 3.5, 12, 15), word("}", 20.5, 12, 15), inside];
const smallBraces = (inside: string): Drawing => [word("{", 2.5, 9, 11), word("}", 15.5, 9, 11), word(inside, 9, 9, 5.5)];
const die: Drawing = [shade(rect(4, 4, 16, 16)), ink(rect(4, 4, 16, 16))];
const quoted = (text: string, y = 12, height = 8): Drawing => word(text, 12, y, height);

export const sets: Tab = {
  List: {
    "Combine Data": [cells(1, 3, [0], 5), faint(line(2, 13, 5, 16), line(5, 13, 2, 16), line(2, 18, 5, 15)), cells(8, 3, [1, 2], 5), hot(arrow(14, 12, 17.5, 12, 2.5)), cells(18.5, 3, [0, 1, 2], 5)],
    "Cross Reference": [dot(4, 5, 4, 12, 4, 19, 20, 5, 20, 12, 20, 19), hot(line(4, 5, 20, 5), line(4, 5, 20, 12), line(4, 5, 20, 19)), faint(line(4, 12, 20, 5), line(4, 12, 20, 12), line(4, 12, 20, 19), line(4, 19, 20, 5), line(4, 19, 20, 12), line(4, 19, 20, 19))],
    Dispatch: [cells(2, 4, [0, 2], 5), hot(arrow(8, 8, 15, 5, 3)), ink(arrow(8, 16, 15, 19, 3)), hotFill(rect(17, 2, 5, 5)), ink(rect(17, 17, 5, 5))],
    "Insert Items": [cells(14, 2, [], 5, 2), cells(14, 2, [], 5, 17).slice(0, 1), faint(rect(14, 12, 5, 5)), hotFill(rect(3, 11.5, 5, 5)), hot(arrow(8, 14, 14, 14, 3.5))],
    "Item Index": [cells(3, 4, [2], 5), word("2", 17, 12, 10, hot), hot(arrow(9, 14.5, 13, 13, 2.5))],
    "List Item": [cells(3, 4, [1], 5), hot(arrow(9, 9.5, 21, 9.5))],
    "List Length": [cells(5, 4, [], 5), hot(span(16, 2.5, 16, 21.5, 3), line(13, 2, 19, 2), line(13, 22, 19, 22))],
    "Longest List": [cells(4, 4, [0, 1, 2, 3], 5), cells(14, 2, [], 5, 2), dash(rect(14, 12, 5, 10))],
    "Null Item": [cells(2, 3, [], 5, 1), hot(circle(17, 17, 5), line(13.5, 20.5, 20.5, 13.5)), ink(line(10, 3.5, 18, 3.5))],
    "Partition List": [cells(2, 4, [], 5), hot(arrow(8, 7, 13, 5, 2.5), arrow(8, 17, 13, 19, 2.5)), cells(16, 2, [0, 1], 4, 1), cells(16, 2, [0, 1], 4, 15)],
    "Pick'n'Choose": [cells(1, 2, [0], 5, 1), cells(1, 2, [1], 5, 13), hot("M7 3.5H11L11 12M7 20.5H11V12", arrow(11, 12, 15.5, 12, 3)), cells(17, 4, [0, 3], 5)],
    "Replace Items": [cells(3, 4, [2], 5), hot(turnArrow(15, 12, 5.5, -60, 60, 3.5)), hotFill(rect(12, 2, 5, 5))],
    "Replace Nulls": [cells(3, 4, [], 5), crossed(3, 2), hot(arrow(20, 14.5, 10, 14.5, 3.5)), hotFill(rect(16, 4, 5, 5))],
    "Reverse List": [cells(3, 4, [], 5), hot(arrow(12.5, 3, 12.5, 21, 3.5), arrow(18.5, 21, 18.5, 3, 3.5))],
    "Shift List": [cells(3, 4, [3], 5), hot("M8 19.5H14C20 19.5 20 4.5 14 4.5H11", head(10.5, 4.5, -1, 0, 3.5))],
    "Shortest List": [cells(4, 2, [0, 1], 5, 2), cells(14, 4, [], 5), hot(line(1, 13, 23, 13))],
    "Sift Pattern": [cells(2, 4, [0, 2], 5), hot(line(8, 4.5, 14, 4.5), line(8, 14.5, 14, 14.5)), cells(15, 4, [0, 2], 5).slice(0, 1), cells(15, 1, [0], 5, 12), faint(rect(15, 7, 5, 5), rect(15, 17, 5, 5))],
    "Sort List": [ink(line(3, 4, 8, 4), line(3, 9, 11, 9), line(3, 14, 14, 14), line(3, 19, 17, 19)), hot(arrow(20, 3, 20, 16, 3.5))],
    "Split List": [cells(4, 2, [], 5, 1), cells(4, 2, [0, 1], 5, 13), hot(line(2, 12, 10, 12)), hot(arrow(12, 12, 18, 6, 3), arrow(12, 12, 18, 18, 3))],
    "Sub List": [cells(4, 4, [1, 2], 5), hot("M13 7H16V17H13", arrow(16, 12, 22, 12, 3))],
    Weave: [hotFill(rect(2, 2, 5, 5)), ink(rect(2, 17, 5, 5)), hot(arrow(8, 6, 14, 9, 3)), ink(arrow(8, 18, 14, 15, 3)), cells(16, 4, [0, 2], 5)],
  },
  Sequence: {
    "Char Sequence": [word("A", 4, 12, 7), word("B", 12, 12, 7), word("C", 20, 12, 7), hot(arrow(3, 20, 21, 20, 3))],
    "Cull Index": [cells(3, 4, [], 5), crossed(3, 2), word("2", 17, 14.5, 9, hot)],
    "Cull Nth": [cells(3, 4, [], 5), crossed(3, 1), crossed(3, 3), word("n", 17, 12, 10, hot)],
    "Cull Pattern": [cells(2, 4, [], 5), crossed(2, 1), crossed(2, 3), hot(line(12, 4.5, 14, 6.5, 18, 2.5), line(12, 14.5, 14, 16.5, 18, 12.5)), ink(line(13, 8, 16, 11), line(16, 8, 13, 11), line(13, 18, 16, 21), line(16, 18, 13, 21))],
    "Duplicate Data": [cells(3, 2, [], 5, 7), hot(arrow(9, 12, 14, 12, 3)), cells(16, 2, [0, 1], 5, 1), cells(16, 2, [0, 1], 5, 13)],
    "Duplicate data [OBSOLETE]": [cells(3, 1, []), hot(arrow(9, 12, 14, 12, 3)), cells(16, 4, [0, 1, 2, 3], 5)],
    Fibonacci: [ink(rect(2, 5, 20, 14), line(15, 5, 15, 19), line(15, 11, 22, 11)), hot("M2 19C2 10 8 5 15 5C19 5 22 7 22 11C22 14 20 15 18 15")],
    Jitter: [ink(line(3, 6, 21, 6), line(3, 18, 21, 18)), hotDot(5, 12, 11, 10, 13.5, 14.5, 19, 12), dot(5, 6, 10, 6, 14, 6, 19, 6), faint(line(5, 6, 11, 10), line(10, 6, 5, 12), line(14, 6, 19, 12), line(19, 6, 13.5, 14.5))],
    Random: [die, hotDot(8.5, 8.5, 15.5, 15.5, 15.5, 8.5, 8.5, 15.5, 12, 12)],
    "Random Reduce": [small([shade(rect(2, 2, 18, 18)), ink(rect(2, 2, 18, 18)), dot(7, 7, 15, 15)]), mark.minus],
    RandomEx: [small([shade(rect(2, 2, 18, 18)), ink(rect(2, 2, 18, 18)), dot(7, 7, 15, 15)]), word("1", 17, 19, 7, hot), word("2", 21.5, 19, 7, hot)],
    Range: [ink(line(3, 12, 21, 12), line(3, 6, 3, 18), line(21, 6, 21, 18)), hotDot(7.5, 12, 12, 12, 16.5, 12)],
    "Repeat Data": [cells(3, 2, [0], 5, 2), faint(line(1, 12, 10, 12)), cells(3, 2, [0], 5, 12), hot(turnArrow(15, 12, 6, -80, 150, 3.5))],
    Sequence: [fill(rect(3, 17, 3, 4), rect(8, 15, 3, 6), rect(13, 10, 3, 11)), hotFill(rect(18, 3, 3, 18)), hot("M4 13C6 8 8 8 10 11", head(10, 11, 0.6, 1, 3))],
    Series: [fill(rect(3, 18, 3, 3), rect(8, 14, 3, 7), rect(13, 10, 3, 11), rect(18, 6, 3, 15)), hot(line(3, 14, 16, 3))],
    "Split [OBSOLETE]": [cells(4, 2, [], 5, 1), cells(4, 2, [], 5, 13), hot(line(2, 12, 20, 12))],
    "Stack Data": [ink(rect(3, 2, 5, 5), rect(3, 9, 5, 5), rect(3, 16, 5, 5)), hotFill(rect(11, 2.5, 4, 4), rect(17, 2.5, 4, 4), rect(11, 9.5, 4, 4), rect(11, 16.5, 4, 4), rect(17, 16.5, 4, 4))],
  },
  Sets: {
    "Carthesian Product": [dot(4, 8, 4, 16, 8, 20, 16, 20), ink(line(4, 4, 4, 20, 20, 20)), hotDot(9, 8, 15, 8, 9, 15, 15, 15)],
    "Create Set": [speck(2, 4, 7, 4, 2, 12, 7, 12, 2, 20, 7, 20), hot(arrow(9, 12, 12.5, 12, 2.5)), ink(ellipse(18.5, 12, 4.5, 9)), hotDot(18.5, 7.5, 18.5, 16.5)],
    "Delete Consecutive": [cells(3, 4, [1], 5), crossed(3, 2), hot("M12 9.5C17 9.5 17 14.5 12 14.5", line(16, 12, 21, 12))],
    Disjoint: [ink(circle(6.5, 12, 5), circle(17.5, 12, 5)), hot(line(12, 4, 12, 20))],
    "Find similar member": [speck(4, 5, 11, 4, 5, 12), hotDot(11, 10), hot(circle(11, 10, 5)), hot(line(15, 14, 21, 20))],
    "Key/Value Search": [ink(circle(6.5, 8, 4), line(10.5, 8, 21, 8, 21, 12), line(17, 8, 17, 11)), hot(circle(12, 17, 3), line(14.5, 19, 18, 22))],
    "Member Index": [ink(ellipse(7.5, 12, 5.5, 9)), dot(7.5, 7), hotDot(7.5, 15), hot(arrow(11, 15, 15, 15, 2.5)), word("1", 19.5, 15, 8, hot)],
    "Replace Members": [ink(ellipse(8, 12, 6, 9)), dot(8, 7), hotDot(8, 16), hot(arrow(21, 16, 13, 16, 3.5)), hotDot(20, 8)],
    "Set Difference": [hotFill(s.LEFT_MOON), rings],
    "Set Difference (S)": [hotFill(s.LEFT_MOON, s.RIGHT_MOON), rings],
    "Set Intersection": [hotFill(s.LENS), rings],
    "Set Majority": [tint("M12 12.5C8 10 8 6 12 4.5C16 6 16 10 12 12.5ZM12 12.5C12 17 8.5 19 6 16.5C5.5 12.5 9 10.5 12 12.5ZM12 12.5C12 17 15.5 19 18 16.5C18.5 12.5 15 10.5 12 12.5Z"), ink(circle(8.5, 9, 5.5), circle(15.5, 9, 5.5), circle(12, 15.5, 5.5))],
    "Set Union": [hotFill(s.BOTH_RINGS), rings],
    SubSet: [ink(circle(12, 12, 9.5)), tint(circle(14, 13, 4.5)), hot(circle(14, 13, 4.5))],
  },
  Text: {
    Characters: [ink(rect(2, 7, 6, 10), rect(9, 7, 6, 10), rect(16, 7, 6, 10)), word("a", 5, 11, 5, hot), word("b", 12, 11, 5, hot), word("c", 19, 11, 5, hot)],
    Concatenate: [word("a", 5, 11, 9), word("b", 19, 11, 9), hot(line(9.5, 12, 14.5, 12), line(12, 9.5, 12, 14.5))],
    Format: [word("{", 5, 12, 15), word("}", 19, 12, 15), word("0", 12, 12, 9, hot)],
    "Match Text": [quoted("ab", 7, 8), hot(line(4, 18, 8, 21.5, 20, 14))],
    "Replace Text": [word("a", 4.5, 11, 9), hot(arrow(9, 12, 15, 12)), word("b", 19.5, 11, 9, hot)],
    "Sort Text": [word("A", 5, 6, 7), word("Z", 5, 18, 7), hot(arrow(15, 3, 15, 21, 4))],
    "Text Case": [word("A", 7, 12, 13), word("a", 18, 11.5, 11, hot)],
    "Text Distance": [word("a", 4.5, 8, 8), word("b", 19.5, 8, 8), hot(line(3, 15, 3, 21), line(21, 15, 21, 21), span(3.5, 18, 20.5, 18, 3))],
    "Text Fragment": [faint(line(2, 20, 22, 20)), word("a", 3.5, 10, 7), word("b", 12, 10, 7, hot), word("c", 20.5, 10, 7), hot(rect(7.5, 4, 9, 13))],
    "Text Join": [word("a", 3.5, 7, 7), word("b", 12, 7, 7), word("c", 20.5, 7, 7), hot("M3 13V18H21V13", line(12, 13, 12, 18), line(12, 18, 12, 22))],
    "Text Length": [ink("M6 4H18", "M12 4V14"), hot(line(3, 17, 3, 23), line(21, 17, 21, 23), span(3.5, 20, 20.5, 20, 3))],
    "Text On Surface": [place(s.sheet, 0, 3, 1), word("A", 12, 7, 11, hot)],
    "Text Split": [word("a", 4.5, 8, 8), word("b", 19.5, 8, 8), hot(line(12, 3, 12, 14)), hot(arrow(10, 19, 3, 19, 3), arrow(14, 19, 21, 19, 3))],
    "Text Trim": [word("a", 9, 11, 8), word("b", 15.5, 11, 8), hot(line(4, 4, 4, 20), line(20, 4, 20, 20)), faint(line(1, 12, 1, 12.1), line(23, 12, 23, 12.1)), hotSpeck(1.5, 16, 22.5, 16)],
  },
  Tree: {
    "Clean Tree": [smallTree, hot("M21 12L17 17", "M14 17L20 22", "M15 16C17 15 20 17 21 20L18 23L12 19Z")],
    "Construct Path": braces([word("0", 9, 12, 6, hot), word("1", 15, 12, 6, hot), hotSpeck(12, 16)]),
    "Deconstruct Path": [smallBraces("01"), mark.goesOut],
    Entwine: [ink("M2 5H6C10 5 9 10 13 10H16", "M2 12H16", "M2 19H6C10 19 9 14 13 14H16"), hot(rect(16, 8, 6, 8)), hotFill(rect(18, 10, 2, 4))],
    "Explode Tree": [ink(line(2, 12, 6, 12), "M6 12C9 12 8 4 11 4", "M6 12H11", "M6 12C9 12 8 20 11 20"), hot(arrow(14, 4, 22, 4, 3), arrow(14, 12, 22, 12, 3), arrow(14, 20, 22, 20, 3))],
    "Flatten Tree": [ink(line(2, 4, 2, 20), line(2, 4, 6, 4), line(2, 12, 6, 12), line(2, 20, 6, 20)), hot(arrow(8, 12, 14, 12, 3)), cells(17, 4, [0, 1, 2, 3], 5)],
    "Flip Matrix": [ink(rect(2, 2, 14, 14), line(2, 9, 16, 9), line(9, 2, 9, 16)), hotFill(rect(3.5, 10.5, 4, 4), rect(10.5, 3.5, 4, 4)), hot("M19 9C22 14 19 20 11 20", head(10.5, 20, -1, 0, 3.5))],
    "Graft Tree": [cells(2, 4, [0, 1, 2, 3], 5), hot(line(8, 4.5, 14, 4.5), line(8, 9.5, 14, 9.5), line(8, 14.5, 14, 14.5), line(8, 19.5, 14, 19.5)), ink(line(14, 4.5, 20, 4.5), line(14, 9.5, 20, 9.5), line(14, 14.5, 20, 14.5), line(14, 19.5, 20, 19.5)), hotDot(21, 4.5, 21, 9.5, 21, 14.5, 21, 19.5)],
    "Match Tree": [smallTree, mark.equals],
    Merge: [ink("M2 5H7C12 5 10 12 15 12", "M2 12H15", "M2 19H7C12 19 10 12 15 12"), hot(arrow(14, 12, 22, 12, 4))],
    "Null Check": [hot(circle(10, 10, 7), line(5, 15, 15, 5)), ink(line(15, 18, 18, 21, 22.5, 14.5))],
    "Path Compare": [smallBraces("01"), mark.ask],
    "Path Mapper": [word("{", 2.5, 12, 10), word("}", 8, 12, 10), word("{", 16, 12, 10), word("}", 21.5, 12, 10), speck(5.25, 12), hotSpeck(18.7, 10, 18.7, 14), hot(arrow(10, 12, 14, 12, 2.5))],
    "Prune Tree": [ink(line(3, 12, 8, 12), "M8 12C12 12 10 5 14 5H18", "M8 12H18"), dot(20, 5, 20, 12), faint("M8 12C12 12 10 19 14 19H19"), hot(line(12, 15, 20, 23), line(20, 15, 12, 23))],
    "Relative Item": [smallTree, dot(13, 19), hot(arrow(15.5, 19, 22, 19, 3))],
    "Relative Items": [smallTree, hotDot(14, 19, 21, 19), hot("M14 17C15 13 20 13 21 16")],
    "Replace Paths": [smallBraces("01"), mark.reverses],
    "Shift Paths": [ink(line(2, 6, 6, 6), line(2, 12, 6, 12), line(2, 18, 6, 18)), dash(line(8, 3, 8, 21)), hot(arrow(22, 12, 12, 12)), dot(14, 6, 14, 18)],
    "Simplify Tree": [word("{", 2.5, 8, 11), word("}", 21.5, 8, 11), faint(line(6, 4, 11, 12), line(11, 4, 6, 12)), word("1", 15.5, 8, 7, hot), hot(arrow(18, 19, 6, 19, 3.5))],
    "Split Tree": [ink(line(2, 12, 6, 12), "M6 12C10 12 8 5 12 5H14", "M6 12C10 12 8 19 12 19H14"), hotDot(19, 5), ink(circle(19, 19, 2)), hot(line(11, 12, 22, 12))],
    "Stream Filter": [ink(line(2, 5, 9, 5), line(2, 19, 9, 19)), faint(line(9, 19, 14, 12)), hot(line(9, 5, 14, 12), arrow(14, 12, 22, 12)), dot(9, 5, 9, 19)],
    "Stream Gate": [ink(line(22, 5, 15, 5), line(22, 19, 15, 19)), faint(line(15, 19, 10, 12)), hot(line(2, 12, 10, 12, 15, 5)), dot(15, 5, 15, 19), hotDot(10, 12)],
    "Tree Branch": [faint(line(3, 12, 8, 12), "M8 12H19", "M8 12C12 12 10 19 14 19H19"), hot("M3 12H8C12 12 10 5 14 5H18"), hotDot(20, 5)],
    "Tree Item": [ink(line(3, 12, 7, 12), "M7 12C11 12 9 5 13 5H14", "M7 12H14", "M7 12C11 12 9 19 13 19H14"), dot(17, 5, 21, 5, 17, 12, 17, 19, 21, 19), hotDot(21, 12), hot(circle(21, 12, 2.5))],
    "Tree Statistics": [smallTree, mark.bars],
    "Trim Tree": [ink(line(2, 12, 6, 12), "M6 12C10 12 8 6 11 6H13", "M6 12C10 12 8 18 11 18H13"), faint("M13 6C17 6 16 3 20 3", "M13 6C17 6 16 9 20 9", "M13 18C17 18 16 15 20 15", "M13 18C17 18 16 21 20 21"), hot(line(15, 2, 15, 22))],
    "Unflatten Tree": [cells(2, 4, [0, 1, 2, 3], 5), hot(arrow(8.5, 12, 13, 12, 3)), ink(line(22, 4, 22, 20), line(22, 4, 17, 4), line(22, 12, 17, 12), line(22, 20, 17, 20)), hotSpeck(16, 4, 16, 12, 16, 20)],
  },
};