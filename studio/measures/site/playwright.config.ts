import { defineConfig } from "@playwright/test";

import site from "../../tests/site/playwright.config";

/** A trace takes pictures of the page all the time: it would be measured too. */
const use = { ...site.use, trace: "off" as const };

export default defineConfig({ ...site, use, testDir: ".", outputDir: "../../test-results/measures", timeout: 300_000, retries: 0 });
