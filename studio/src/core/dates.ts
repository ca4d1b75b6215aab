/** Days of the Gregorian calendar and times of the day, as calendars and clocks of the canvas have them. */

/** Year, month (1 to 12) and day. */
export type Day = readonly [number, number, number];

/** The years that there are. */
const YEARS = [1, 9999] as const;
export const DAY_SECONDS = 86_400;

/** The last day of a month. */
export function daysIn(year: number, month: number): number {
  if (month === 2) return year % 4 === 0 && (year % 100 !== 0 || year % 400 === 0) ? 29 : 28;
  return [4, 6, 9, 11].includes(month) ? 30 : 31;
}

/** The day of the week, 0 for Monday, by Zeller's congruence. */
export function weekday([year, month, day]: Day): number {
  // January and February count as the last months of the year before.
  const [y, m] = month < 3 ? [year - 1, month + 12] : [year, month];
  const saturdayFirst = (day + Math.floor((13 * (m + 1)) / 5) + y + Math.floor(y / 4) - Math.floor(y / 100) + Math.floor(y / 400)) % 7;
  return (saturdayFirst + 5) % 7;
}

/** So many months later, and no day beyond the last of that month; the ends of time stay where they are. */
export function addMonths([year, month, day]: Day, by: number): Day {
  const count = Math.min(Math.max(year * 12 + month - 1 + by, YEARS[0] * 12), YEARS[1] * 12 + 11);
  const [y, m] = [Math.floor(count / 12), (count % 12) + 1];
  return [y, m, Math.min(day, daysIn(y, m))];
}

/** So many days later; the ends of time stay where they are. */
export function addDays(date: Day, by: number): Day {
  let [year, month, day] = date;
  day += by;
  while (day < 1) {
    if (year === YEARS[0] && month === 1) return [year, month, 1];
    [year, month] = addMonths([year, month, 1], -1);
    day += daysIn(year, month);
  }
  while (day > daysIn(year, month)) {
    if (year === YEARS[1] && month === 12) return [year, month, 31];
    day -= daysIn(year, month);
    [year, month] = addMonths([year, month, 1], 1);
  }
  return [year, month, day];
}

/** The weeks that a month touches, each from Monday on (ISO 8601); nothing where a day is of another month. */
export function weeksOf(year: number, month: number): (number | undefined)[][] {
  const before = weekday([year, month, 1]);
  const last = daysIn(year, month);
  const weeks: (number | undefined)[][] = [];
  for (let first = 1 - before; first <= last; first += 7) {
    weeks.push(Array.from({ length: 7 }, (_, k) => (first + k >= 1 && first + k <= last ? first + k : undefined)));
  }
  return weeks;
}

const two = (x: number) => String(x).padStart(2, "0");

/** `2025-05-28`, as fields of the page and the files take it. */
export function dayText([year, month, day]: Day): string {
  return `${String(year).padStart(4, "0")}-${two(month)}-${two(day)}`;
}

/** The day that such a text means; nothing where there is none. */
export function dayOf(text: string): [number, number, number] | undefined {
  const found = /^(\d{4})-(\d{1,2})-(\d{1,2})$/.exec(text.trim());
  if (!found) return undefined;
  const [year, month, day] = [Number(found[1]), Number(found[2]), Number(found[3])];
  const isDay = year >= YEARS[0] && month >= 1 && month <= 12 && day >= 1 && day <= daysIn(year, month);
  return isDay ? [year, month, day] : undefined;
}

/** `14:05`, with seconds where there are some. */
export function timeText(seconds: number): string {
  const whole = Math.min(Math.max(Math.floor(seconds), 0), DAY_SECONDS - 1);
  const [hour, minute, second] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  return `${two(hour)}:${two(minute)}${second === 0 ? "" : `:${two(second)}`}`;
}

/** The seconds since midnight that such a text means; nothing where it is none. */
export function secondsOf(text: string): number | undefined {
  const found = /^(\d{1,2}):(\d{2})(?::(\d{2}))?$/.exec(text.trim());
  if (!found) return undefined;
  const [hour, minute, second] = [Number(found[1]), Number(found[2]), Number(found[3] ?? 0)];
  return hour < 24 && minute < 60 && second < 60 ? hour * 3600 + minute * 60 + second : undefined;
}
