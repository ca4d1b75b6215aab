// What a slider's move takes in the engine for pages, beside the program on one thread: `node speed.mjs PROGRAM`. Both solve the
// same points of the same definitions, in turns; of each the least counts, as the machine has other work.
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { init, open } from "../index.js";

const [program] = process.argv.slice(2);
if (!program) throw new Error("node speed.mjs PROGRAM");

const TURNS = 3;
const POINTS = 60;

/** So many additions in rows of ten that hang on a slider, beside others that do not: `crates/solver/benches/slider.rs`. */
function additions(hanging, all) {
  const lines = ["x = Number Slider(1.000, 0.000..1000.000)", "y = Number Slider(2.000, 0.000..1000.000)"];
  for (let k = 0; k < all; k++) {
    const first = k < hanging ? "x" : "y";
    const at = k < hanging ? k : k - hanging;
    lines.push(`a${k} = Operators/Addition(${at % 10 === 0 ? first : `a${k - 1}`}, 0.5)`);
  }
  return { text: [...lines, `out = Panel(a${hanging - 1})`], slider: "x", from: 1 };
}

/** Circles divided and moved, curves through the points: `studio/measures/slider.spec.ts`. */
function curves() {
  const lines = ["radius = Number Slider(20.0, 1..100)"];
  for (let k = 1; k <= 60; k++) {
    lines.push(
      `f${k} = Operators/Multiplication(radius, ${k})`,
      `c${k} = Circle(_, f${k})`,
      `d${k} = Divide Curve(c${k}, 200)`,
      `m${k} = Move(d${k}.Points, (0, 0, ${k}))`,
      `i${k} = Interpolate(m${k})`,
    );
  }
  return { text: [...lines, "l = Length(i1)", "out = Panel(l)"], slider: "radius", from: 20 };
}

/** A solid with a hole, meshed. */
function solid() {
  const text = [
    "r = Number Slider(2.00, 1.00..4.00)",
    "box = Center Box(_, 10, 10, 4)",
    "circle = Circle(plane((0, 0, -5)), r)",
    "z = Unit Z(10)",
    "wall = Extrude(circle, z)",
    "pin = Cap Holes(wall)",
    "part = Solid Difference(box, pin)",
    "mesh = Mesh Brep(part)",
    "v = Volume(part)",
    "out = Panel(v)",
  ];
  return { text, slider: "r", from: 1.2, step: 0.04 };
}

const CASES = { "1 of 1,000 additions": additions(1, 998), "100 of 1,000 additions": additions(100, 998), "1,000 additions": additions(998, 998), "300 objects with curves": curves(), "a box with a hole, meshed": solid() };

const share = (list, part) => [...list].sort((a, b) => a - b)[Math.round((list.length - 1) * part)];

async function inPage({ text, slider, from, step = 1 }) {
  const definition = await open(["katydid 1", ...text, ""].join("\n"));
  definition.solve();
  const times = [];
  for (let k = 0; k < POINTS; k++) {
    definition.set(slider, from + k * step);
    times.push(definition.solve().milliseconds);
  }
  definition.close();
  return times;
}

async function inProgram({ text, slider, from, step = 1 }, folder) {
  const file = join(folder, "definition.kd");
  await writeFile(file, ["katydid 1", ...text, ""].join("\n"));
  const inputs = { [slider]: { from, to: from + (POINTS - 1) * step, steps: POINTS } };
  await writeFile(join(folder, "plan.json"), JSON.stringify({ inputs, sample: "grid", outputs: ["out"] }));
  const study = join(folder, "study");
  execFileSync(program, ["sweep", file, "--plan", join(folder, "plan.json"), "-o", study, "--workers", "1"], { stdio: "ignore" });
  const lines = (await readFile(join(study, "times.csv"), "utf8")).trim().split("\n").slice(1);
  await rm(study, { recursive: true });
  return lines.map((line) => Number(line.split(",")[1]));
}

await init();
const folder = await mkdtemp(join(tmpdir(), "katydid-speed-"));
for (const [name, made] of Object.entries(CASES)) {
  const [page, native] = [[], []];
  for (let turn = 0; turn < TURNS; turn++) {
    native.push(...(await inProgram(made, folder)));
    page.push(...(await inPage(made)));
  }
  const told = (part) => [page, native].map((list) => share(list, part));
  const [[least, its], [tenth, tenths]] = [told(0), told(0.1)];
  console.log(
    `${name}: page ${least.toFixed(3)} ms, program ${its.toFixed(3)} ms, ratio ${(least / its).toFixed(2)};`,
    `of ten the quickest ${tenth.toFixed(3)} and ${tenths.toFixed(3)}, ratio ${(tenth / tenths).toFixed(2)}`,
  );
}
await rm(folder, { recursive: true });
