import { openFromGallery, openNew } from "./open";
import { expect, test } from "./test";

test("the start page offers a new definition, a file and the book's definitions", async ({ page }) => {
  await page.goto("/");
  await expect(page.getByRole("heading", { name: "Katydid", level: 1 })).toBeVisible();
  await expect(page.getByRole("button", { name: "New definition" })).toBeVisible();
  await expect(page.getByRole("button", { name: /^Anchor, vector, tip/ })).toBeVisible();
});

test("without the token nobody gets the page", async ({ browser, baseURL }) => {
  test.skip(Boolean(process.env.PREVIEW), "the page does not come out of the binary");
  const context = await browser.newContext({ storageState: { cookies: [], origins: [] }, ...(baseURL && { baseURL }) });
  const page = await context.newPage();
  expect((await page.goto("/"))?.status()).toBe(401);
  // The address that is printed lets in; the cookie does so from then on.
  await page.goto(`/?token=${process.env.KATYDID_TOKEN}`);
  await expect(page.getByRole("button", { name: "New definition" })).toBeVisible();
  await page.goto("/");
  await page.getByRole("button", { name: "New definition" }).click();
  await page.waitForURL(/document=/);
  await expect(page.getByRole("region", { name: "Canvas", exact: true })).toBeVisible();
  await context.close();
});

test.describe("a file that is no definition", () => {
  test.use({ excused: [/status of 4\d\d/] });

  test("is refused with a reason", async ({ page }) => {
    await page.goto("/");
    await page.locator("input[type=file]").setInputFiles({ name: "x.gh", mimeType: "application/octet-stream", buffer: Buffer.from("%PDF-1.4") });
    await expect(page.getByRole("alert")).not.toBeEmpty();
  });
});

test("every command is found by its name", async ({ page }) => {
  await openFromGallery(page, /Anchor, vector, tip/);
  await page.keyboard.press("Control+k");
  const field = page.getByRole("combobox", { name: "Type a command" });
  await field.fill("outl");
  await expect(page.getByRole("dialog").getByRole("option", { selected: true })).toContainText("Outline");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("complementary", { name: "Outline" })).toBeVisible();
  await expect(page.getByRole("complementary")).toContainText("reads");
});

test("the sheet of shortcuts opens with ? and closes with Escape", async ({ page }) => {
  await openNew(page);
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog", { name: "Keyboard shortcuts" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
});

test("document settings are edits that Undo takes back", async ({ page }) => {
  await openNew(page);
  await page.keyboard.press("Control+,");
  await page.getByRole("combobox", { name: "Units" }).selectOption("Meters");
  await page.getByRole("button", { name: "Apply" }).click();
  await expect(page.locator(".status")).toContainText("Meters");
  await page.keyboard.press("Control+z");
  await expect(page.locator(".status")).not.toContainText("Meters");
});

test("menus are walked with the arrow keys", async ({ page }) => {
  await openNew(page);
  await page.getByRole("menuitem", { name: "File" }).focus();
  await page.keyboard.press("ArrowDown");
  await expect(page.getByRole("menu", { name: "File" })).toBeVisible();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("menu", { name: "File" })).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect(page.getByRole("menu")).toHaveCount(0);
});

test("the theme is kept", async ({ page }) => {
  await openNew(page);
  await page.keyboard.press("Control+k");
  await page.getByRole("dialog").getByRole("combobox").fill("dark theme");
  await page.keyboard.press("Enter");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.reload();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});
