/** Results made up from what is wired: enough to see wires, panels and states. */

import type { ObjectView } from "../../src/core/protocol/ObjectView";
import type { Page } from "../../src/core/protocol/Page";
import type { ResultView } from "../../src/core/protocol/ResultView";
import type { Row } from "../../src/core/protocol/Row";
import type { Structure } from "../../src/core/protocol/Structure";

const COUNTS: Record<Structure, [branches: number, items: number]> = {
  empty: [0, 0],
  item: [1, 1],
  list: [1, 7],
  tree: [7, 7],
};

function structureOf(objects: ReadonlyMap<string, ObjectView>, owners: ReadonlyMap<string, string>, object: ObjectView, deep = 0): Structure {
  if (object.disabled || object.support.is === "no" || deep > 30) return "empty";
  const { control, name } = object;
  if (control?.is === "slider" || control?.is === "toggle" || control?.is === "swatch" || control?.is === "button") return "item";
  if (control?.is === "panel" && (object.inputs[0]?.sources.length ?? 0) === 0) return control.text === "" ? "empty" : "item";
  if (name === "Series" || name === "Divide Curve") return "list";
  if (name === "Graft Tree" || name === "Entwine") return "tree";
  if (object.inputs.length === 0 || control) {
    if ((object.inputs[0]?.sources.length ?? 0) === 0) return "item";
  }
  const wired = object.inputs.flatMap((port) => port.sources);
  const order: Structure[] = ["empty", "item", "list", "tree"];
  let best: Structure = "empty";
  for (const source of wired) {
    const owner = objects.get(owners.get(source) ?? "");
    if (!owner || owner === object) continue;
    const found = structureOf(objects, owners, owner, deep + 1);
    if (order.indexOf(found) > order.indexOf(best)) best = found;
  }
  return best;
}

export function ownersOf(objects: readonly ObjectView[]): Map<string, string> {
  return new Map(objects.flatMap((object) => object.outputs.map((port) => [port.id, object.id] as const)));
}

export function resultsOf(list: readonly ObjectView[]): ResultView[] {
  const objects = new Map(list.map((object) => [object.id, object]));
  const owners = ownersOf(list);
  return list.map((object) => {
    const structure = structureOf(objects, owners, object);
    const [branches, items] = COUNTS[structure];
    const outputs = object.outputs.map((port) => ({ port: port.id, structure, branches, items }));
    const messages = object.name === "Loft" ? [{ level: "error", text: "Curves do not fit together" }] : object.name === "Divide Curve" ? [{ level: "warning", text: "Kinks has no data" }] : [];
    const level = messages[0]?.level;
    const bare = object.kind === "parameter" && structure === "empty";
    const status = object.disabled ? "disabled" : object.support.is === "no" ? "unsupported" : (level ?? (bare ? "no-data" : "ok"));
    const wired = (object.inputs[0]?.sources.length ?? 0) > 0;
    const panel = object.control?.is === "panel" && wired ? rowsOfPort(list, object.inputs[0]?.id ?? "", 0, 40) : null;
    return { id: object.id, status, messages, milliseconds: object.kind === "component" ? 0.4 : 0, outputs, panel };
  });
}

export function rowsOfPort(list: readonly ObjectView[], port: string, from: number, count: number): Page {
  const owners = ownersOf(list);
  const objects = new Map(list.map((object) => [object.id, object]));
  const own = list.flatMap((object) => object.inputs).find((input) => input.id === port);
  const source = objects.get(owners.get(own?.sources[0] ?? port) ?? "");
  const rows = source ? rowsOf(objects, owners, source) : [];
  return { from, total: rows.length, rows: rows.slice(from, from + count) };
}

function rowsOf(objects: ReadonlyMap<string, ObjectView>, owners: ReadonlyMap<string, string>, source: ObjectView): Row[] {
  const structure = structureOf(objects, owners, source);
  const text = (k: number) => {
    if (source.control?.is === "slider") return String(source.control.value);
    if (source.control?.is === "panel") return source.control.text;
    return `{${k}, 0, 0}`;
  };
  const item = (k: number): Row => ({ is: "item", index: k, text: text(k) });
  const path = (path: string, items: number): Row => ({ is: "path", path, items });
  if (structure === "empty") return [];
  if (structure === "item") return [path("{0}", 1), item(0)];
  if (structure === "list") return [path("{0}", 7), ...Array.from({ length: 7 }, (_, k) => item(k))];
  return Array.from({ length: 7 }, (_, k) => [path(`{0;${k}}`, 1), { ...item(k), index: 0 } as Row]).flat();
}
