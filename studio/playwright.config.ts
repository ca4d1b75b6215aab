import { randomUUID } from "node:crypto";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { defineConfig } from "@playwright/test";

/** The binary with the page in it; `make test` builds it. */
const binary = process.env.KATYDID ?? "../target/release/katydid";
/**
 * With `PREVIEW=1` the page comes out of `dist/` and only the rest from the binary: what was changed in the page is
 * tested after `npm run build` alone.
 */
const preview = Boolean(process.env.PREVIEW);
const first = Number(process.env.PORT ?? 6598);
const [port, own] = preview ? [first, first + 1] : [first + 1, first];
const address = (at: number) => `http://127.0.0.1:${at}`;
// What the tests open and save is kept apart from what the person at the keyboard does.
const state = mkdtempSync(join(tmpdir(), "katydid-e2e-"));
// The processes that run the tests read this file too, and inherit the variable.
const token = (process.env.KATYDID_TOKEN ??= randomUUID());
/** As the studio gives it to whoever opens the address that it prints. */
const cookie = {
  name: `katydid_token_${port}`,
  value: token,
  domain: "127.0.0.1",
  path: "/",
  expires: -1,
  httpOnly: true,
  secure: false,
  sameSite: "Strict" as const,
};

const studio = {
  command: `${binary} studio --no-open --port ${port} --token ${token}`,
  url: `${address(port)}/api/start`,
  env: { XDG_STATE_HOME: state, XDG_CONFIG_HOME: state },
  reuseExistingServer: false,
};
const page = {
  command: `node_modules/.bin/vite preview --host 127.0.0.1 --port ${own} --strictPort`,
  url: address(own),
  env: { KATYDID_STUDIO: address(port) },
  reuseExistingServer: false,
};

export default defineConfig({
  testDir: "e2e",
  snapshotPathTemplate: "{testDir}/pictures/{arg}{ext}",
  // Two browsers share two processors: a bound that only a test that hangs reaches.
  timeout: 120_000,
  expect: { timeout: 15_000, toHaveScreenshot: { maxDiffPixelRatio: 0.005 } },
  // Two processors; `make test-browser` runs two halves side by side.
  workers: 1,
  // Where everything else runs beside it a browser can be late; what then needs a second try is named.
  retries: process.env.CI ? 2 : 0,
  reporter: [["line"]],
  use: {
    baseURL: address(preview ? own : port),
    storageState: { cookies: [cookie], origins: [] },
    actionTimeout: 20_000,
    viewport: { width: 1280, height: 800 },
    trace: "retain-on-failure",
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
    },
  },
  webServer: preview ? [studio, page] : [studio],
});
