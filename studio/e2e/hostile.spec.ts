/** Definitions that mean harm: what they write is text, and what they cost can be stopped. */
import type { Page } from "@playwright/test";

import { centre, drag, grip, ground, openCanvas, place, spot, wire } from "./canvas";
import { modelSize, openText } from "./open";
import { expect, test } from "./test";

const IMAGE = '<img src=x onerror="window.bad=1">';
const SCRIPT = "<script>window.bad=1</script>";

/** That it is there as it was written, and that no browser took it for more than text. */
async function isText(page: Page): Promise<void> {
  expect(await page.evaluate(() => "bad" in window)).toBe(false);
  await expect(page.locator('img[src="x"], script:not([src])')).toHaveCount(0);
}

test("a script in a nickname, a panel, a scribble, a label or a message stays text", async ({ page }) => {
  await openCanvas(page);
  const panel = await place(page, `"${IMAGE}`, [150, 90]);
  await expect(panel).toContainText(IMAGE);
  const scribble = await place(page, `~${SCRIPT}`, [400, 90]);
  await expect(scribble).toContainText(SCRIPT);
  const sine = await place(page, "Sine", [400, 200]);
  await page.keyboard.press("F2");
  await page.getByRole("textbox", { name: "Name" }).fill(IMAGE);
  await page.keyboard.press("Enter");
  await expect(sine).toContainText(IMAGE);
  // What cannot be read as a number is told of.
  await wire(page, grip(panel, "output"), grip(sine, "input", 0));
  await expect(sine).toHaveAttribute("data-look", /error|warning/);
  await ground(page).press("Control+a");
  await page.keyboard.press("Control+g");
  await expect(page.locator("[data-group].selected")).toHaveCount(1);
  await page.keyboard.press("F2");
  await page.getByRole("textbox", { name: "Label" }).fill(SCRIPT);
  await page.keyboard.press("Enter");
  await expect(page.locator("[data-group]")).toContainText(SCRIPT);
  await isText(page);

  for (const [keys, name] of [["O", "Outline"], ["M", "Problems"], ["D", "Data"]] as const) {
    await page.keyboard.press(`Control+Shift+${keys}`);
    await expect(page.getByRole("complementary", { name })).toBeVisible();
    if (keys === "O") await expect(page.getByRole("complementary", { name })).toContainText(IMAGE);
    await isText(page);
  }
  await page.keyboard.press("F3");
  await page.keyboard.type("<img");
  await expect(page.locator(".pick-list").getByRole("option").first()).toContainText("<img");
  await page.keyboard.press("Escape");
  await page.mouse.move(...((at) => [at.x, at.y] as const)(await centre(sine)));
  await expect(page.getByRole("tooltip")).toContainText("<img");
  await isText(page);

  await page.goto(`${page.url()}&player`);
  await expect(page.getByRole("complementary", { name: "Inputs" })).toContainText("Value of Sine");
  await isText(page);
});

test("a script in a file's name, and in a text that the model shows, stays text", async ({ page }) => {
  const name = `${IMAGE}.kd`;
  await openText(page, name, `katydid 1\np = Construct Point(0, 0, 0)\nt = Text Tag(p, "${IMAGE.replaceAll('"', "'")}")\n`);
  await expect(page.getByRole("heading", { level: 1 })).toContainText("<img src=x");
  await isText(page);
  await page.goto("/");
  await expect(page.getByRole("button", { name: /<img src=x/ }).first()).toBeVisible();
  await isText(page);
});

