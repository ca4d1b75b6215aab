import { useEffect, useState } from "react";

import { t } from "../i18n";
import { lineStore } from "../state/session";
import { DEFINITIONS, goTo, isNamed, MODELS, upload } from "./files";
import { attachModel } from "./model";
import { askAbout, insert, insertPlace } from "./insert";

/** Files dropped anywhere on the page: definitions open, a .3dm model is given to the document. */
export function DropZone({ document }: { document?: string }) {
  const [over, setOver] = useState(false);
  useEffect(() => {
    const has = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
    const drag = (event: DragEvent) => {
      if (!has(event)) return;
      event.preventDefault();
      setOver(true);
    };
    const leave = (event: DragEvent) => {
      if (event.relatedTarget === null) setOver(false);
    };
    const drop = (event: DragEvent) => {
      if (!has(event)) return;
      event.preventDefault();
      setOver(false);
      void letGo([...(event.dataTransfer?.files ?? [])], event, document);
    };
    addEventListener("dragover", drag);
    addEventListener("dragleave", leave);
    addEventListener("drop", drop);
    return () => {
      removeEventListener("dragover", drag);
      removeEventListener("dragleave", leave);
      removeEventListener("drop", drop);
    };
  }, [document]);
  return over ? <div className="dropping">{t("drop.here")}</div> : null;
}

/** A definition that is let go on another: Alt inserts it there, Ctrl opens it; else it is asked. */
async function letGo(files: readonly File[], event: DragEvent, document?: string): Promise<void> {
  const [file] = files;
  const isInserted = file && document && files.length === 1 && isNamed(file.name, DEFINITIONS) && !event.ctrlKey && !event.metaKey;
  if (!isInserted) return await take(files, document);
  const at = insertPlace(event);
  if (event.altKey) await insert(file, at, "loose");
  else askAbout(file, at);
}

/** Opens a file, or gives a model to a document: to the one that is open, or to the one that comes with it. */
export async function take(files: readonly File[], document?: string): Promise<void> {
  try {
    const definition = files.find(({ name }) => isNamed(name, DEFINITIONS));
    const model = files.find(({ name }) => isNamed(name, MODELS));
    if (!definition && !model) {
      if (files[0]) throw new Error(t("drop.unknown", { name: files[0].name }));
      return;
    }
    const opened = definition && (await upload(definition));
    const of = opened ?? document;
    if (model && !of) throw new Error(t("drop.modelFirst"));
    if (model && of) await attachModel(model, of);
    if (opened) goTo(opened);
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}
