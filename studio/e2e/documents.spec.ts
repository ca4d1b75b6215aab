/** Ways between documents: templates, looking at a definition without running it, the switcher, and the way back on a canvas. */
import { ground, openCanvas, place, spot } from "./canvas";
import { openText } from "./open";
import { expect, test } from "./test";

test("new definitions begin as the template, until it is forgotten", async ({ page }) => {
  await openText(page, "office.kd", `katydid 1\nour standard = Panel("drawn by us")\n`);
  const run = async (words: string) => {
    await page.keyboard.press("Control+k");
    await page.keyboard.type(words);
    await page.keyboard.press("Enter");
  };
  await run("use as a template");
  await expect(page.getByText("New definitions begin as this one.")).toBeVisible();
  await page.goto("/");
  await page.getByRole("button", { name: "New definition" }).click();
  await expect(page.getByRole("group", { name: /^our standard/ })).toContainText("drawn by us");
  await run("forget the template");
  await page.goto("/");
  await page.getByRole("button", { name: "New definition" }).click();
  await expect(ground(page)).toBeVisible();
  await expect(page.locator("[data-object]")).toHaveCount(0);
});

test("a definition that is only examined runs when it is recomputed", async ({ page }) => {
  await openCanvas(page);
  await page.evaluate(() => {
    const files = new DataTransfer();
    files.items.add(new File([`katydid 1\nsum = Addition(1, 2)\nlist = Panel(sum)\n`], "mine.kd"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
  });
  const before = page.url();
  await page.getByRole("button", { name: /^Examine/ }).click();
  await page.waitForURL((url) => url.toString() !== before);
  const panel = page.getByRole("group", { name: /^list/ });
  await expect(panel).toBeVisible();
  await expect(panel).not.toContainText("3");
  await page.keyboard.press("F5");
  await expect(panel).toContainText("3");
});

test("the switcher of documents has their pictures", async ({ page }) => {
  await openText(page, "pictured ball.kd", "katydid 1\nball = Sphere(plane((0, 0, 0)), 3)\n");
  await expect.poll(() => page.evaluate(() => window.__studio?.viewport?.stats()?.objects)).toBe(1);
  await openCanvas(page);
  await page.keyboard.press("Control+Shift+K");
  const entry = page.getByRole("dialog").getByRole("button", { name: /^pictured ball/ }).last();
  await expect(entry.locator("img")).toBeVisible();
});

test("where nothing of a definition is in sight an arrow leads back", async ({ page }) => {
  await openCanvas(page);
  const slider = await place(page, "5", [200, 150]);
  const { x, y } = await spot(page, [300, 300]);
  const back = page.getByRole("button", { name: "Back to the definition" });
  await expect(back).toHaveCount(0);
  await page.mouse.move(x, y);
  for (let k = 0; k < 4; k++) {
    await page.mouse.down({ button: "right" });
    await page.mouse.move(x - 280, y - 260, { steps: 4 });
    await page.mouse.up({ button: "right" });
    await page.mouse.move(x, y);
  }
  await expect(back).toBeVisible();
  await back.click();
  await expect(slider).toBeInViewport();
  await expect(back).toHaveCount(0);
});