test("ten thousand objects can be opened, looked over, changed and taken back", async ({ page }) => {
  test.setTimeout(120_000);
  const lines = ["katydid 1"];
  for (let row = 0; row < 100; row++) {
    lines.push(`r${row} = Number Slider(2.0, 0..10)`);
    for (let k = 1; k < 100; k++) lines.push(`p${row}_${k} = Construct Point(r${row}, ${k}, ${row})`);
  }
  await openText(page, "many.kd", lines.join("\n"));
  // It opens where it begins, near enough to be read; all of it is a far view.
  await expect(page.getByRole("status").filter({ hasText: /^Solved/ })).toBeVisible({ timeout: 30_000 });
  await expect(page.getByRole("button", { name: "Zoom, 50 %" })).toBeVisible();
  await ground(page).press("Control+0");
  await expect(page.locator("canvas.far")).toHaveCount(1);
  await expect.poll(() => modelSize(page), { timeout: 30_000 }).toEqual([0, 98, 99]);
  // The far view is selected in and zoomed; near, what is there has its names.
  const { x, y } = await spot(page, [300, 250]);
  await drag(page, { x, y }, { x: x + 120, y: y + 60 });
  await page.keyboard.press("F3");
  await page.keyboard.type("r17");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Control+2");
  const slider = page.getByRole("slider", { name: "r17" });
  await expect(slider).toBeVisible();
  await page.keyboard.press("Enter");
  await page.keyboard.press("End");
  await expect(slider).toHaveAttribute("aria-valuenow", "10");
  await expect.poll(() => modelSize(page), { timeout: 30_000 }).toEqual([8, 98, 99]);
  await page.keyboard.press("Control+z");
  await expect(slider).toHaveAttribute("aria-valuenow", "2");
  await expect.poll(() => modelSize(page), { timeout: 30_000 }).toEqual([0, 98, 99]);
  await page.keyboard.press("Control+Shift+O");
  await expect(page.getByRole("complementary", { name: "Outline" })).toContainText("10000 objects");
});

test("what is asked for while many objects are opening is not undone by the first look at them", async ({ page }) => {
  await page.addInitScript(() => {
    // Frames that the page asks for wait until the test lets them go: the first look comes with one of them.
    const held: FrameRequestCallback[] = [];
    const plain = window.requestAnimationFrame.bind(window);
    let holds = location.search.includes("document");
    window.requestAnimationFrame = (frame) => (holds ? held.push(frame) : plain(frame));
    Object.assign(window, {
      letFramesGo() {
        holds = false;
        for (const frame of held) plain(frame);
      },
    });
  });
  const lines = ["katydid 1"];
  for (let row = 0; row < 100; row++) for (let k = 0; k < 30; k++) lines.push(`p${row}_${k} = Construct Point(${row}, ${k}, 0)`);
  await openText(page, "many.kd", lines.join("\n"));
  await expect(page.getByRole("heading", { level: 1 })).toContainText("many");
  await ground(page).press("Control+0");
  await page.evaluate(() => (window as unknown as { letFramesGo(): void }).letFramesGo());
  await expect(page.locator("canvas.far")).toHaveCount(1);
  await page.waitForTimeout(500);
  const zoom = await page.getByRole("button", { name: /^Zoom, / }).textContent();
  expect(Number.parseFloat(zoom ?? "")).toBeLessThan(10);
});

test("a definition without end is cancelled, by its button and by Escape, and solves once it is short", async ({ page }) => {
  // A formula that may give a text is worked out item by item.
  const slow = String.raw`"if(x > -1e9, sin(x) * cos(x) + sqrt(abs(x)), \"\")"`;
  const lines = ["katydid 1", "n = Number Slider(4000000.0, 0..9000000)", "s = Series(0, 1, n)"];
  for (let k = 0; k < 200; k++) {
    lines.push(`e${k} = Expression(${slow}, x = ${k === 0 ? "s" : `e${k - 1}`})`);
  }
  await openText(page, "endless.kd", lines.join("\n"));
  const cancelled = page.getByRole("status").filter({ hasText: "cancelled" });
  const cancel = page.getByRole("button", { name: "Cancel the solution" });
  await cancel.click();
  await expect(cancelled).toBeVisible();
  await expect(cancel).toHaveCount(0);

  await page.keyboard.press("F5");
  await expect(cancel).toBeVisible();
  await ground(page).focus();
  await page.keyboard.press("Escape");
  await expect(cancelled).toBeVisible();

  await page.keyboard.press("F3");
  await page.keyboard.type("Number Slider");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Control+2");
  const slider = page.getByRole("slider");
  await expect(slider).toBeVisible();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Home");
  await expect(slider).toHaveAttribute("aria-valuenow", "0");
  await expect(page.getByRole("status").filter({ hasText: /^Solved/ })).toBeVisible({ timeout: 30_000 });
});
