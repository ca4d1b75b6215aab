/** The script of the book's pages, built beside the studio's page into the same folder. */
import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  publicDir: false,
  build: {
    outDir: "dist/learn",
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1600,
    modulePreload: false,
    cssCodeSplit: false,
    rolldownOptions: {
      input: "src/learn/main.ts",
      output: { entryFileNames: "learn.js", chunkFileNames: "[name].js", assetFileNames: "learn[extname]" },
    },
  },
});
