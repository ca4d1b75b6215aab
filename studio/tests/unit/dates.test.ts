import { describe, expect, test } from "vitest";

import { addDays, addMonths, dayOf, daysIn, dayText, secondsOf, timeText, weekday, weeksOf, type Day } from "../../src/core/dates";

/** The same day by the browser's own calendar. */
function utc([year, month, day]: Day): Date {
  const date = new Date(0);
  date.setUTCFullYear(year, month - 1, day);
  return date;
}

const DAYS: Day[] = [
  [1, 1, 1], [1600, 2, 29], [1900, 2, 28], [1969, 7, 20], [2000, 2, 29], [2024, 1, 31], [2024, 2, 29], [2025, 5, 28], [2100, 12, 31], [9999, 12, 31],
];

describe("days", () => {
  test.each(DAYS)("%i-%i-%i has the browser's day of the week", (...day) => {
    expect((weekday(day) + 1) % 7).toBe(utc(day).getUTCDay());
  });

  test("go on across months, years and leap days as the browser's do", () => {
    for (const start of DAYS.slice(1, -1)) {
      for (const by of [-800, -366, -31, -7, -1, 0, 1, 7, 28, 366, 800]) {
        const wanted = utc(start);
        wanted.setUTCDate(wanted.getUTCDate() + by);
        expect(utc(addDays(start, by)).getTime()).toBe(wanted.getTime());
      }
    }
  });

  test("end where time does", () => {
    expect(addDays([1, 1, 1], -1)).toEqual([1, 1, 1]);
    expect(addDays([9999, 12, 31], 1)).toEqual([9999, 12, 31]);
    expect(addMonths([1, 1, 5], -1)).toEqual([1, 1, 5]);
    expect(addMonths([9999, 12, 5], 1)).toEqual([9999, 12, 5]);
  });

  test("a month later is no later than its last day", () => {
    expect(addMonths([2024, 1, 31], 1)).toEqual([2024, 2, 29]);
    expect(addMonths([2023, 3, 31], -1)).toEqual([2023, 2, 28]);
    expect([daysIn(1900, 2), daysIn(2000, 2), daysIn(2024, 4), daysIn(2024, 12)]).toEqual([28, 29, 30, 31]);
  });

  test("stand in weeks from Mondays on", () => {
    // 28 February of 2021 was a Sunday, and the 1st a Monday: four whole weeks.
    expect(weeksOf(2021, 2)).toHaveLength(4);
    expect(weeksOf(2021, 2)[0]).toEqual([1, 2, 3, 4, 5, 6, 7]);
    // The 1st of May of 2021 was a Saturday: six weeks are touched.
    expect(weeksOf(2021, 5)).toHaveLength(6);
    expect(weeksOf(2021, 5)[0]?.[5]).toBe(1);
  });

  test("are read as they are written", () => {
    for (const day of DAYS) expect(dayOf(dayText(day))).toEqual([...day]);
    for (const none of ["", "2023-02-29", "0000-01-01", "2024-13-01", "2024-00-10", "tomorrow", "2024-01-00"]) expect(dayOf(none)).toBeUndefined();
  });
});

test("times are read as they are written", () => {
  for (const seconds of [0, 60, 3599, 3600, 43_205, 86_399]) expect(secondsOf(timeText(seconds))).toBe(seconds);
  expect(timeText(50_700)).toBe("14:05");
  expect(timeText(1e9)).toBe("23:59:59");
  for (const none of ["", "24:00", "12:60", "12:00:60", "noon"]) expect(secondsOf(none)).toBeUndefined();
});
