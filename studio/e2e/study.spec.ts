/** The page on a study: a sweep that begins while the page is open, and the ways from it to a point and into the studio. */
import { type ChildProcess, execFile, spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { isAccessible } from "./access";
import { expect, test } from "./test";

const binary = process.env.KATYDID ?? "../target/release/katydid";
const token = process.env.KATYDID_TOKEN ?? "";
const port = Number(process.env.PORT ?? 6598) + 2;
const address = `http://127.0.0.1:${port}`;

/** Of its 25 points the 10 with x below 1 have no root. */
const DEFINITION = `katydid 1
x = Number Slider(1, 0.00..2.00)
n = Number Slider(3, 1..5)
root = Expression("Sqrt(x - 1) * n", x = x, n = n) hidden
sum = Addition(x, n) hidden
c = Circle(plane((0, 0, 0)), n)
`;
const PLAN = { inputs: { x: { steps: 5 }, n: {} }, outputs: ["sum", "root"], pictures: true };

const cookie = { name: `katydid_token_${port}`, value: token, domain: "127.0.0.1", path: "/", expires: -1, httpOnly: true, secure: false, sameSite: "Strict" as const };
test.use({ baseURL: address, storageState: { cookies: [cookie], origins: [] } });
test.describe.configure({ mode: "serial" });

let folder = "";
let server: ChildProcess | undefined;

test.beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "katydid-study-"));
  writeFileSync(join(folder, "roots.kd"), DEFINITION);
  writeFileSync(join(folder, "plan.json"), JSON.stringify(PLAN));
  server = spawn(binary, ["study", folder, "--no-open", "--port", String(port), "--token", token], { env: { ...process.env, XDG_STATE_HOME: folder, XDG_CONFIG_HOME: folder } });
  const ready = new Promise((told) => server?.stdout?.once("data", told));
  const ended = new Promise((_, failed) => server?.once("exit", (code) => failed(new Error(`katydid study ended with ${code}`))));
  await Promise.race([ready, ended]);
});

test.afterAll(() => {
  server?.removeAllListeners("exit");
  server?.kill();
  rmSync(folder, { recursive: true, force: true });
});

const sweep = () =>
  // Some points have no results: the exit code is 1 then.
  new Promise<void>((done) => execFile(binary, ["sweep", join(folder, "roots.kd"), "--plan", join(folder, "plan.json"), "-o", folder], () => done()));

test("points of a sweep appear without a reload; brushes, goals and a point are one selection everywhere", async ({ page, context }, info) => {
  await page.goto("/study");
  await expect(page.getByText("No point is solved yet")).toBeVisible();
  await sweep();
  await expect(page.getByTestId("count")).toHaveText("25 points");
  await expect(page.getByText("10 without results")).toBeVisible();
  const table = page.getByRole("table");
  await expect(table).toHaveAttribute("aria-rowcount", "26");
  await expect(table.getByRole("row").filter({ hasText: "✕" })).toHaveCount(10);

  // A brush by the keyboard, in steps of a tenth of the axis: n from 1 to 3.4.
  const handle = page.getByRole("slider", { name: "n, highest" });
  await handle.focus();
  for (let k = 0; k < 4; k += 1) await page.keyboard.press("PageDown");
  await expect(handle).toHaveAttribute("aria-valuetext", "3.4");
  await expect(page.getByTestId("selected")).toHaveText("15 selected");
  await expect(table).toHaveAttribute("aria-rowcount", "16");
  await expect(page.getByRole("region", { name: "Pictures" }).getByRole("listitem")).toHaveCount(9);
  // And one by the mouse: the upper half of x.
  const area = await page.locator('[data-axis="in.x"] .brush-area').boundingBox();
  if (!area) throw new Error("the axis of x is not there");
  await page.mouse.move(area.x + area.width / 2, area.y + 2);
  await page.mouse.down();
  await page.mouse.move(area.x + area.width / 2, area.y + area.height * 0.6, { steps: 4 });
  await page.mouse.up();
  await expect(page.getByTestId("selected")).toHaveText("9 selected");

  // Small sums and large roots: of x 1, 1.5, 2 and n 1, 2, 3.
  await page.getByRole("combobox", { name: "Goal for sum" }).selectOption("least");
  await page.getByRole("combobox", { name: "Goal for root" }).selectOption("most");
  // Sums 2, 2.5, 3, 3.5, 4, 4.5, 5 with roots 0, 0.71, 1, 1.41, 2, 2.12, 3; with x 1, n 2 and 3 add to the sum alone.
  await expect(page.getByTestId("front")).toHaveText("7 on the front");
  await expect(table.getByRole("row").filter({ hasText: "◆ front" })).toHaveCount(7);
  await isAccessible(page);

  // The points of x 2 are 20 to 24.
  await table.getByRole("button", { name: "Point 22", exact: true }).click();
  const detail = page.locator(".detail");
  await expect(detail.getByRole("heading", { name: "Point 22" })).toBeVisible();
  await expect.poll(() => detail.getByRole("img").evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(640);
  await page.screenshot({ path: info.outputPath("study.png"), fullPage: true });
  const [opened] = await Promise.all([context.waitForEvent("page"), detail.getByRole("button", { name: "Open in the studio" }).click()]);
  await expect(opened).toHaveURL(/document=/);
  for (const [name, value] of [["x", "2"], ["n", "3"]] as const) {
    await expect(opened.getByRole("slider", { name, exact: true }).first()).toHaveAttribute("aria-valuenow", value);
  }
});

test("a point without results says why, and is opened with its values too", async ({ page }) => {
  await page.goto("/study");
  await page.getByRole("table").getByRole("button", { name: "Point 0", exact: true }).click();
  await expect(page.locator(".detail .outcome")).toContainText("root");
  await page.getByRole("button", { name: "Open in the studio" }).click();
  await expect(page.getByRole("link", { name: "Open it here" })).toBeVisible();
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`nothing on the page of a study stands in anybody's way (${colorScheme}, narrow)`, async ({ page }, info) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 390, height: 844 });
    await page.goto("/study");
    await page.getByRole("table").getByRole("button", { name: "Point 22", exact: true }).click();
    // Rows that are scrolled below the head of the table are covered by it, and scrolled back by whoever wants them.
    await page.locator(".table-area").evaluate((area) => area.scrollTo(0, 0));
    await isAccessible(page);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await page.screenshot({ path: info.outputPath("narrow.png") });
  });
}
