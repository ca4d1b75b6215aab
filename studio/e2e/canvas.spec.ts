import { centre, drag, grip, ground, newest, ids, openCanvas, place, spot, wire, wires } from "./canvas";
import { expect, test } from "./test";

test.beforeEach(async ({ page }) => {
  await openCanvas(page);
});

test("a double-click searches, and codes place sliders and panels", async ({ page }) => {
  const slider = await place(page, "0<3<10", [200, 120]);
  await expect(slider.getByRole("slider")).toHaveAttribute("aria-valuenow", "3");
  await expect(slider.getByRole("slider")).toHaveAttribute("aria-valuemax", "10");
  const panel = await place(page, '"hello', [200, 240]);
  await expect(panel).toContainText("hello");
  const addition = await place(page, "additio", [450, 160]);
  await expect(addition.locator(".grip.input")).toHaveCount(2);
});

test("wires are drawn either way, replaced, added with Shift and removed with Ctrl", async ({ page }) => {
  const one = await place(page, "1<2<9", [160, 100]);
  const two = await place(page, "1<3<9", [160, 180]);
  const sum = await place(page, "addition", [450, 140]);
  await wire(page, grip(one, "output"), grip(sum, "input", 0));
  await expect(wires(page)).toHaveCount(1);
  await expect(wires(page).first()).toHaveAttribute("data-structure", "item");
  await wire(page, grip(sum, "input", 1), grip(two, "output"));
  await expect(wires(page)).toHaveCount(2);
  // A plain wire takes the place of the one that is there.
  await wire(page, grip(two, "output"), grip(sum, "input", 0));
  await expect(wires(page)).toHaveCount(2);
  await wire(page, grip(one, "output"), grip(sum, "input", 0), ["Shift"]);
  await expect(wires(page)).toHaveCount(3);
  await wire(page, grip(one, "output"), grip(sum, "input", 0), ["Control"]);
  await expect(wires(page)).toHaveCount(2);
});

test("Ctrl and Shift take all wires of a grip elsewhere", async ({ page }) => {
  const one = await place(page, "1<2<9", [160, 100]);
  const sum = await place(page, "addition", [450, 140]);
  await wire(page, grip(one, "output"), grip(sum, "input", 0));
  await expect(wires(page)).toHaveCount(1);
  const before = await wires(page).first().getAttribute("data-wire");
  await wire(page, grip(sum, "input", 0), grip(sum, "input", 1), ["Control", "Shift"]);
  // There is one wire before the session answers, too.
  await expect.poll(() => wires(page).first().getAttribute("data-wire")).not.toBe(before);
  await expect(wires(page)).toHaveCount(1);
});

test("a wire let go in the void searches for what takes it", async ({ page }) => {
  const one = await place(page, "1<2<9", [160, 120]);
  const before = await ids(page);
  await drag(page, await centre(grip(one, "output")), await spot(page, [460, 200]));
  const field = page.getByRole("combobox", { name: "Search for a component" });
  await field.fill("multiplication");
  await page.keyboard.press("Enter");
  await newest(page, before);
  await expect(wires(page)).toHaveCount(1);
});

test("Escape abandons a wire and a drag", async ({ page }) => {
  const one = await place(page, "addition", [200, 140]);
  const from = await centre(grip(one, "output"));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 120, from.y + 60, { steps: 4 });
  await expect(page.locator(".elastic")).toHaveCount(1);
  await page.keyboard.press("Escape");
  await expect(page.locator(".elastic")).toHaveCount(0);
  await page.mouse.up();
  await expect(page.getByRole("combobox", { name: "Search for a component" })).toHaveCount(0);
  const place0 = await one.boundingBox();
  const middle = await centre(one);
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 80, middle.y + 90, { steps: 5 });
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect.poll(async () => (await one.boundingBox())?.y).toBe(place0?.y);
});

test("objects are dragged, and Undo puts them back", async ({ page }) => {
  const one = await place(page, "addition", [200, 140]);
  const before = await centre(one);
  await drag(page, before, { x: before.x + 150, y: before.y + 110 });
  await expect.poll(async () => Math.round((await centre(one)).x - before.x)).toBe(150);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => Math.round((await centre(one)).x - before.x)).toBe(0);
});

