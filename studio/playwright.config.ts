import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { defineConfig } from "@playwright/test";

/** The binary with the page in it; `make test` builds it. */
const binary = process.env.KATYDID ?? "../target/release/katydid";
const port = 6599;
const state = mkdtempSync(join(tmpdir(), "katydid-e2e-"));

export default defineConfig({
  testDir: "e2e",
  timeout: 60_000,
  expect: { timeout: 15_000, toHaveScreenshot: { maxDiffPixelRatio: 0.005 } },
  // Two processors, one of them for the server.
  workers: 1,
  retries: process.env.CI ? 1 : 0,
  reporter: [["line"]],
  use: {
    baseURL: `http://127.0.0.1:${port}`,
    viewport: { width: 1280, height: 800 },
    trace: "retain-on-failure",
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
    },
  },
  webServer: {
    command: `${binary} studio --no-open --port ${port}`,
    url: `http://127.0.0.1:${port}/api/start`,
    env: { XDG_STATE_HOME: state },
    reuseExistingServer: false,
  },
});
