/** Several objects wired at once, the display of their wires, and panels that stream to a file. */
import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";

import { centre, drag, grip, ground, wires } from "./canvas";
import { openText } from "./open";
import { expect, test } from "./test";

const THREE = `katydid 1
a = Number Slider(1, 0..10)
b = Number Slider(2, 0..10)
c = Number Slider(3, 0..10)
other = Number Slider(9, 0..10)
shown = Panel(other)
one = Circle(_, _)
two = Circle(_, _)

layout {
    a: 0 0 [0 0 180 20]
    b: 0 40 [0 40 180 20]
    c: 0 80 [0 80 180 20]
    other: 0 150 [0 150 180 20]
    shown: 300 20 [300 20 160 120]
    one: 300 190
    two: 300 260
}
`;

const object = (page: Page, name: string) => page.locator(`[data-object][aria-label^="${name}, "]`);

/** Selects these objects and nothing else. */
async function selectAll(page: Page, names: string[]): Promise<void> {
  await ground(page).press("Escape");
  for (const name of names) await object(page, name).locator(".title").click({ modifiers: ["Shift"] });
}

test("wires from one of several selected objects go from all of them: replaced, added with Shift, removed with Ctrl", async ({ page }) => {
  await openText(page, "three.kd", THREE);
  const panel = page.locator(".panel-data");
  await expect(panel).toContainText("9");
  await expect(wires(page)).toHaveCount(1);
  await selectAll(page, ["a", "b", "c"]);
  const end = grip(object(page, "shown"), "input");
  const from = grip(object(page, "b"), "output");
  // All of them are shown while the hand goes on.
  const [start, stop] = [await centre(from), await centre(end)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(stop.x - 40, stop.y, { steps: 4 });
  await expect(page.locator(".elastic path")).toHaveCount(3);
  await page.mouse.move(stop.x, stop.y, { steps: 4 });
  await page.mouse.up();
  await expect(wires(page)).toHaveCount(3);
  // What was read before is gone, and the new ones come from top to bottom.
  await expect(panel.locator(".item")).toHaveText(["1", "2", "3"]);
  await drag(page, start, stop, ["Control"]);
  await expect(wires(page)).toHaveCount(0);
  await ground(page).press("Control+z");
  await expect(wires(page)).toHaveCount(3);
  await ground(page).press("Control+z");
  await expect(wires(page)).toHaveCount(1);
  await expect(panel.locator(".item")).toHaveText(["9"]);
  await drag(page, start, stop, ["Shift"]);
  await expect(panel.locator(".item")).toHaveText(["9", "1", "2", "3"]);
});

test("an output is led to the same input of all selected objects", async ({ page }) => {
  await openText(page, "three.kd", THREE);
  await expect(wires(page)).toHaveCount(1);
  await ground(page).press("Escape");
  for (const name of ["one", "two"]) await object(page, name).locator(".band").click({ modifiers: ["Shift"] });
  await drag(page, await centre(grip(object(page, "one"), "input", 1)), await centre(grip(object(page, "c"), "output")));
  await expect(wires(page)).toHaveCount(3);
  await ground(page).press("Control+z");
  await expect(wires(page)).toHaveCount(1);
});

test("the wires into all selected objects are hidden and shown at once, and those that are hidden are waves at their ends", async ({ page }) => {
  await openText(page, "three.kd", THREE);
  await selectAll(page, ["a", "b", "c"]);
  await drag(page, await centre(grip(object(page, "a"), "output")), await centre(grip(object(page, "shown"), "input")));
  await expect(wires(page)).toHaveCount(3);
  await ground(page).press("Escape");
  const { x, y } = await centre(object(page, "shown"));
  await page.mouse.click(x, y - 30, { button: "right" });
  await page.getByRole("menuitem", { name: "Wire display" }).first().hover();
  await page.getByRole("menuitemcheckbox", { name: "Hidden" }).click();
  await ground(page).press("Escape");
  await expect(page.locator(".wire.wireless")).toHaveCount(3);
  // An end of it is selected: it is drawn.
  await object(page, "a").locator(".title").click();
  await expect(page.locator(".wire.wireless")).toHaveCount(2);
});

test("a panel keeps the file that it streams to, and what it shows is saved here", async ({ page }) => {
  await openText(page, "three.kd", THREE);
  const { x, y } = await centre(object(page, "shown"));
  await page.mouse.click(x, y, { button: "right" });
  await page.getByRole("menuitemcheckbox", { name: "Stream to a file …" }).click();
  await page.getByLabel("File", { exact: true }).fill("out/widths.txt");
  await page.getByRole("button", { name: "OK", exact: true }).click();
  await expect(page.locator(".panel-stream")).toHaveText("⤓ widths.txt");
  await expect(page.locator(".panel-stream")).toHaveAttribute("title", "Streams to out/widths.txt");
  await page.mouse.click(x, y, { button: "right" });
  const kept = page.waitForEvent("download");
  await page.getByRole("menuitem", { name: "Save what it shows" }).click();
  expect(await readFile(await (await kept).path(), "utf8")).toBe("9\n");
  await ground(page).press("Control+z");
  await expect(page.locator(".panel-stream")).toHaveCount(0);
});
