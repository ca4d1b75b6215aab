// What the site has besides the page: the front page, pictures of the gallery's definitions, the book's way to the engine, and the worker that keeps all of it for when
// there is no network. `node wasm/site.mjs FOLDER`, after the page was built into the folder.
import { createHash } from "node:crypto";
import { mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { join, relative, sep } from "node:path";

import { writeFront } from "./front/write.mjs";
import { init, raw } from "./index.js";

const folder = process.argv[2];
if (!folder) throw new Error("node wasm/site.mjs FOLDER");

await init();
await mkdir(join(folder, "portraits"), { recursive: true });
for (const { id } of JSON.parse(raw.gallery())) {
  const picture = raw.portrait(raw.galleryText(id));
  if (picture) await writeFile(join(folder, "portraits", `${id}.png`), picture);
}

// The pages of the book, where they were built into the folder, load the script that finds the engine here.
const book = join(folder, "learn", "assets");
for (const entry of await readdir(book, { withFileTypes: true }).catch(() => [])) {
  if (!entry.isDirectory()) continue;
  const parts = join(book, entry.name);
  await rm(parts, { recursive: true });
  await mkdir(parts);
  await writeFile(join(parts, "learn.js"), 'import "../../../assets/learn.js";\n');
}

await writeFront(folder);

const files = (await readdir(folder, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile() && entry.name !== "sw.js")
  .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join("/"))
  .sort();
const hash = createHash("sha256");
for (const file of files) hash.update(file).update(await readFile(join(folder, file)));
const worker = await readFile(new URL("sw.js", import.meta.url), "utf8");
const list = JSON.stringify(files, undefined, 1);
const version = hash.digest("hex").slice(0, 16);
await writeFile(join(folder, "sw.js"), worker.replace("const FILES = [];", `const FILES = ${list};`).replace("VERSION", version));
console.log(`${files.length} files, version ${version}`);