test("a window to the right takes what lies inside, one to the left what it touches", async ({ page }) => {
  const one = await place(page, "addition", [200, 120]);
  const two = await place(page, "multiplication", [400, 120]);
  const [a, b] = [await spot(page, [110, 50]), await centre(two)];
  await drag(page, a, { x: b.x, y: b.y + 100 });
  await expect(one).toHaveClass(/selected/);
  await expect(two).not.toHaveClass(/selected/);
  await drag(page, { x: b.x, y: b.y + 100 }, a);
  await expect(one).toHaveClass(/selected/);
  await expect(two).toHaveClass(/selected/);
  // Ctrl takes away, Shift adds.
  await drag(page, a, await spot(page, [300, 220]), ["Control"]);
  await expect(one).not.toHaveClass(/selected/);
  await expect(two).toHaveClass(/selected/);
  await drag(page, a, await spot(page, [300, 220]), ["Shift"]);
  await expect(one).toHaveClass(/selected/);
});

test("the right button pans when it is dragged and opens the menu when it is clicked; the wheel zooms", async ({ page }) => {
  const one = await place(page, "addition", [250, 160]);
  const before = await one.boundingBox();
  const from = await spot(page, [450, 300]);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(from.x + 60, from.y + 40, { steps: 5 });
  await page.mouse.up({ button: "right" });
  await expect(page.getByRole("menu", { name: "Menu", exact: true })).toHaveCount(0);
  await expect.poll(async () => Math.round(((await one.boundingBox())?.x ?? 0) - (before?.x ?? 0))).toBe(60);
  const middle = await centre(one);
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.wheel(0, -120);
  await expect.poll(async () => (await one.boundingBox())?.width ?? 0).toBeGreaterThan((before?.width ?? 0) * 1.1);
  expect(Math.abs((await centre(one)).x - middle.x)).toBeLessThan(2);
  await page.mouse.click(middle.x, middle.y, { button: "right" });
  await expect(page.getByRole("menuitemcheckbox", { name: /Enabled/ })).toBeVisible();
});

test("a slider is dragged live, typed into, and one drag is one step for Undo", async ({ page }) => {
  const slider = await place(page, "0<2<10", [220, 140]);
  const knob = await centre(slider.locator(".track .knob"));
  await drag(page, knob, { x: knob.x + 30, y: knob.y });
  const value = async () => Number(await slider.getByRole("slider").getAttribute("aria-valuenow"));
  await expect.poll(value).toBeGreaterThan(2);
  await page.keyboard.press("Control+z");
  await expect.poll(value).toBe(2);
  await slider.locator(".number").dblclick();
  await page.keyboard.type("3/4*8");
  await page.keyboard.press("Enter");
  await expect.poll(value).toBe(6);
});

test("a panel is written on, and shows what comes in", async ({ page }) => {
  const slider = await place(page, "0<2<10", [160, 140]);
  const panel = await place(page, '"note', [420, 180]);
  await panel.dblclick();
  await page.keyboard.type("another note");
  await page.keyboard.press("Escape");
  await expect(panel).toContainText("another note");
  await wire(page, grip(slider, "output"), grip(panel, "input"));
  await expect(panel.locator(".item-row")).toHaveText(/2$/);
});

test("groups are made, labelled, dragged with their members and taken away", async ({ page }) => {
  const one = await place(page, "addition", [220, 160]);
  const two = await place(page, "multiplication", [360, 160]);
  await ground(page).press("Control+a");
  await page.keyboard.press("Control+g");
  const group = page.locator("[data-group]");
  await expect(group).toHaveCount(1);
  const before = await centre(one);
  const middle = await centre(group);
  await drag(page, middle, { x: middle.x + 50, y: middle.y + 40 });
  await expect.poll(async () => Math.round((await centre(one)).y - before.y)).toBeGreaterThan(30);
  await page.mouse.click((await centre(group)).x, (await centre(group)).y, { button: "right" });
  await page.getByRole("textbox", { name: "Label" }).fill("Sums");
  await page.keyboard.press("Enter");
  await expect(group).toContainText("Sums");
  await page.keyboard.press("Control+Shift+g");
  await expect(group).toHaveCount(0);
  await expect(two).toBeVisible();
});

test("Alt copies what is dragged; copy and paste go through the clipboard", async ({ page }) => {
  const one = await place(page, "addition", [200, 140]);
  const middle = await centre(one);
  await drag(page, middle, { x: middle.x + 60, y: middle.y + 120 }, ["Alt"]);
  await expect(page.locator(".capsule")).toHaveCount(2);
  await ground(page).press("Control+a");
  await page.keyboard.press("Control+c");
  await page.keyboard.press("Control+v");
  await expect(page.locator(".capsule")).toHaveCount(4);
  await page.keyboard.press("Delete");
  await expect(page.locator(".capsule")).toHaveCount(2);
});

