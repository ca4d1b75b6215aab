/** Writes the sheet of all icons into the documents. */

import { mkdirSync, writeFileSync } from "node:fs";
import { createServer } from "vite";

const docs = new URL("../../docs/", import.meta.url);
const server = await createServer({ server: { middlewareMode: true }, appType: "custom", logLevel: "error" });
const { sheet } = await server.ssrLoadModule("/icons/sheet.ts");
mkdirSync(new URL("icons/", docs), { recursive: true });
for (const [name, text] of sheet()) writeFileSync(new URL(name, docs), text);
await server.close();
