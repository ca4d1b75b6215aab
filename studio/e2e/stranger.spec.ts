/** A stranger's first ten minutes: what a hand that knows Grasshopper does first, from the start page to a saved file. */
import { copyFileSync, readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";

import { centre, drag, grip, place, spot, wire, wires } from "./canvas";
import { modelSize, onWorkbench } from "./open";
import { expect, test } from "./test";

/** Undo and Redo are asked for this often; a journey makes at least as many steps. */
const STEPS = 20;

const objects = (page: Page) => page.locator("[data-object]");
const panel = (page: Page) => page.locator(".panel").filter({ has: page.locator(".item-row") });

test("with the mouse: place, wire, slide, read, group, take back, make again, save, open again", async ({ page }, info) => {
  await page.goto("/");
  await page.getByRole("button", { name: "New definition" }).click();
  await onWorkbench(page);

  const width = await place(page, "5<10..20", [150, 90]);
  const height = await place(page, "0..3..10", [150, 170]);
  const sum = await place(page, "Addition", [380, 130]);
  const text = await place(page, '"', [560, 60]);
  const circle = await place(page, "Circle", [560, 260], "Curve › Primitive");
  await expect(width.getByRole("slider")).toHaveAttribute("aria-valuenow", "10");

  await wire(page, grip(width, "output"), grip(sum, "input", 0));
  await expect(wires(page)).toHaveCount(1);
  await wire(page, grip(sum, "input", 1), grip(height, "output"));
  await expect(wires(page)).toHaveCount(2);
  await wire(page, grip(sum, "output"), grip(text, "input"));
  await expect(panel(page)).toContainText("13");
  await wire(page, grip(sum, "output"), grip(circle, "input", 1));
  await expect(wires(page)).toHaveCount(4);
  await expect.poll(() => modelSize(page)).toEqual([26, 26, 0]);

  // The slider: dragged, typed into, and with its editor.
  const knob = await centre(height.locator(".knob"));
  await drag(page, knob, { x: knob.x + 200, y: knob.y });
  await expect(height.getByRole("slider")).toHaveAttribute("aria-valuenow", "10");
  await expect(panel(page)).toContainText("20");
  await height.locator(".number").dblclick();
  await page.keyboard.type("2+2");
  await page.keyboard.press("Enter");
  await expect(panel(page)).toContainText("14");
  await width.locator("[data-editor]").dblclick();
  const editor = page.getByRole("dialog", { name: /^Settings of/ });
  await editor.getByRole("textbox", { name: "Name" }).fill("Width");
  await editor.getByRole("textbox", { name: "Max" }).fill("40");
  await editor.getByRole("textbox", { name: "Value", exact: true }).fill("31");
  await editor.getByRole("button", { name: "OK" }).click();
  await expect(panel(page)).toContainText("35");
  await expect.poll(() => modelSize(page)).toEqual([70, 70, 0]);

  // Menus: a nickname, flatten, preview off and on.
  await circle.locator(".band").click({ button: "right" });
  await page.getByRole("textbox", { name: "Name" }).fill("Round");
  await page.keyboard.press("Enter");
  await expect(circle).toContainText("Round");
  await circle.locator(".band").click({ button: "right" });
  await page.getByRole("menuitemcheckbox", { name: "Preview" }).click();
  await expect.poll(() => modelSize(page)).toBeNull();
  await circle.locator(".band").click({ button: "right" });
  await page.getByRole("menuitemcheckbox", { name: "Preview" }).click();
  await expect.poll(() => modelSize(page)).toEqual([70, 70, 0]);
  const name = sum.locator("[data-name-of]").first();
  await name.click({ button: "right" });
  await page.getByRole("menuitemcheckbox", { name: "Flatten" }).click();
  await expect(name).toContainText("↓");

  // Objects moved, a remark beside them, and a group about two.
  const before = await centre(circle);
  await drag(page, before, { x: before.x - 20, y: before.y + 50 });
  await expect.poll(async () => Math.round((await centre(circle)).y - before.y)).toBe(50);
  await place(page, "~Sum of two", [330, 330]);
  await drag(page, await spot(page, [10, 40]), { x: (await centre(height)).x + 130, y: (await centre(height)).y + 40 });
  await page.getByRole("menuitem", { name: "Object", exact: true }).click();
  await page.getByRole("menuitem", { name: /^Group/ }).click();
  const group = page.locator("[data-group]");
  await expect(group).toHaveCount(1);
  await group.click({ button: "right", position: { x: 4, y: 4 } });
  await page.getByRole("textbox", { name: "Label" }).fill("Sizes");
  await page.keyboard.press("Enter");
  await expect(group).toHaveAccessibleName("Sizes, 2 objects");
  await text.click();
  await page.keyboard.press("Delete");
  await expect(panel(page)).toHaveCount(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(panel(page)).toContainText("35");

  await undoAndRedo(page, async (button) => await page.getByRole("button", { name: button }).click());

  await page.getByRole("button", { name: "Save", exact: true }).click();
  const [kept] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("dialog", { name: "Save as" }).getByRole("button", { name: "Download .ghx" }).click(),
  ]);
  expect(kept.suggestedFilename()).toMatch(/\.ghx$/);
  const file = info.outputPath("stranger.ghx");
  await kept.saveAs(file);
  expect(readFileSync(file, "utf8")).toContain("<Archive");

  await page.getByRole("menuitem", { name: "File" }).click();
  await page.getByRole("menuitem", { name: /^Open …/ }).click();
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByText("Open a file …").click()]);
  await chooser.setFiles(file);
  await onWorkbench(page);
  await isTheSame(page);
});

