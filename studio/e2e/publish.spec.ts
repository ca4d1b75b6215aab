/** Publishing from the canvas: which inputs the player shows, in which order, with which words. */
import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

const TEXT = "katydid 1\nlong = Number Slider(4.0, 1..9)\nwide = Number Slider(3.0, 1..9)\nsecret = Number Slider(7.0, 1..9)\nbox = Rectangle(plane((0, 0, 0)), long, wide)\n";

test("inputs are chosen, ordered and named on the canvas, and the player shows them so", async ({ page }, info) => {
  await openText(page, "box.kd", TEXT);
  await page.keyboard.press("Control+k");
  await page.keyboard.type("publish inputs");
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: "Publish inputs" });
  await expect(dialog).toBeVisible();
  await isAccessible(page, dialog);
  await dialog.getByRole("checkbox", { name: "secret" }).uncheck();
  await dialog.getByRole("button", { name: "wide up" }).click();
  await dialog.getByRole("textbox", { name: "What wide is called" }).fill("Breadth");
  await dialog.getByRole("textbox", { name: "Help for wide" }).fill("From wall to wall");
  await page.screenshot({ path: info.outputPath("publish.png") });
  await dialog.getByRole("button", { name: "Publish and show" }).click();
  await page.waitForURL(/player/);
  const inputs = page.getByRole("complementary", { name: "Inputs" });
  await expect(inputs.getByRole("slider")).toHaveCount(2);
  await expect(inputs.getByRole("slider").first()).toHaveAccessibleName(/^Breadth/);
  await expect(inputs.getByText("From wall to wall")).toBeVisible();
  await expect(inputs.getByRole("slider", { name: /^long/ })).toBeVisible();
  await page.screenshot({ path: info.outputPath("player.png") });
});
