import { defineConfig } from "@playwright/test";

/** Tests of the studio without a server: `make test-site`, which builds the folder first. */
export default defineConfig({
  testDir: ".",
  outputDir: "../../test-results/site",
  timeout: 120_000,
  expect: { timeout: 30_000 },
  workers: 1,
  retries: process.env.CI ? 2 : 0,
  reporter: [["line"]],
  use: {
    baseURL: "http://127.0.0.1:6596",
    viewport: { width: 1280, height: 800 },
    permissions: ["clipboard-read", "clipboard-write"],
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
    },
  },
  webServer: {
    command: "node tests/site/serve.mjs ../site 6596",
    cwd: "../..",
    url: "http://127.0.0.1:6596/index.html",
    reuseExistingServer: false,
  },
});
