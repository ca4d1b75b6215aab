import { resolve } from "node:path";

import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";

/** Serves the page of these tests; nothing of it is in the studio's own page. */
export default defineConfig({
  root: resolve(import.meta.dirname, "../.."),
  plugins: [react()],
  server: { port: 6597, strictPort: true, hmr: false },
  optimizeDeps: { include: ["react-dom/client", "three", "zustand", "zustand/vanilla"] },
});
