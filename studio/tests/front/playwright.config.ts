import { defineConfig } from "@playwright/test";

import site from "../site/playwright.config";

/** Tests of the front page without the engine: `make test-front`, which writes the folder first. */
export default defineConfig({
  ...site,
  outputDir: "../../test-results/front",
  use: { ...site.use, baseURL: "http://127.0.0.1:6595" },
  webServer: {
    command: "node tests/site/serve.mjs ../target/front 6595",
    cwd: "../..",
    url: "http://127.0.0.1:6595/index.html",
    reuseExistingServer: false,
  },
});
