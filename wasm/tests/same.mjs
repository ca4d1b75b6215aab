// The engine for pages beside the program, on all definitions of the book, the examples and the shared data: the same values
// to the last bit, the same models byte by byte, the same status of each object. `node wasm/tests/same.mjs KATYDID [FOLDER …]`.
//
// Where the two differ on purpose is named: the program reads files and says otherwise what it says of Python and of other
// servers, and what hangs on those has other data.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

import { init, open } from "../index.js";

const [program, ...places] = process.argv.slice(2);
if (!program) throw new Error("node wasm/tests/same.mjs KATYDID [FOLDER …]");

/** A solve takes no longer, on either side; what takes longer is not compared. */
const SECONDS = 60;

function definitions(place) {
  if (statSync(place).isFile()) return [place];
  const all = readdirSync(place, { recursive: true }).map((name) => join(place, name));
  return all.filter((path) => /\.(gh|ghx|kd)$/i.test(path) && statSync(path).isFile()).sort();
}

const scratch = mkdtempSync(join(tmpdir(), "katydid-same-"));
const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");

function native(path) {
  const model = join(scratch, "model.3dm");
  rmSync(model, { force: true });
  const words = ["run", path, "--json=values", "-o", model, "--limit-seconds", String(SECONDS)];
  const begin = performance.now();
  let text;
  try {
    text = execFileSync(program, words, { maxBuffer: 1 << 30, stdio: ["ignore", "pipe", "ignore"], timeout: 2000 * SECONDS });
  } catch (error) {
    // An error in an object is one in the status, too.
    text = error.stdout;
    if (!text?.length) return { fault: "the program cannot run it" };
  }
  const report = JSON.parse(text);
  let bytes;
  try {
    bytes = readFileSync(model);
  } catch {
    bytes = Buffer.alloc(0);
  }
  return { report, model: hash(bytes), took: report.milliseconds, all: performance.now() - begin };
}

async function inPage(path) {
  let definition;
  try {
    definition = await open(readFileSync(path));
  } catch (error) {
    return { fault: String(error.message ?? error) };
  }
  try {
    const { milliseconds } = definition.solve({ seconds: SECONDS });
    return { report: definition.report({ values: true }), model: hash(definition.export("3dm")), took: milliseconds };
  } finally {
    definition.close();
  }
}

/** The objects that differ on purpose, and those that hang on them, cannot be told from here: only the first is asked. */
function reasonOf(ours, theirs) {
  const said = [...ours.messages, ...theirs.messages].map(({ text }) => text).join(" ");
  if (/Python/.test(said)) return "Python";
  if (/file|folder|\.3dm|picture|path/i.test(said)) return "files";
  if (/server|Hops|elsewhere/.test(said)) return "servers";
  return undefined;
}

const counts = { files: 0, objects: 0, same: 0, refused: 0, onPurpose: 0 };
const faults = [];
const slow = [];

await init();
for (const place of places) {
  for (const path of definitions(place)) {
    const name = basename(path);
    const [theirs, ours] = [native(path), await inPage(path)];
    counts.files += 1;
    if (theirs.fault || ours.fault) {
      if (theirs.fault && ours.fault) counts.refused += 1;
      else faults.push(`${name}: ${theirs.fault ?? "the program opens it"}, but ${ours.fault ?? "the page does too"}`);
      continue;
    }
    slow.push([name, theirs.took, ours.took]);
    const differing = [];
    const excused = new Set();
    theirs.report.objects.forEach((their, k) => {
      const our = ours.report.objects[k];
      counts.objects += 1;
      const plain = (one) => JSON.stringify([one?.id, one?.status, one?.messages, one?.outputs]);
      if (plain(our) === plain(their)) counts.same += 1;
      else {
        const reason = reasonOf(our, their);
        if (reason) excused.add(reason);
        differing.push([their, our]);
      }
    });
    if (differing.length > 0 && excused.size > 0) {
      counts.onPurpose += 1;
      console.log(`${name}: ${differing.length} objects differ on purpose: ${[...excused].join(", ")}`);
    } else if (differing.length > 0) {
      for (const [their, our] of differing.slice(0, 3)) {
        const [a, b] = [JSON.stringify([their.status, their.messages, their.outputs]), JSON.stringify([our?.status, our?.messages, our?.outputs])];
        let at = 0;
        while (at < a.length && a[at] === b?.[at]) at += 1;
        faults.push(`${name}: ${their.name} "${their.nickname}": ${a.slice(Math.max(0, at - 30), at + 40)} | ${b?.slice(Math.max(0, at - 30), at + 40)}`);
      }
    } else if (theirs.model !== ours.model) faults.push(`${name}: the values are the same, the models are not`);
  }
}
rmSync(scratch, { recursive: true, force: true });

const known = slow.filter(([, native]) => native > 20);
const sum = (at) => known.reduce((all, one) => all + one[at], 0);
console.log(JSON.stringify(counts));
if (known.length > 0) {
  console.log(`time of the ${known.length} that take more than 20 ms: ${sum(1).toFixed(0)} ms, in the page ${sum(2).toFixed(0)} ms`);
  for (const [name, a, b] of known.sort((x, y) => y[2] / y[1] - x[2] / x[1]).slice(0, 8)) console.log(`  ${(b / a).toFixed(2)} x  ${name}: ${a.toFixed(0)} ms, ${b.toFixed(0)} ms`);
}
for (const fault of faults) console.log(`FAULT ${fault}`);
process.exitCode = faults.length > 0 ? 1 : 0;
