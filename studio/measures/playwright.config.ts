import { defineConfig } from "@playwright/test";

import whole from "../playwright.config";

// The servers are started as for the tests, from the studio's own folder.
const servers = [whole.webServer ?? []].flat().map((server) => ({ ...server, cwd: ".." }));

/** A trace takes pictures of the page and of its elements all the time: it would be measured too. */
const use = { ...whole.use, trace: "off" as const };

export default defineConfig({ ...whole, use, testDir: ".", testIgnore: "site/**", timeout: 300_000, retries: 0, webServer: servers });
