/** What docs/canvas-tiers.md lists and no other test holds. */
import { centre, ids, newest, openCanvas, place, wire, grip, wires } from "./canvas";
import { openText } from "./open";
import { expect, test } from "./test";

const CHAIN = `katydid 1\na = Number Slider(2, 0..10)\nb = Number Slider(3, 0..10)\nsum = Mass Addition([a, b])\nlist = Panel(sum.Result)\n\nlayout {\n    a: 40 40\n    b: 40 100\n    sum: 300 60\n    list: 480 40 [480 40 120 60]\n}\n`;

test("a floating parameter is a small box with a grip on each side", async ({ page }) => {
  await openCanvas(page);
  const point = await place(page, "Point", [160, 160], "Point");
  await expect(point.locator(".grip.input")).toHaveCount(1);
  await expect(point.locator(".grip.output")).toHaveCount(1);
  const [box, input, output] = [await point.boundingBox(), await centre(grip(point, "input")), await centre(grip(point, "output"))];
  expect(Math.abs(input.x - (box?.x ?? 0))).toBeLessThan(2);
  expect(Math.abs(output.x - (box?.x ?? 0) - (box?.width ?? 0))).toBeLessThan(2);
  expect(box?.height).toBeLessThan(30);
});

test("the profiler writes below each object how long it took", async ({ page }) => {
  await openText(page, "many.kd", `katydid 1\nmany = Range(0..1, 20000)\nroots = Square Root(many)\n`);
  await expect(page.locator(".profile")).toHaveCount(0);
  await page.getByRole("menuitem", { name: "Canvas", exact: true }).click();
  await page.getByRole("menuitemcheckbox", { name: /Profiler/ }).click();
  await expect(page.locator(".profile").first()).toContainText(/ms|s$/);
});

test("an input's menu names each of its sources, shows the wire that is pointed at, and takes it away", async ({ page }) => {
  await openText(page, "chain.kd", CHAIN);
  const sum = page.getByRole("group", { name: /^sum/ });
  await sum.locator(".grip.input").first().click({ button: "right" });
  await page.getByRole("menuitem", { name: "Disconnect" }).hover();
  const entry = page.getByRole("menuitem", { name: "b", exact: true });
  await entry.hover();
  await expect(page.locator(".wire.hot")).toHaveCount(1);
  await expect(wires(page)).toHaveCount(3);
  await entry.click();
  await expect(wires(page)).toHaveCount(2);
  await expect(page.getByRole("group", { name: /^list/ })).toContainText("2");
});

test("a double-click on a wire puts a relay in it, and the data goes on", async ({ page }) => {
  await openCanvas(page);
  const from = await place(page, "5", [100, 160]);
  const to = await place(page, '"', [480, 160]);
  await wire(page, grip(from, "output"), grip(to, "input"));
  await expect(wires(page)).toHaveCount(1);
  const before = await ids(page);
  const [a, b] = [await centre(grip(from, "output")), await centre(grip(to, "input"))];
  await page.mouse.dblclick((a.x + b.x) / 2, (a.y + b.y) / 2);
  const relay = await newest(page, before);
  await expect(relay).toBeVisible();
  await expect(wires(page)).toHaveCount(2);
  await expect(to).toContainText("5");
});

test("the canvas is kept as a picture", async ({ page }) => {
  await openText(page, "chain.kd", CHAIN);
  await page.getByRole("menuitem", { name: "File", exact: true }).click();
  await page.getByRole("menuitem", { name: /^Export/ }).click();
  const kept = page.waitForEvent("download");
  await page.getByRole("dialog").getByRole("button", { name: /SVG/i }).last().click();
  const stream = await (await kept).createReadStream();
  const parts: Buffer[] = [];
  for await (const part of stream) parts.push(part as Buffer);
  const text = Buffer.concat(parts).toString();
  expect(text).toMatch(/^<svg|^<\?xml/);
  expect(text).toContain("sum");
});

test("what a panel shows is aligned, and drawn without its indices, by its menu", async ({ page }) => {
  await openText(page, "chain.kd", CHAIN);
  const list = page.getByRole("group", { name: /^list/ });
  await expect(list).toContainText("5");
  const choose = async (...names: string[]) => {
    await list.click({ button: "right", position: { x: 60, y: 6 } });
    for (const name of names.slice(0, -1)) await page.getByRole("menuitem", { name, exact: true }).hover();
    // What is on has a tick before its name.
    await page.getByRole("menuitemcheckbox", { name: new RegExp(`^(✓ ?)?${names.at(-1)}$`) }).click();
  };
  await expect(list).toHaveCSS("text-align", "left");
  await choose("Alignment", "Right");
  await expect(list).toHaveCSS("text-align", "right");
  await expect(list.locator(".index")).toHaveText("0");
  await choose("Draw indices");
  await expect(list.locator(".index")).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect(list).toHaveCSS("text-align", "left");
  await expect(list.locator(".index")).toHaveText("0");
});

test("while the canvas is panned a picture of it is moved; at rest and when it is zoomed it is drawn", async ({ page }) => {
  await openText(page, "chain.kd", CHAIN);
  const kept = () => page.locator(".react-flow__viewport").evaluate((element) => getComputedStyle(element).willChange);
  const slider = page.getByRole("group", { name: /^a,/ });
  const before = await centre(slider);
  expect(await kept()).toBe("auto");
  await page.mouse.move(before.x + 40, before.y + 200);
  await page.mouse.down({ button: "right" });
  // It is kept for a moment after each move: the hand goes on moving until it was looked at in time.
  let step = 0;
  await expect
    .poll(async () => {
      step += 1;
      await page.mouse.move(before.x + 50 + (step % 2) * 4, before.y + 207);
      return await kept();
    })
    .toBe("transform");
  await page.mouse.move(before.x + 60, before.y + 215);
  await page.mouse.up({ button: "right" });
  await expect.poll(kept).toBe("auto");
  const after = await centre(slider);
  expect([after.x - before.x, after.y - before.y].map(Math.round)).toEqual([20, 15]);
  await page.mouse.wheel(0, -120);
  expect(await kept()).toBe("auto");
});
