import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { GeometryStore, type Fetcher } from "../../src/viewport/geometryStore";
import { writePreview } from "./previewBytes";

const bytesOf = (object: string, x: number) => writePreview({ object, parts: [{ kind: "points", positions: [x, 0, 0] }] });

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
    store.changed([["a", "1"]]);
    store.changed([["a", "1"]]);
    await wait();
    expect(asked.map(({ hash }) => hash)).toEqual(["1"]);
    asked[0]?.answer(bytesOf("a", 7));
    await wait();
    expect(log).toEqual(["put a 7"]);
    store.changed([["a", "1"]]);
    await wait();
    expect(asked.length).toBe(1);
  });

  it("comes over the socket just before or just after it is announced, and is not fetched then", async () => {
    store.bytes(bytesOf("a", 1));
    store.changed([["a", "1"], ["b", "2"]]);
    store.bytes(bytesOf("b", 2));
    await wait();
    expect(log).toEqual(["put a 1", "put b 2"]);
    expect(asked).toEqual([]);
  });

  it("is the newest: what is older is stopped and never shown", async () => {
    store.changed([["a", "1"]]);
    await wait();
    store.changed([["a", "2"]]);
    await wait();
    expect(asked[0]?.signal.aborted).toBe(true);
    asked[1]?.answer(bytesOf("a", 2));
    asked[0]?.answer(bytesOf("a", 1));
    await wait();
    expect(log).toEqual(["put a 2"]);
  });

  it("goes back to what is shown without asking", async () => {
    store.changed([["a", "1"]]);
    store.bytes(bytesOf("a", 1));
    store.changed([["a", "2"]]);
    store.changed([["a", "1"]]);
    await wait();
    expect(asked).toEqual([]);
    expect(log).toEqual(["put a 1"]);
  });

  it("is dropped when there is none, also on its way", async () => {
    store.changed([["a", "1"], ["b", "2"]]);
    store.bytes(bytesOf("a", 1));
    store.changed([["a", null], ["b", null], ["c", null]]);
    await wait();
    expect(log).toEqual(["put a 1", "drop a"]);
    expect(asked).toEqual([]);
  });

  it("stays when new geometry fails, and is asked for again", async () => {
    store.changed([["a", "1"]]);
    await wait();
    asked[0]?.refuse(new Error("404"));
    await wait();
    store.changed([["a", "1"]]);
    await wait();
    asked[1]?.answer(bytesOf("b", 1));
    await wait();
    expect(log).toEqual(["failed a 404", "failed a it is the geometry of something else"]);
    store.bytes(new ArrayBuffer(3));
    expect(log.at(-1)).toMatch(/^failed {2}shorter/);
  });

  it("is told again to a listener that comes later, and no more to one that left", () => {
    store.changed([["a", "1"]]);
    store.bytes(bytesOf("a", 1));
    const late: string[] = [];
    const leave = store.listen({ ...listener, put: (object) => late.push(object) });
    expect(late).toEqual(["a"]);
    leave();
    store.changed([["a", "2"]]);
    store.bytes(bytesOf("a", 2));
    expect(late).toEqual(["a"]);
  });

  it("is forgotten with the document", async () => {
    store.changed([["a", "1"]]);
    store.clear();
    await wait();
    expect(log).toEqual(["clear"]);
    expect(asked).toEqual([]);
  });
});
