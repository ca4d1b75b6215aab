import { defineConfig } from "@playwright/test";

/** Tests of the viewport by itself, without a server: `npm run e2e:viewport`. */
export default defineConfig({
  testDir: ".",
  outputDir: "../../test-results/viewport",
  snapshotPathTemplate: "{testDir}/pictures/{arg}{ext}",
  timeout: 120_000,
  expect: { timeout: 15_000, toHaveScreenshot: { maxDiffPixelRatio: 0.005 } },
  workers: 1,
  retries: process.env.CI ? 2 : 0,
  reporter: [["line"]],
  use: {
    baseURL: "http://127.0.0.1:6597",
    viewport: { width: 660, height: 520 },
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
    },
  },
  webServer: {
    command: "npx vite --config tests/viewport/vite.config.ts --host 127.0.0.1",
    cwd: "../..",
    url: "http://127.0.0.1:6597/tests/viewport/page.html",
    reuseExistingServer: true,
  },
});
