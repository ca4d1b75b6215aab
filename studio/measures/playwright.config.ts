import { defineConfig } from "@playwright/test";

import whole from "../playwright.config";

export default defineConfig({ ...whole, testDir: ".", timeout: 300_000, retries: 0 });
