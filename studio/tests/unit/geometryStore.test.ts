import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { GeometryStore, type Fetcher } from "../../src/viewport/geometryStore";
import { FrameBuffer, type Frames } from "../../src/core/frames";
import { writeFrame, writePreview } from "./previewBytes";

const bytesOf = (object: string, x: number) => writePreview({ object, parts: [{ kind: "points", positions: [x, 0, 0] }] });

const NONE: Frames = new Map();

/** Frames by names, as the socket brings them. */
function framesOf(...all: [name: string, object: string, x: number][]): Frames {
  const buffer = new FrameBuffer();
  for (const [name, object, x] of all) buffer.put(writeFrame(name, bytesOf(object, x)).frame);
  return buffer.take();
}

const hash = (name: string) => writeFrame(name, new ArrayBuffer(0)).hash;

describe("the geometry of objects", () => {
  let log: string[] = [];
  let asked: { hash: string; signal: AbortSignal; answer: (bytes: ArrayBuffer) => void; refuse: (why: Error) => void }[] = [];
  const fetcher: Fetcher = (hash, signal) =>
    new Promise((answer, refuse) => {
      asked.push({ hash, signal, answer, refuse });
      signal.addEventListener("abort", () => refuse(new Error("aborted")));
    });
  const listener = {
    put: (object: string, preview: { parts: { positions: Float32Array }[] }) =>
      log.push(`put ${object} ${preview.parts[0]?.positions[0]}`),
    drop: (object: string) => log.push(`drop ${object}`),
    clear: () => log.push("clear"),
    failed: (object: string, why: string) => log.push(`failed ${object} ${why}`),
  };
  let store = new GeometryStore(fetcher);

  beforeEach(() => {
    vi.useFakeTimers();
    [log, asked] = [[], []];
    store = new GeometryStore(fetcher);
    store.listen(listener);
  });
  afterEach(() => vi.useRealTimers());

  const wait = () => vi.advanceTimersByTimeAsync(50);

  it("is fetched by its hash, once", async () => {
    store.changed([["a", "1"]], NONE);
    store.changed([["a", "1"]], NONE);
    await wait();
    expect(asked.map(({ hash }) => hash)).toEqual(["1"]);
    asked[0]?.answer(bytesOf("a", 7));
    await wait();
    expect(log).toEqual(["put a 7"]);
    store.changed([["a", "1"]], NONE);
    await wait();
    expect(asked.length).toBe(1);
  });

  it("comes over the socket before it is named, by its hash, and is not fetched then", async () => {
    store.changed([["a", hash("1")], ["b", hash("3")]], framesOf(["1", "a", 1], ["2", "b", 2]));
    await wait();
    expect(log).toEqual(["put a 1"]);
    expect(asked.map((each) => each.hash)).toEqual([hash("3")]);
  });

  it("stays in a small frame without a copy, and keeps none of a large one but its own bytes", () => {
    let buffer: ArrayBufferLike | undefined;
    store.listen({ ...listener, put: (_object, preview) => (buffer = preview.parts[0]?.positions.buffer) });
    const small = framesOf(["1", "a", 1]);
    store.changed([["a", hash("1")]], small);
    expect(buffer).toBe(small.get(hash("1"))?.frame);
    const bytes = bytesOf("a", 2);
    const frame = new ArrayBuffer(2e6);
    new Uint8Array(frame).set(new Uint8Array(bytes), 1e6);
    store.changed([["a", hash("2")]], new Map([[hash("2"), { frame, start: 1e6, length: bytes.byteLength }]]));
    expect(buffer?.byteLength).toBe(bytes.byteLength);
    expect(log).toEqual(["put a 1", "put a 2"]);
  });

  it("is fetched by a few at a time, each in its turn, and not at all when it is not wanted any more", async () => {
    store.changed(Array.from({ length: 1000 }, (_, k): [string, string] => [`o${k}`, `${k}`]), NONE);
    await wait();
    expect(asked.map(({ hash }) => hash)).toEqual(["0", "1", "2", "3", "4", "5"]);
    store.changed(Array.from({ length: 980 }, (_, k): [string, null] => [`o${k + 10}`, null]), NONE);
    asked[1]?.refuse(new Error("gone"));
    await wait();
    for (let done = 0; done < asked.length; ) {
      for (const one of asked.slice(done)) one.answer(bytesOf(`o${one.hash}`, done++));
      await wait();
    }
    expect(asked.map(({ hash }) => Number(hash))).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 990, 991, 992, 993, 994, 995, 996, 997, 998, 999]);
    expect(log.filter((line) => line.startsWith("put")).length).toBe(19);
  });

  it("is the newest: what is older is stopped and never shown", async () => {
    store.changed([["a", "1"]], NONE);
    await wait();
    store.changed([["a", "2"]], NONE);
    await wait();
    expect(asked[0]?.signal.aborted).toBe(true);
    asked[1]?.answer(bytesOf("a", 2));
    asked[0]?.answer(bytesOf("a", 1));
    await wait();
    expect(log).toEqual(["put a 2"]);
  });

  it("goes back to what is shown without asking", async () => {
    store.changed([["a", hash("1")]], framesOf(["1", "a", 1]));
    store.changed([["a", "2"]], NONE);
    store.changed([["a", hash("1")]], NONE);
    await wait();
    expect(asked.map(({ signal }) => signal.aborted)).toEqual([true]);
    expect(log).toEqual(["put a 1"]);
  });

  it("is dropped when there is none, also on its way", async () => {
    store.changed([["a", hash("1")], ["b", "2"]], framesOf(["1", "a", 1]));
    store.changed([["a", null], ["b", null], ["c", null]], NONE);
    await wait();
    expect(log).toEqual(["put a 1", "drop a"]);
    expect(asked.map(({ signal }) => signal.aborted)).toEqual([true]);
  });

  it("stays when new geometry fails, and is asked for again", async () => {
    store.changed([["a", "1"]], NONE);
    await wait();
    asked[0]?.refuse(new Error("404"));
    await wait();
    store.changed([["a", "1"]], NONE);
    await wait();
    asked[1]?.answer(bytesOf("b", 1));
    await wait();
    expect(log).toEqual(["failed a 404", "failed a it is the geometry of something else"]);
    store.changed([["a", "2"]], new Map([["2", { frame: new ArrayBuffer(40), start: 24, length: 3 }]]));
    expect(log.at(-1)).toMatch(/^failed a shorter/);
  });

  it("is told again to a listener that comes later, and no more to one that left", () => {
    store.changed([["a", hash("1")]], framesOf(["1", "a", 1]));
    const late: string[] = [];
    const leave = store.listen({ ...listener, put: (object) => late.push(object) });
    expect(late).toEqual(["a"]);
    leave();
    store.changed([["a", hash("2")]], framesOf(["2", "a", 2]));
    expect(late).toEqual(["a"]);
  });

  it("is forgotten with the document", async () => {
    store.changed([["a", "1"]], NONE);
    store.clear();
    await wait();
    expect(log).toEqual(["clear"]);
    expect(asked.map(({ signal }) => signal.aborted)).toEqual([true]);
  });
});

describe("frames", () => {
  it("are kept until an event names them, and no more than fit", () => {
    const buffer = new FrameBuffer();
    buffer.put(new ArrayBuffer(0));
    buffer.put(new ArrayBuffer(16));
    buffer.put(new ArrayBuffer(65e6));
    const { frame, hash: name } = writeFrame("x", bytesOf("a", 1));
    buffer.put(frame);
    expect([...buffer.take().keys()]).toEqual([name]);
    expect(buffer.take().size).toBe(0);
  });

  it("bring the geometry of several, as far as it is whole", () => {
    const all = ["x", "y", "z"].map((name) => writeFrame(name, bytesOf(name, 1)));
    const frame = new Uint8Array(all.flatMap((each) => [...new Uint8Array(each.frame)]));
    for (let length = 0; length <= frame.length; length++) {
      const buffer = new FrameBuffer();
      buffer.put(frame.slice(0, length).buffer);
      const names = [...buffer.take().keys()];
      expect(names).toEqual(all.map((each) => each.hash).slice(0, names.length));
      if (length === frame.length) expect(names.length).toBe(3);
    }
  });
});
