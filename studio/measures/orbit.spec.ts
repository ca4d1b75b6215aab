/** How long a picture takes while the camera turns about a model of 40,000 triangles, in each display mode. */
import { openFromGallery } from "../e2e/open";
import { expect, test } from "../e2e/test";

const TURNS = 40;

test("turning about the twisted tower with 60 floors", async ({ page }) => {
  await openFromGallery(page, /^Twisted tower/);
  await page.goto(`${page.url()}&player`);
  await page.getByRole("spinbutton", { name: /floors/ }).fill("60");
  await expect.poll(() => page.evaluate(() => window.__studio?.viewport?.stats()?.triangles)).toBeGreaterThan(35_000);
  for (const mode of ["shaded", "ghosted", "rendered"]) {
    await page.locator(".viewport-popover > button").first().click();
    await page.getByRole("radiogroup").getByRole("radio", { name: new RegExp(`^${mode}$`, "i") }).check();
    await page.keyboard.press("Escape");
    await page.waitForTimeout(1500);
    const found = await page.evaluate((turns) => {
      const hook = window.__studio!.viewport!;
      const quick: number[] = [];
      const canvas = document.querySelector<HTMLCanvasElement>(".viewport-canvas")!;
      const press = (type: string, x: number) =>
        canvas.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x, clientY: 300, button: 2, buttons: 2, bubbles: true, pointerType: "mouse" }));
      canvas.setPointerCapture = () => {};
      press("pointerdown", 300);
      for (let k = 1; k <= turns; k++) {
        press("pointermove", 300 + 6 * k);
        quick.push(hook.draw(false) ?? 0);
      }
      press("pointerup", 300);
      const fine = [hook.draw(true) ?? 0, hook.draw(true) ?? 0, hook.draw(true) ?? 0];
      quick.sort((a, b) => a - b);
      return { median: quick[turns >> 1]!, most: quick[Math.floor(turns * 0.95)]!, fine: Math.min(...fine), triangles: hook.stats()!.triangles };
    }, TURNS);
    const [median, most, fine] = [found.median, found.most, found.fine].map((value) => value.toFixed(0));
    console.log(`${mode}: ${found.triangles} triangles, a picture while turning ${median} ms, 95th percentile ${most} ms, at rest ${fine} ms`);
  }
});
