// The package as Node sees it: `node --test wasm/tests/api.test.mjs`, after `make wasm`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";

import { components, convert, open, raw, version } from "../index.js";

const SUM = `katydid 1
a = Number Slider(3.0, 0..10)
b = Number Slider(4.0, 0..10)
sum = Addition(a, b)
points = Construct Point(a, b, sum)
`;

const named = (definition, name) => definition.outputs.find((output) => output.name === name || output.name.startsWith(`${name}.`));

test("the registry is full", async () => {
  const all = await components();
  assert.ok(all.length > 700, `${all.length} components`);
  assert.ok(all.some(({ name }) => name === "Divide Domain²"));
  assert.match(await version(), /^\d+\.\d+\.\d+/);
});

test("a sum is set, solved and read", async () => {
  const definition = await open(SUM);
  assert.equal(definition.inputs.length, 2);
  const solved = definition.solve();
  assert.ok(solved.solved >= 4 && solved.unfinished === 0);
  const sum = named(definition, "sum");
  assert.deepEqual([...definition.read(sum.id).numbers()], [7]);
  definition.set(definition.inputs[0].id, 5.5);
  definition.solve();
  assert.deepEqual([...definition.read(sum.id).numbers()], [9.5]);
  const points = definition.read(named(definition, "points").id);
  assert.deepEqual([points.kind, points.count, ...points.numbers()], ["Point", 1, 5.5, 4, 9.5]);
  assert.deepEqual(points.texts(), ["{5.5, 4, 9.5}"]);
  const [first] = definition.report({ values: true }).objects.find(({ id }) => id === sum.object).outputs;
  assert.deepEqual(first.branches, [{ path: "{0}", items: [9.5] }]);
  definition.close();
});

test("what is wrong is told", async () => {
  await assert.rejects(open("katydid 1\nx = Nothing Of That Name(1)\n"), /Nothing Of That Name/);
  await assert.rejects(open(new Uint8Array([1, 2, 3])), Error);
  const definition = await open(SUM);
  assert.throws(() => definition.set("nobody", 1), /nobody/);
  assert.throws(() => definition.set(definition.inputs[0].id, Number.NaN), RangeError);
  assert.throws(() => definition.read("nobody"), /nobody/);
  assert.throws(() => definition.export("doc"), /doc/);
  definition.close();
});

test("pictures and files come out", async () => {
  const definition = await open(await readFile(new URL("../../examples/tower.kd", import.meta.url)));
  definition.solve();
  assert.match(definition.picture(), /^<svg[^]*<\/svg>\s*$/);
  assert.match(definition.picture({ canvas: true }), /^<svg/);
  assert.deepEqual([...definition.picture({ format: "png", width: 320, height: 200 }).slice(1, 4)], [...Buffer.from("PNG")]);
  const start = (bytes, length) => Buffer.from(bytes.slice(0, length)).toString("latin1");
  assert.equal(start(definition.export("3dm"), 24), "3D Geometry File Format ");
  assert.equal(start(definition.export("glb"), 4), "glTF");
  assert.equal(start(definition.export("step"), 13), "ISO-10303-21;");
  for (const form of ["gh", "ghx", "kd"]) {
    const again = await open(definition.save(form));
    again.solve();
    const values = (one) => one.report({ values: true }).objects.map(({ outputs }) => outputs.map(({ branches }) => branches));
    assert.deepEqual(values(again), values(definition), form);
    again.close();
  }
  definition.close();
  // A byte order mark stands first, as Grasshopper writes it.
  assert.equal(start(await convert(SUM, "ghx"), 8).slice(3), "<?xml");
});

test("a script in C# runs, one in Python says why not", async () => {
  const definition = await open(await readFile(new URL("scripts.kd", import.meta.url)));
  definition.solve();
  const of = (name) => definition.report().objects.find(({ nickname }) => nickname === name);
  assert.deepEqual(of("sharp").outputs.at(-1).branches[0].items, ["42"], JSON.stringify(of("sharp").messages));
  assert.equal(of("snake").status, "unsupported");
  assert.match(of("snake").messages[0].text, /not supported in a page/);
  definition.close();
});

test("a document speaks the protocol, and its journal has what was edited", async () => {
  const bytes = new TextEncoder().encode(SUM);
  const begin = (journal) => {
    const document = new raw.Document("sum", bytes, journal, false);
    const heard = [];
    const all = () => {
      while (document.isDue()) document.work();
      for (const message of document.take()) if (typeof message === "string") heard.push(JSON.parse(message));
      return heard;
    };
    document.join();
    return { document, all };
  };
  const first = begin(new Uint8Array());
  const state = first.all().find(({ event }) => event === "document");
  const slider = state.objects.find(({ control }) => control?.is === "slider");
  const edit = { do: "set", object: slider.id, to: { is: "number", value: 9 } };
  first.document.ask(JSON.stringify({ seq: 1, ask: { ask: "edit", edit, gesture: null, within: [] } }));
  const heard = first.all();
  assert.ok(heard.some(({ event, seq }) => event === "done" && seq === 1), JSON.stringify(heard.at(-1)));
  assert.ok(heard.filter(({ event, finished }) => event === "results" && finished).length >= 2);
  first.document.flush();
  let journal = Buffer.alloc(0);
  for (const [isMore, piece] of first.document.takeWritten()) journal = isMore ? Buffer.concat([journal, piece]) : Buffer.from(piece);
  assert.ok(journal.length > 0);
  first.document.free();
  const second = begin(new Uint8Array(journal));
  const restored = second.all().find(({ event }) => event === "document");
  assert.equal(restored.restored.steps, 1);
  assert.equal(restored.objects.find(({ id }) => id === slider.id).control.value, 9);
  second.document.ask("no request");
  assert.ok(second.all().some(({ event, level }) => event === "notice" && level === "error"));
  second.document.free();
});
