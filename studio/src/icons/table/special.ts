/** The pictures of what is not in the tabs: notes and groups on the canvas, clusters, scripts, and what is not known. */

import { arrow, circle, hotDot, line, rect } from "../lines";
import { word } from "../letters";
import { dash, hot, ink, tint, type Drawing } from "../piece";

const chevrons: Drawing = ink(line(6, 4, 2, 8, 6, 12), line(14, 4, 18, 8, 14, 12));
const script = (letters: string): Drawing => [chevrons, word(letters, 14, 18.5, 7, hot)];

export const special: Readonly<Record<string, Drawing>> = {
  Group: [dash(rect(2, 3, 20, 18)), ink(circle(8.5, 9, 3)), tint(rect(12, 11, 7, 7)), ink(rect(12, 11, 7, 7))],
  Scribble: [hot("M2 18C4 8 8 8 7 14S12 18 13 12S18 8 17 14S19 17 22 14"), ink(line(3, 21.5, 21, 21.5))],
  Sketch: [ink("M4 20L5 15L17 3L21 7L9 19Z", line(14, 6, 18, 10)), hot("M12 21C15 18 18 24 21 20")],
  Cluster: [ink(rect(2, 2, 15, 15)), tint(rect(7, 7, 15, 15)), hot(rect(7, 7, 15, 15)), hot(line(11, 12, 18, 12), line(11, 17, 18, 17))],
  Script: script("{}"),
  "C# Script": script("C#"),
  "DotNET C# Script (LEGACY)": script("C#"),
  "VB Script": script("VB"),
  "DotNET VB Script (LEGACY)": script("VB"),
  "GhPython Script": script("Py"),
  "Python 3 Script": script("P3"),
  "IronPython 2 Script": script("P2"),
  Exponential: [word("e", 8, 12, 13), word("x", 18, 5, 8, hot)],
};

/** What has no picture of its own, such as the components of add-ons: a piece that is missing here. */
export const unknown: Drawing = [ink("M4 8H9C7 2 15 2 13 8H19V13C25 11 25 20 19 18V22H4Z"), hot(arrow(8, 15, 13.5, 15, 3)), hotDot(8, 15)];
