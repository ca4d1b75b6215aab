import { openText } from "./open";
import { expect, test } from "./test";

const CHARTS = `katydid 1
values = Panel("2\\n-1\\n4", lines = true)
bars = Bar Graph(values)
pie = Pie Chart(values)
line = Quick Graph(values)

layout {
    values: 0 0 [0 0 100 80]
    bars: 140 0 [140 0 180 120]
    pie: 340 0 [340 0 140 120]
    line: 500 0 [500 0 160 120]
}
`;

test("charts are drawn of their data, and told", async ({ page }, info) => {
  await openText(page, "charts.kd", CHARTS);
  const bars = page.getByRole("img", { name: "bars: 2, -1, 4" });
  await expect(bars.locator("rect[class^=colour]")).toHaveCount(3);
  // The longest bar is four times as high as the shortest, and the second hangs down from where the others stand.
  const heights = await bars.locator("rect[class^=colour]").evaluateAll((rects) => rects.map((rect) => Number(rect.getAttribute("height"))));
  expect((heights[2] ?? 0) / (heights[1] ?? 1)).toBeCloseTo(4, 3);
  const pie = page.getByRole("img", { name: "pie: 2 (28.6 %), -1 (14.3 %), 4 (57.1 %)" });
  await expect(pie.locator("path")).toHaveCount(3);
  const line = page.getByRole("img", { name: "line: 2, -1, 4" });
  await expect(line.locator("polyline")).toHaveAttribute("points", /^0,.* 74,108 148,0$/);
  await page.screenshot({ path: info.outputPath("charts.png") });
});

test("a Value Tracker draws what its value was", async ({ page }) => {
  await openText(page, "tracker.kd", "katydid 1\nn = Number Slider(2, 0..10)\nseen = Value Tracker(n)\n");
  await expect(page.getByRole("img", { name: "seen: 2", exact: true })).toBeVisible();
  await page.getByRole("slider", { name: "n" }).press("End");
  const tracker = page.getByRole("img", { name: "seen: 2 → 10", exact: true });
  await expect(tracker.locator("polyline")).toHaveAttribute("points", /^0,\d+ \d+,0$/);
});
