/** The pictures of the Rhino tab. */

import { arrow, circle, hotDot, hotSpeck, line, rect } from "../lines";
import { word } from "../letters";
import * as mark from "../marks";
import { dash, faint, hot, hotFill, ink, small, tint, type Drawing } from "../piece";
import * as s from "../shapes";
import type { Tab } from "./tab";

const card: Drawing = [ink(rect(2, 3, 20, 18)), ink(line(2, 8, 22, 8))];
const smallCard = small(card);
const funnel: Drawing = ink("M2 3H18L12 10V16L8 18V10Z");

export const rhino: Tab = {
  Annotation: {
    Leader: [ink(line(4, 19, 11, 9, 21, 9)), hot(line(4, 13, 4, 19, 10, 18)), word("A", 17.5, 4, 5.5, hot)],
  },
  Block: {
    "Explode Block Instance": [ink(rect(8, 8, 8, 8)), hot(arrow(7, 7, 2, 2, 3), arrow(17, 7, 22, 2, 3), arrow(7, 17, 2, 22, 3), arrow(17, 17, 22, 22, 3))],
    "Import Model Block Definition": [ink(rect(2, 2, 14, 14)), tint(rect(5, 5, 4, 4)), hot(rect(5, 5, 4, 4)), ink(circle(11.5, 11.5, 2)), mark.tray],
    "Model Block Instance": [dash(rect(2, 2, 20, 20)), tint(rect(5, 5, 6, 6)), hot(rect(5, 5, 6, 6)), ink(circle(16, 16, 3.5)), hot(line(2, 22, 7, 17))],
  },
  Content: {
    "Contains Text Filter": [funnel, word("a", 18.5, 19, 8, hot)],
    "Content Details": [smallCard, mark.sorts],
    "Equality Filter": [funnel, mark.equals],
    "Filter Content": [funnel, hotDot(10, 22), faint(line(17, 13, 22, 13), line(17, 18, 22, 18))],
    "Group Content": [dash(rect(2, 2, 20, 20)), ink(rect(5, 5, 6, 5), rect(13, 7, 6, 5)), tint(rect(8, 14, 7, 5)), hot(rect(8, 14, 7, 5))],
    "Intersection Filter": [funnel, hot(circle(16.5, 19, 3.5), circle(20, 19, 3.5))],
    "User Text": [card, word("k", 5, 14, 6), ink(line(4, 12, 4, 17, 7, 17)), hot(line(10, 14.5, 14, 14.5)), hot(line(17, 12, 20, 12), line(17, 17, 20, 17)), hotSpeck(12, 11, 12, 18)],
  },
  Linetype: {
    Linetype: [ink(line(2, 6, 22, 6)), dash(line(2, 12, 22, 12)), hot(line(2, 18, 8, 18), line(11, 18, 13, 18), line(16, 18, 22, 18))],
    "Model Linetype": [small([ink(line(2, 5, 22, 5)), ink(line(2, 12, 8, 12), line(12, 12, 14, 12), line(18, 12, 22, 12)), ink(line(2, 19, 6, 19), line(10, 19, 14, 19))]), mark.plus],
  },
  Object: {
    "Model Object": [s.box, hotFill(circle(19, 19, 3.5)), tint(s.boxTop)],
    "Query Model Objects": [small(s.bareBox), mark.lens],
  },
};
