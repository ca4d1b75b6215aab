import { defineConfig } from "@playwright/test";

import whole from "../playwright.config";

// The servers are started as for the tests, from the studio's own folder.
const servers = [whole.webServer ?? []].flat().map((server) => ({ ...server, cwd: ".." }));

export default defineConfig({ ...whole, testDir: ".", timeout: 300_000, retries: 0, webServer: servers });