test("with the keyboard alone: the same, and every step is told", async ({ page }, info) => {
  await page.addInitScript(() => {
    for (const kind of ["pointerdown", "mousedown", "wheel", "touchstart"]) {
      addEventListener(kind, () => document.documentElement.setAttribute("data-touched", kind), true);
    }
  });
  const { press, type, told, tabTo, add, goTo, find, menu } = keyboard(page);
  await page.goto("/");
  await tabTo(page.getByRole("button", { name: "New definition" }));
  await press("Enter");
  await onWorkbench(page);
  await tabTo(page.getByRole("link", { name: "Skip to the canvas" }));
  await press("Enter");

  await add("5<10..20", "Number Slider");
  await add("0..3..10", "Number Slider");
  await add("Addition", "Addition");
  await add('"', "Panel");
  await goTo("ArrowLeft", "Addition");
  await add("Circle", "Circle");
  await press("Control+0");
  await expect(objects(page)).toHaveCount(5);

  // Wires: C asks where to, and the answer is typed. The other way round, Shift+C asks where from.
  const connect = async (key: string, answer: string) => {
    await press(key);
    await expect(page.getByRole("combobox", { name: /^Connect/ })).toBeFocused();
    await type(answer);
    await press("Enter");
    await told(/is connected with/);
  };
  await goTo("Home", "Number Slider");
  await connect("c", "A+B · A");
  await goTo("Home", "A, Number Slider");
  await goTo("ArrowRight", "^Number Slider");
  await connect("c", "A+B · B");
  await find("Panel");
  await connect("Shift+C", "A+B");
  await find("Circle");
  await menu("Inputs", "Radius", "Connect …");
  await type("A+B");
  await press("Enter");
  await expect(wires(page)).toHaveCount(4);
  await expect(panel(page)).toContainText("13");
  await expect.poll(() => modelSize(page)).toEqual([26, 26, 0]);

  // A slider: Enter goes into it, arrows set it, Escape leaves it, Enter twice opens its editor.
  await find("B");
  await press("Enter", "End", "ArrowLeft", "ArrowLeft", "PageDown", "ArrowLeft", "ArrowLeft", "ArrowLeft");
  await expect(page.getByRole("slider", { name: "B" })).toBeFocused();
  await expect(page.getByRole("slider", { name: "B" })).toHaveAttribute("aria-valuetext", "4");
  await expect(panel(page)).toContainText("14");
  await press("Escape");
  await goTo("Home", "A, Number Slider");
  await press("Enter", "Enter");
  const editor = page.getByRole("dialog", { name: "Settings of A" });
  const fill = async (name: string, text: string) => {
    const field = editor.getByRole("textbox", { name, exact: true });
    if (!(await field.evaluate((element) => element === document.activeElement))) await tabTo(field);
    await press("Control+a");
    await type(text);
  };
  await fill("Name", "Width");
  await fill("Max", "40");
  await fill("Value", "31");
  await press("Enter", "Control+0");
  await expect(panel(page)).toContainText("35");

  // Menus of an object and of its ports.
  await find("Circle");
  await press("F2");
  await press("Control+a");
  await type("Round");
  await press("Enter");
  await told("Rename");
  await menu("Preview");
  await expect.poll(() => modelSize(page)).toBeNull();
  await press("Control+q");
  await expect.poll(() => modelSize(page)).toEqual([70, 70, 0]);
  await find("Addition");
  await menu("Inputs", "A", "Flatten");
  await expect(page.getByLabel("Flatten")).toHaveText("↓");

  // Moved, written, grouped.
  await press("Alt+ArrowDown");
  await told(/^Move/);
  await press("Space");
  await type("~Sum of two");
  await press("Enter");
  await told(/^Place/);
  await expect(page.getByRole("note")).toBeFocused();
  await goTo("Home", "Width");
  await press("Shift+ArrowRight", "Control+g");
  await told("Group");
  await press("F2");
  await type("Sizes");
  await press("Enter");
  await expect(page.getByRole("group", { name: "Sizes, 2 objects" })).toBeVisible();
  await find("Panel");
  await press("Delete");
  await told(/Delete|Remove/);
  await press("Control+z");
  await told(/^Taken back/);

  await press("Control+0");

  await undoAndRedo(page, async (way) => {
    await press(way === "Undo" ? "Control+z" : "Control+y");
    await told(way === "Undo" ? /^Taken back/ : /^Made again/);
  });

  // Saved under a path, and a copy opened: the one that is open would only be shown again.
  const [path, copy] = [info.outputPath("stranger.ghx"), info.outputPath("copy.ghx")];
  await press("Control+s");
  await expect(page.getByRole("textbox", { name: "Path on this machine" })).toBeFocused();
  await type(path);
  await press("Enter");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("stranger.ghx");
  copyFileSync(path, copy);
  await press("Control+o");
  await expect(page.getByRole("button", { name: "New definition" })).toBeVisible();
  await tabTo(page.getByRole("textbox", { name: "Path of a file on this machine" }));
  await type(copy);
  await press("Enter");
  await onWorkbench(page);
  await isTheSame(page);

  // The palette has every command, the outline says what is on the canvas.
  await press("Control+k");
  await type("outline");
  await press("Enter");
  await expect(page.getByRole("complementary", { name: "Outline" })).toContainText("A reads Width");
  await expect(page.locator("[data-touched]")).toHaveCount(0);
});

