/** A definition that is put into the one that is open, instead of being opened itself. */

import { createStore } from "zustand/vanilla";

import { canvasPoint, paneElement, paneSize, pixelOf } from "../canvas/view";
import { holds, type Point } from "../core/geometry";
import { showDialog } from "../dialogs/store";
import { t } from "../i18n";
import { edit, lineStore } from "../state/session";
import { select } from "../state/ui";
import { definitionText, DEFINITIONS } from "./files";

/** More than this the server takes in no request. */
const MOST_LETTERS = 12_000_000;

/** How what is inserted is held together. */
export type Inserting = "loose" | "group" | "cluster";

interface Waiting {
  /** The file of which it is not yet said what shall become of it. */
  file: File | undefined;
  /** Where its middle goes, on the canvas. */
  at: Point;
}

export const insertStore = createStore<Waiting>(() => ({ file: undefined, at: [0, 0] }));

/** The place of the canvas below a point of the page; the middle of what is seen where that is not over the canvas. */
export function insertPlace(event?: { clientX: number; clientY: number }): Point {
  const [width, height] = paneSize();
  const pixel = event && pixelOf(event);
  const over = pixel !== undefined && paneElement() !== undefined && holds([0, 0, width, height], pixel);
  return canvasPoint(over ? pixel : [width / 2, height / 2]);
}

/** Asks what shall become of a file. */
export function askAbout(file: File, at: Point = insertPlace()): void {
  insertStore.setState({ file, at });
  showDialog("insert");
}

/** Has a file chosen, and asks what shall become of it. */
export function chooseToInsert(): void {
  const field = document.createElement("input");
  field.type = "file";
  field.accept = DEFINITIONS.join(",");
  field.addEventListener("change", () => {
    const file = field.files?.[0];
    if (file) askAbout(file);
  });
  field.click();
}

/** Puts the objects of a definition on the canvas, and selects what came of it. */
export async function insert(file: File, at: Point, how: Inserting): Promise<void> {
  try {
    const text = await definitionText(file);
    if (text.length > MOST_LETTERS) throw new Error(t("insert.large", { name: file.name }));
    const done = await edit({ do: "paste", text, at: [...at], seed: crypto.randomUUID() });
    if (done?.event !== "done") return;
    if (done.made.length === 0) throw new Error(t("insert.nothing", { name: file.name }));
    select(done.made);
    if (how !== "loose") await hold(done.made, how, file.name);
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}

async function hold(objects: string[], how: "group" | "cluster", file: string): Promise<void> {
  const id = crypto.randomUUID();
  const name = file.replace(/\.[^.]*$/, "");
  const made = await edit(how === "group" ? { do: "group", id, objects } : { do: "makeCluster", id, objects });
  if (!made) return;
  await edit(
    how === "group"
      ? { do: "changeGroup", group: id, change: { is: "label", text: name } }
      : { do: "change", objects: [id], change: { is: "nickname", text: name } },
  );
  select([id]);
}
