/** Finding objects of a document by their words. */

import type { ObjectView } from "./protocol/ObjectView";

/** What is written on an object. */
function writtenOn({ control }: ObjectView): string {
  if (control?.is === "panel" || control?.is === "scribble") return control.text;
  return control?.is === "group" ? control.label : "";
}

/** What an object is listed as: the first line that is written on it, else its own name, else that of its type. */
export function headOf(object: ObjectView): string {
  const texts = [writtenOn(object), object.nickname, object.name].map((text) => text.trim());
  return (texts.find((text) => text !== "") ?? "").split("\n")[0]?.trim() ?? "";
}

/** The texts that an object is found by: its names, and what is written on it. */
export function wordsOf(object: ObjectView): string[] {
  return [object.nickname, object.name, writtenOn(object)].map((text) => text.trim()).filter((text) => text !== "");
}

/** The first part of an id, as messages of servers and of `katydid run` name objects. */
const ID = /^[0-9a-f]{8}/;

/** The objects with a text that holds the query; those that begin with it first, then in the order given. */
export function found(objects: Iterable<ObjectView>, query: string): ObjectView[] {
  const wanted = query.trim().toLowerCase();
  if (wanted === "") return [];
  const first: ObjectView[] = [];
  const others: ObjectView[] = [];
  for (const object of objects) {
    const words = wordsOf(object).map((text) => text.toLowerCase());
    if (ID.test(wanted)) words.push(object.id.toLowerCase());
    if (words.some((text) => text.startsWith(wanted))) first.push(object);
    else if (words.some((text) => text.includes(wanted))) others.push(object);
  }
  return [...first, ...others];
}
