// Writes the front page into a folder that has the book in `learn`: `node wasm/front/write.mjs FOLDER`. It needs no engine, so that
// the page can be looked at without one: figures stand still then.
import { copyFile, rename, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { frontPage } from "./page.mjs";

/** The studio's page gives its name to the front page, and lies beside it. */
export async function writeFront(folder) {
  await rename(join(folder, "index.html"), join(folder, "studio.html")).catch((error) => {
    if (error.code !== "ENOENT") throw error;
  });
  for (const [name, text] of Object.entries(await frontPage(folder))) await writeFile(join(folder, name), text);
  await copyFile(new URL("../../docs/attractor.svg", import.meta.url), join(folder, "attractor.svg"));
  await copyFile(new URL("../../studio/public/icon.svg", import.meta.url), join(folder, "icon.svg"));
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  if (!process.argv[2]) throw new Error("node wasm/front/write.mjs FOLDER");
  await writeFront(process.argv[2]);
}
