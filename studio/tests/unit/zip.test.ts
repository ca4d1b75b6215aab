import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { expect, test } from "vitest";

import { crc32, zipOf } from "../../src/core/zip";

test("the checksum is that of the format", () => {
  // The check value that catalogues of checksums give for CRC-32.
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});

test("another program reads the archive", async () => {
  const bytes = (text: string) => new TextEncoder().encode(text);
  const blob = zipOf([
    { name: "turn-01.png", bytes: bytes("first") },
    { name: "übung.txt", bytes: bytes("") },
  ]);
  const folder = mkdtempSync(join(tmpdir(), "katydid-zip-"));
  const file = join(folder, "film.zip");
  writeFileSync(file, new Uint8Array(await blob.arrayBuffer()));
  const script = "import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nassert z.testzip() is None\nprint([(n, z.read(n).decode()) for n in z.namelist()])";
  const said = execFileSync("python3", ["-c", script, file], { encoding: "utf8", env: { ...process.env, PYTHONIOENCODING: "utf-8" } });
  expect(said.trim()).toBe("[('turn-01.png', 'first'), ('übung.txt', '')]");
  expect(readFileSync(file).length).toBe(blob.size);
});
