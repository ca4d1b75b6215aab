import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

/** Where `katydid studio` listens while the page is developed with `npm run dev`. */
const server = process.env.KATYDID_STUDIO ?? "http://127.0.0.1:6510";

export default defineConfig({
  plugins: [react()],
  base: "./",
  build: { outDir: "dist", target: "es2022", chunkSizeWarningLimit: 1600 },
  server: {
    proxy: {
      // The server takes changes from pages of its own address only: this page speaks for one.
      "/api": { target: server, changeOrigin: true, headers: { origin: server } },
      "/geometry": server,
      "/image": server,
      "/socket": { target: server, ws: true },
    },
  },
  test: { include: ["tests/unit/**/*.test.ts", "tests/studio/**/*.test.{ts,tsx}"], environment: "node" },
});
