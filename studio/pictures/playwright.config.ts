import { defineConfig } from "@playwright/test";

import whole from "../playwright.config";

// The server is started as for the tests, from the studio's own folder.
const servers = [whole.webServer ?? []].flat().map((server) => ({ ...server, cwd: ".." }));

/** Pictures of the studio in documents: `make pictures`. */
export default defineConfig({ ...whole, testDir: ".", retries: 0, webServer: servers });
