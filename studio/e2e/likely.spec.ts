/** What mostly comes next: learnt from definitions that were opened, offered for the selected object. */
import { grip, ground, ids, newest, openCanvas, place, spot, wires, drag, centre } from "./canvas";
import { isAccessible } from "./access";
import { openText } from "./open";
import { expect, test } from "./test";

const TAUGHT = "katydid 1\na = Construct Point(1, 2, 3)\nb = Circle(a, 2)\nc = Circle(a, 3)\nd = Deconstruct(a)\n";

test("what followed a component in definitions that were opened is offered after it", async ({ page }, info) => {
  await openText(page, "taught.kd", TAUGHT);
  await openCanvas(page);
  const point = await place(page, "Construct Point", [120, 160], "Construct Point");
  const offered = page.getByRole("group", { name: "Likely next" });
  await expect(offered.getByRole("button")).toHaveCount(2);
  await expect(offered.getByRole("button").first()).toHaveAccessibleName("Place Circle after it");
  await page.screenshot({ path: info.outputPath("likely.png") });
  await isAccessible(page);
  const before = await ids(page);
  await offered.getByRole("button").first().click();
  const circle = await newest(page, before);
  await expect(circle).toContainText("C");
  await expect(wires(page)).toHaveCount(1);
  // A wire that is let go in the void finds them first too.
  await drag(page, await centre(grip(point, "output")), await spot(page, [300, 380]));
  const finds = page.getByRole("listbox", { name: "Search for a component" }).getByRole("option");
  await expect(finds.first()).toContainText("Circle");
  await expect(finds.nth(1)).toContainText("Deconstruct");
  await page.keyboard.press("Escape");
  await ground(page).focus();
  await page.getByRole("menuitem", { name: "Canvas", exact: true }).click();
  await page.getByRole("menuitemcheckbox", { name: "Likely next components" }).click();
  await expect(offered).toHaveCount(0);
});
