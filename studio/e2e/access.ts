/** What a machine can say of whether everybody can use the page. */
import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";

import { expect } from "./test";

/**
 * The rules of WCAG 2.2 AA that a machine can check, and the best practice: nothing serious or critical may be left on
 * the page, or in a part of it.
 */
export async function isAccessible(page: Page, part?: Locator): Promise<void> {
  const builder = new AxeBuilder({ page });
  if (part) {
    // Axe takes parts by selectors, and looks about them as much as a rule needs.
    await part.first().evaluate((element) => element.setAttribute("data-axe", ""));
    builder.include("[data-axe]");
  }
  const { violations } = await builder
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"])
    .analyze();
  await part?.first().evaluate((element) => element.removeAttribute("data-axe"));
  const grave = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  const shown = ({ html, failureSummary = "" }: (typeof grave)[number]["nodes"][number]) => `${html} ${failureSummary}`;
  expect(grave.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(shown).join("\n")}`)).toEqual([]);
}
