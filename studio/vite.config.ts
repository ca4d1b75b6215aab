import { fileURLToPath } from "node:url";

import react from "@vitejs/plugin-react";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";

/** Where `katydid studio` listens while the page is developed with `npm run dev`, or looked at with `vite preview`. */
const server = process.env.KATYDID_STUDIO ?? "http://127.0.0.1:6510";

/** The binary answers its own page alone: it must see the address that the browser asked for. */
const asked = { target: server, changeOrigin: false };

/** The built page is shown under the policy that the binary gives it: what that forbids is found early. */
function policy(): Plugin {
  return {
    name: "policy-of-the-binary",
    configurePreviewServer({ middlewares }) {
      const name = "content-security-policy";
      const asked = fetch(server, { method: "HEAD" }).then(({ headers }) => headers.get(name), () => null);
      middlewares.use((_, response, next) => {
        void asked.then((told) => {
          if (told) response.setHeader(name, told);
          next();
        });
      });
    },
  };
}

/**
 * What a page without a server allows itself. It stands in the page: whoever serves the folder need not know of it. A module
 * is compiled where the policy names that (`wasm-unsafe-eval`); nothing is asked of any other address.
 */
const ALLOWED = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "font-src 'self' data:",
  "worker-src 'self' blob:",
  "object-src 'none'",
  "base-uri 'none'",
].join("; ");

/** The page of the site: its policy, and the worker that keeps it for when there is no network. */
function site(): Plugin {
  return {
    name: "page-of-the-site",
    transformIndexHtml: () => [
      { tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content: ALLOWED }, injectTo: "head-prepend" },
    ],
  };
}

/** The site has the book's script too, under a name that its pages know, and one engine for both. */
const SITE = {
  input: { index: "index.html", learn: "src/learn/main.ts" },
  output: { entryFileNames: ({ name }: { name: string }) => (name === "learn" ? "assets/learn.js" : "assets/[name]-[hash].js") },
};

/** The binary serves the page on a study beside the studio; a site has no folders to look at. */
const SERVED = { input: { index: "index.html", study: "study.html" } };

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** `vite build --mode site` makes the studio without a server (`make site`). */
export default defineConfig(({ mode }) => ({
  plugins: [react(), policy(), ...(mode === "site" ? [site()] : [])],
  base: "./",
  resolve: {
    alias: {
      "#engine": here(mode === "site" ? "src/engine/index.ts" : "src/engine/none.ts"),
      "#ways": here(mode === "site" ? "src/learn/alone/index.ts" : "src/learn/server.ts"),
      "katydid-engine": here("../wasm/index.js"),
    },
  },
  worker: { format: "es" },
  build: {
    outDir: mode === "site" ? "../site" : "dist",
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1600,
    rolldownOptions: mode === "site" ? SITE : SERVED,
  },
  server: {
    proxy: {
      "/api": asked,
      "/geometry": asked,
      "/image": asked,
      "/socket": { ...asked, ws: true },
    },
  },
  test: { include: ["tests/unit/**/*.test.ts", "tests/studio/**/*.test.{ts,tsx}"], environment: "node" },
}));
