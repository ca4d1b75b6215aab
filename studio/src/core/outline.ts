/** The definition as a text: each object, what it reads and what it gives. It is what a screen reader reads. */

import type { ObjectView } from "./protocol/ObjectView";
import type { OutputView } from "./protocol/OutputView";
import type { ResultView } from "./protocol/ResultView";

export interface OutlineRow {
  id: string;
  title: string;
  /** Each input that is wired, with the titles of what it reads. */
  reads: { input: string; from: string[] }[];
  /** Each output with its data in few words. */
  gives: { output: string; data: OutputView | undefined }[];
  status: string;
}

/** What an object is called: its nickname, and its name where that says more. */
export function title(object: ObjectView): string {
  const { nickname, name } = object;
  if (nickname === "" || nickname === name) return name;
  return `${nickname} (${name})`;
}

/** The objects that compute, each behind what it reads; objects in a loop come last, in the document's order. */
export function outline(
  objects: ReadonlyMap<string, ObjectView>,
  order: readonly string[],
  results: ReadonlyMap<string, ResultView>,
): OutlineRow[] {
  const owner = new Map<string, { object: ObjectView; port: string }>();
  for (const object of objects.values()) {
    for (const port of object.outputs) owner.set(port.id, { object, port: port.nickname || port.name });
  }
  const seen = new Set<string>();
  const rows: OutlineRow[] = [];
  const isComputing = (object: ObjectView) => !["group", "scribble", "sketch"].includes(object.kind);

  /** Puts what an object reads first; with a stack of its own, for definitions may be thousands of objects deep. */
  const visit = (root: ObjectView) => {
    const stack: { object: ObjectView; next: ObjectView[] }[] = [];
    const enter = (object: ObjectView) => {
      if (seen.has(object.id)) return;
      seen.add(object.id);
      const sources = object.inputs.flatMap((port) => port.sources).map((id) => owner.get(id)?.object);
      stack.push({ object, next: sources.filter((source) => source !== undefined) });
    };
    enter(root);
    for (let top = stack.at(-1); top; top = stack.at(-1)) {
      const source = top.next.shift();
      if (source) enter(source);
      else {
        stack.pop();
        rows.push(row(top.object));
      }
    }
  };
  const row = (object: ObjectView): OutlineRow => {
    const result = results.get(object.id);
    const isOwnPort = object.inputs.length === 1 && object.inputs[0]?.id === object.id;
    return {
      id: object.id,
      title: title(object),
      reads: object.inputs
        .filter((port) => port.sources.length > 0)
        .map((port) => ({
          input: isOwnPort ? "" : port.nickname || port.name,
          from: port.sources.map((id) => {
            const source = owner.get(id);
            if (!source) return "?";
            const { object: from, port: name } = source;
            return from.outputs.length > 1 ? `${title(from)} ${name}` : title(from);
          }),
        })),
      gives: object.outputs.map((port) => ({
        output: port.nickname || port.name,
        data: result?.outputs.find((output) => output.port === port.id),
      })),
      status: result?.status ?? "",
    };
  };
  for (const id of order) {
    const object = objects.get(id);
    if (object && isComputing(object)) visit(object);
  }
  return rows;
}
