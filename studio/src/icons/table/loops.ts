/** The pictures of components that begin and end loops. */

import { circle, line } from "../lines";
import { faint, hot, ink } from "../piece";
import { of } from "./plugins";
import type { Tab } from "./tab";

const begins = of([ink(circle(12, 12, 8)), hot(line(1, 12, 8, 12), line(5, 9, 8, 12, 5, 15))]);
const ends = of([ink(circle(12, 12, 8)), hot(line(16, 12, 23, 12), line(20, 9, 23, 12, 20, 15))]);
const snake = of([ink("M12 4A8 8 0 1 1 4 12"), hot(line(1, 15, 4, 12, 7, 15)), faint(circle(12, 12, 4))]);

export const anemone: Tab = {
  Classic: { "Loop End": ends("E"), "Loop Start": begins("S") },
  Fast: { "Fast Loop End": ends("FE"), "Fast Loop Start": begins("FS") },
};

export const hoopSnake: Tab = { Loop: { HoopSnake: snake("H") } };
