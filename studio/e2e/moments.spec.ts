/** Calendars and clocks: placed at the present, set by mouse, keyboard and typing, undone, drawn, played. */
import { isAccessible } from "./access";
import { centre, drag, ground, openCanvas, place } from "./canvas";
import { openText } from "./open";
import { expect, test } from "./test";

/** A day as it is told: with a comma behind its name or without, as the browser's tables have it. */
const spoken = (day: string) => new RegExp(`^${day.replace(" ", ",? ")}$`);

const BOTH = `katydid 1
day = Calendar("2025-05-28")
time = Clock("14:05:00")
both = Panel(Merge(day, time))

layout {
    day: 0 0 [0 0 214 262]
    time: 0 290 [0 290 160 184]
    both: 300 40 [300 40 260 120]
}
`;

test("a calendar begins today; days are pressed, months leafed through, and Undo takes a day back", async ({ page }) => {
  await page.clock.setFixedTime(new Date(2025, 4, 28, 14, 5));
  await openCanvas(page);
  const calendar = await place(page, "calendar", [300, 260], "Calendar");
  const days = calendar.getByRole("spinbutton");
  await expect(days).toHaveAttribute("aria-valuetext", spoken("Wednesday 28 May 2025"));
  await expect(calendar.locator(".day.chosen")).toHaveText("28");
  await calendar.locator('[data-day="2"]').click();
  await expect(days).toHaveAttribute("aria-valuetext", spoken("Friday 2 May 2025"));
  // To leaf is no edit, and a day of the month that is shown is picked.
  await calendar.getByRole("button", { name: "Month before" }).click();
  await expect(calendar).toContainText("April 2025");
  await expect(calendar.locator(".day.chosen")).toHaveCount(0);
  await expect(days).toHaveAttribute("aria-valuetext", spoken("Friday 2 May 2025"));
  await calendar.locator('[data-day="30"]').click();
  await expect(days).toHaveAttribute("aria-valuetext", spoken("Wednesday 30 April 2025"));
  await ground(page).press("Control+z");
  await expect(days).toHaveAttribute("aria-valuetext", spoken("Friday 2 May 2025"));
  await isAccessible(page);
});

test("a calendar is set by keys, and its day can be typed", async ({ page }) => {
  await openText(page, "moments.kd", BOTH);
  const calendar = page.locator(".face-calendar");
  const days = calendar.getByRole("spinbutton");
  await days.focus();
  for (const [key, date] of [
    ["ArrowRight", "Thursday 29 May 2025"],
    ["ArrowDown", "Thursday 5 June 2025"],
    ["PageUp", "Monday 5 May 2025"],
    ["End", "Sunday 11 May 2025"],
    ["Home", "Monday 5 May 2025"],
    ["ArrowUp", "Monday 28 April 2025"],
    ["ArrowLeft", "Sunday 27 April 2025"],
  ] as const) {
    await page.keyboard.press(key);
    await expect(days).toHaveAttribute("aria-valuetext", spoken(date));
  }
  await expect(page.locator(".panel-data")).toContainText("2025-04-27 00:00:00");
  await calendar.click({ button: "right", position: { x: 60, y: 15 } });
  await page.getByRole("menuitem", { name: "Edit …" }).click();
  await page.getByLabel("Date", { exact: true }).fill("2024-02-29");
  await page.getByRole("button", { name: "OK", exact: true }).click();
  await expect(page.locator(".panel-data")).toContainText("2024-02-29 00:00:00");
});

test("a clock's hands are dragged, and it is set by keys; one drag is one step for Undo", async ({ page }) => {
  await openText(page, "moments.kd", BOTH);
  const clock = page.locator(".face-clock");
  const dial = clock.getByRole("slider");
  await expect(dial).toHaveAttribute("aria-valuetext", "14:05");
  const box = (await dial.boundingBox())!;
  const { x, y } = await centre(dial);
  const at = (turn: number, share: number) => ({
    x: x + Math.sin(2 * Math.PI * turn) * share * (box.width / 2),
    y: y - Math.cos(2 * Math.PI * turn) * share * (box.height / 2),
  });
  // A quarter of a turn of the hand of the minutes; then of that of the hours.
  await drag(page, at(5 / 60, 0.8), at(20 / 60, 0.8));
  await expect(dial).toHaveAttribute("aria-valuetext", "14:20");
  await expect(page.locator(".panel-data")).toContainText("14:20:00");
  await drag(page, at(2 / 12, 0.35), at(5 / 12, 0.35));
  await expect(dial).toHaveAttribute("aria-valuetext", "17:15");
  await ground(page).press("Control+z");
  await expect(dial).toHaveAttribute("aria-valuetext", "14:20");
  await ground(page).press("Control+z");
  await expect(dial).toHaveAttribute("aria-valuetext", "14:05");
  await dial.focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("PageUp");
  await page.keyboard.press("Shift+ArrowDown");
  await page.keyboard.press("ArrowDown");
  await expect(dial).toHaveAttribute("aria-valuetext", "14:05");
  await page.keyboard.press("ArrowLeft");
  await expect(dial).toHaveAttribute("aria-valuetext", "14:04");
});

test("calendars and clocks look as they should, in both themes", async ({ page }) => {
  await openText(page, "moments.kd", BOTH);
  await expect(page.locator(".panel-data")).toContainText("2025-05-28");
  await ground(page).focus();
  await page.keyboard.press("Control+1");
  await page.mouse.move(5, 5);
  for (const theme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
    await expect(page.locator(".face-calendar")).toHaveScreenshot(`calendar-${theme}.png`);
    await expect(page.locator(".face-clock")).toHaveScreenshot(`clock-${theme}.png`);
    await isAccessible(page);
  }
});

test("the player has fields for days and times", async ({ page }) => {
  await openText(page, "moments.kd", BOTH);
  await page.goto(`${page.url()}&player`);
  await page.getByLabel("day", { exact: true }).fill("2024-02-29");
  await page.getByLabel("time", { exact: true }).fill("07:30");
  await page.goto(page.url().replace("&player", ""));
  await expect(page.locator(".panel-data")).toContainText("2024-02-29 00:00:00");
  await expect(page.locator(".panel-data")).toContainText("07:30:00");
});
