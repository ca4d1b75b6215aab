/** Katydid's engine: definitions opened, set, solved, read and saved, in a page, a worker or Node. */

import load, * as raw from "./pkg/katydid.js";

const IS_NODE = typeof process !== "undefined" && Boolean(process.versions?.node) && typeof window === "undefined";

let loading;

/**
 * Loads the module; once, however often it is asked. `source` is where it comes from, where that is not beside this file:
 * an address, a response, its bytes or a compiled module.
 */
export function init(source) {
  loading ??= begin(source).catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

async function begin(source) {
  let from = source;
  if (from === undefined && IS_NODE) {
    // A name in a variable: bundlers for pages do not look for it.
    const files = "node:fs/promises";
    from = await (await import(/* @vite-ignore */ files)).readFile(new URL("./pkg/katydid_bg.wasm", import.meta.url));
  }
  const module = await load(from === undefined ? undefined : { module_or_path: from });
  // The components enter the registry in functions that run before all else, which a module does not call by itself.
  module.__wasm_call_ctors?.();
}

const bytesOf = (definition) => (typeof definition === "string" ? new TextEncoder().encode(definition) : new Uint8Array(definition));

/** Opens a definition. */
export async function open(definition) {
  await init();
  return new Definition(new raw.Definition(bytesOf(definition)));
}

/** A definition that is open. */
export class Definition {
  #own;
  #outputs;

  constructor(own) {
    this.#own = own;
  }

  get inputs() {
    return JSON.parse(this.#own.inputs());
  }

  get outputs() {
    return (this.#outputs ??= JSON.parse(this.#own.outputs()));
  }

  set(name, value) {
    if (typeof value === "number" && !Number.isFinite(value)) throw new RangeError(`${name}: ${value} is no number that can be set`);
    return this.#own.set(name, String(value));
  }

  solve({ seconds = 0 } = {}) {
    return JSON.parse(this.#own.solve(seconds));
  }

  report({ values = false } = {}) {
    return JSON.parse(this.#own.report(values));
  }

  read(name) {
    const { kind, paths, ends, count } = JSON.parse(this.#own.data(name));
    return new Data(this.#own, name, kind, paths, ends, count);
  }

  /** Pictures are SVG or PNG; `canvas` draws the definition itself. */
  picture({ format = "svg", ...wishes } = {}) {
    const bytes = this.#own.export(JSON.stringify({ format, ...wishes }));
    return format === "svg" ? new TextDecoder().decode(bytes) : bytes;
  }

  export(format, { objects } = {}) {
    return this.#own.export(JSON.stringify({ format, ...(objects && { objects: objects.join(",") }) }));
  }

  save(format = "gh") {
    return this.#own.save(format);
  }

  /** Gives its memory back. */
  close() {
    this.#own.free();
  }
}

/** The data of an output when it was read. */
class Data {
  #own;
  #name;

  constructor(own, name, kind, paths, ends, count) {
    this.#own = own;
    this.#name = name;
    this.kind = kind;
    this.paths = paths;
    this.ends = ends;
    this.count = count;
  }

  texts() {
    return JSON.parse(this.#own.texts(this.#name));
  }

  numbers() {
    return this.#own.numbers(this.#name);
  }
}

/** A definition in another form. */
export async function convert(definition, to) {
  await init();
  return raw.convert(bytesOf(definition), to);
}

/** The components that there are. */
export async function components() {
  await init();
  return JSON.parse(raw.components());
}

/** The version of Katydid. */
export async function version() {
  await init();
  return raw.version();
}

/** What the studio's worker is made of; its names may change with any version. */
export { raw };
