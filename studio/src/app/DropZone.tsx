import { useEffect, useState } from "react";

import { t } from "../i18n";
import { lineStore } from "../state/session";
import { DEFINITIONS, goTo, isNamed, MODELS, upload } from "./files";

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
      if (file) void take(file, document);
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

/** Opens a file, or gives a model to a document. */
export async function take(file: File, document?: string): Promise<void> {
  try {
    if (isNamed(file.name, MODELS)) {
      if (!document) throw new Error(t("drop.modelFirst"));
      await upload(file, document);
    } else if (isNamed(file.name, DEFINITIONS)) {
      goTo(await upload(file));
    } else {
      throw new Error(t("drop.unknown", { name: file.name }));
    }
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}