test("far away boxes are drawn, and can still be selected and dragged", async ({ page }) => {
  await place(page, "addition", [300, 200]);
  await page.mouse.move(...((at) => [at.x, at.y] as const)(await spot(page, [300, 200])));
  for (let k = 0; k < 8; k++) await page.mouse.wheel(0, 120);
  await expect(page.locator("canvas.far")).toHaveCount(1);
  await expect(page.locator("[data-object]")).toHaveCount(0);
  const at = await spot(page, [300, 200]);
  await drag(page, at, { x: at.x + 40, y: at.y });
  for (let k = 0; k < 8; k++) await page.mouse.wheel(0, -120);
  await expect(page.locator("[data-object]")).toHaveClass(/selected/);
});

test("the keyboard alone places, connects, goes and deletes", async ({ page }) => {
  await ground(page).focus();
  await page.keyboard.press("Space");
  await page.keyboard.type("0<4<10");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("slider")).toHaveCount(1);
  await page.keyboard.press("Space");
  await page.keyboard.type('"sum');
  await page.keyboard.press("Enter");
  await expect(page.locator(".panel")).toHaveCount(1);
  // The panel stands to the right of the slider.
  await page.keyboard.press("ArrowLeft");
  await expect(page.locator(".face-slider")).toHaveClass(/selected/);
  await page.keyboard.press("c");
  const list = page.getByRole("listbox");
  await expect(list.getByRole("option").first()).toBeVisible();
  await page.keyboard.press("Enter");
  await expect(wires(page)).toHaveCount(1);
  await page.keyboard.press("Delete");
  await expect(page.locator("[data-object]")).toHaveCount(1);
});

test("menus of a port flatten it and set how its wires are drawn", async ({ page }) => {
  const one = await place(page, "1<2<9", [160, 100]);
  const sum = await place(page, "addition", [450, 140]);
  await wire(page, grip(one, "output"), grip(sum, "input", 0));
  const name = sum.locator("[data-name-of]").first();
  await name.click({ button: "right" });
  await page.getByRole("menuitemcheckbox", { name: "Flatten" }).click();
  await expect(name).toContainText("↓");
  await name.click({ button: "right" });
  await page.getByRole("menuitem", { name: "Wire display" }).hover();
  await page.getByRole("menuitemcheckbox", { name: "Hidden" }).click();
  await ground(page).click({ position: { x: 20, y: 400 } });
  await expect(page.locator(".wire.wireless")).toHaveCount(1);
});

test("a tip tells what a port holds", async ({ page }) => {
  const one = await place(page, "1<2<9", [160, 100]);
  const panel = await place(page, '"x', [420, 160]);
  await wire(page, grip(one, "output"), grip(panel, "input"));
  const at = await centre(grip(panel, "input"));
  await page.mouse.move(at.x - 60, at.y - 60);
  await page.mouse.move(at.x, at.y, { steps: 3 });
  await expect(page.getByRole("tooltip")).toContainText("{0}");
  await expect(page.getByRole("tooltip")).toContainText("2");
});

test("F3 finds what is written on the canvas and goes there", async ({ page }) => {
  const panel = await place(page, '"needle in a haystack', [300, 200]);
  await place(page, "addition", [500, 120]);
  await page.keyboard.press("F3");
  await page.keyboard.type("haystack");
  await expect(page.getByRole("listbox").getByRole("option")).toHaveCount(1);
  await page.keyboard.press("Enter");
  await expect(panel).toHaveClass(/selected/);
});

test("Ctrl and Alt with a click show where a component lives in the tabs", async ({ page }) => {
  const one = await place(page, "addition", [300, 200]);
  const at = await centre(one);
  await page.keyboard.down("Control");
  await page.keyboard.down("Alt");
  await page.mouse.click(at.x, at.y);
  await page.keyboard.up("Alt");
  await page.keyboard.up("Control");
  await expect(page.getByRole("tab", { name: "Maths" })).toHaveAttribute("aria-selected", "true");
  await expect(page.getByRole("button", { name: "Addition" }).first()).toBeVisible();
});

test("a component of the tabs is placed with two clicks", async ({ page }) => {
  await page.getByRole("tab", { name: "Maths" }).click();
  await page.getByRole("button", { name: /^Operators/ }).click();
  await page.getByRole("button", { name: "Addition" }).last().click();
  const { x, y } = await spot(page, [300, 220]);
  await page.mouse.click(x, y);
  await expect(page.locator("[data-object]")).toHaveCount(1);
});