/** Hands that have no mouse. */
function keyboard(page: Page) {
  const press = async (...keys: string[]) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  const type = (text: string) => page.keyboard.type(text);
  /** Something was said to who cannot see. */
  const told = async (words: RegExp | string) => await expect(page.getByRole("status").filter({ hasText: words }).first()).toBeAttached();
  const tabTo = async (what: Locator) => {
    for (let step = 0; step < 60; step++) {
      await press("Tab");
      if (await what.evaluate((element) => element === document.activeElement)) return;
    }
    throw new Error(`Tab never comes to ${what}`);
  };
  /** Searches and places what is found first, or what some keys lead to. */
  const add = async (words: string, name: string, ...keys: string[]) => {
    const before = await objects(page).count();
    await press("Space");
    await expect(page.getByRole("combobox", { name: "Search for a component" })).toBeFocused();
    await type(words);
    await press(...keys, "Enter");
    await told(`Place ${name}`);
    await expect(objects(page)).toHaveCount(before + 1);
    await expect(page.locator("[data-object]:focus")).toHaveAccessibleName(new RegExp(name));
  };
  /** Goes on the canvas; the object that is come to tells its name. */
  const goTo = async (key: string, name = "") => {
    await press(key);
    await expect(page.locator("[data-object]:focus")).toHaveAccessibleName(new RegExp(name));
    await told(new RegExp(name));
  };
  /** Goes to an object by what is written on it. */
  const find = async (name: string) => {
    await press("F3");
    await expect(page.getByRole("combobox", { name: "Find on the canvas" })).toBeFocused();
    await type(name);
    await press("Enter");
    await expect(page.locator("[data-object]:focus")).toHaveAccessibleName(new RegExp(`\\b${name}\\b`));
  };
  const focused = () => page.evaluate(() => document.activeElement?.textContent ?? "");
  /** Opens the menu of the object and goes through it to an entry. */
  const menu = async (...entries: string[]) => {
    await press("Shift+F10");
    for (const entry of entries) {
      for (let step = 0; step < 40 && !new RegExp(`^✓?${entry}`).test(await focused()); step++) await press("ArrowDown");
      await press("Enter");
    }
    await expect(page.getByRole("menu", { name: "Menu", exact: true })).toHaveCount(0);
  };
  return { press, type, told, tabTo, add, goTo, find, menu };
}

/** The definition as the journey leaves it, as it looks. */
async function isTheSame(page: Page): Promise<void> {
  await expect(objects(page)).toHaveCount(7);
  await expect(wires(page)).toHaveCount(4);
  await expect(panel(page)).toContainText("35");
  await expect(page.getByRole("slider", { name: "Width" })).toHaveAttribute("aria-valuenow", "31");
  await expect(page.getByRole("group", { name: "Sizes, 2 objects" })).toBeVisible();
  await expect(page.getByRole("note")).toHaveText("Sum of two");
  await expect.poll(() => modelSize(page)).toEqual([70, 70, 0]);
}

/** Takes twenty steps back, one after the other, and makes them again. */
async function undoAndRedo(page: Page, press: (button: "Undo" | "Redo") => Promise<void>): Promise<void> {
  for (let step = 0; step < STEPS; step++) await press("Undo");
  await expect(panel(page)).toHaveCount(0);
  await expect(page.getByRole("slider", { name: "Width" })).toHaveCount(0);
  await expect.poll(() => modelSize(page)).not.toEqual([70, 70, 0]);
  for (let step = 0; step < STEPS; step++) await press("Redo");
  await isTheSame(page);
}
