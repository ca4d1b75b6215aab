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
      const file = event.dataTransfer?.files[0];
      if (file) void letGo(file, event, document);
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
async function letGo(file: File, event: DragEvent, document?: string): Promise<void> {
  if (!document || !isNamed(file.name, DEFINITIONS) || event.ctrlKey || event.metaKey) return await take(file, document);
  const at = insertPlace(event);
  if (event.altKey) await insert(file, at, "loose");
  else askAbout(file, at);
}

/** Opens a file, or gives a model to a document. */
export async function take(file: File, document?: string): Promise<void> {
  try {
    if (isNamed(file.name, MODELS)) {
      if (!document) throw new Error(t("drop.modelFirst"));
      await attachModel(file, document);
    } else if (isNamed(file.name, DEFINITIONS)) {
      goTo(await upload(file));
    } else {
      throw new Error(t("drop.unknown", { name: file.name }));
    }
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}
