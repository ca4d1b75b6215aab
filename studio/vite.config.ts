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

export default defineConfig({
  plugins: [react(), policy()],
  base: "./",
  build: { outDir: "dist", target: "es2022", chunkSizeWarningLimit: 1600 },
  server: {
    proxy: {
      "/api": asked,
      "/geometry": asked,
      "/image": asked,
      "/socket": { ...asked, ws: true },
    },
  },
  test: { include: ["tests/unit/**/*.test.ts", "tests/studio/**/*.test.{ts,tsx}"], environment: "node" },
});
