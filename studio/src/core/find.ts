/** Finding objects of a document by their words. */

import type { ObjectView } from "./protocol/ObjectView";

/** The texts that an object is found by: its names, and what is written on it. */
export function wordsOf(object: ObjectView): string[] {
  const { control } = object;
  const written =
    control?.is === "panel" || control?.is === "scribble"
      ? control.text
      : control?.is === "group"
        ? control.label
        : "";
  return [object.nickname, object.name, written].map((text) => text.trim()).filter((text) => text !== "");
}

/** The objects with a text that holds the query; those that begin with it first, then in the order given. */
export function found(objects: Iterable<ObjectView>, query: string): ObjectView[] {
  const wanted = query.trim().toLowerCase();
  if (wanted === "") return [];
  const first: ObjectView[] = [];
  const others: ObjectView[] = [];
  for (const object of objects) {
    const words = wordsOf(object).map((text) => text.toLowerCase());
    if (words.some((text) => text.startsWith(wanted))) first.push(object);
    else if (words.some((text) => text.includes(wanted))) others.push(object);
  }
  return [...first, ...others];
}
