/** The Rhino model of the document that is open. */

import { lineStore } from "../state/session";
import { MODELS, upload } from "./files";
import { place } from "./place";

/** Gives a model to a document. */
export async function attachModel(file: File, document: string): Promise<void> {
  await upload(file, document);
  lineStore.setState({ complaint: undefined });
}

/** Has a model chosen. */
export function chooseModel(): void {
  const { document: id } = place(location.search);
  const field = document.createElement("input");
  field.type = "file";
  field.accept = MODELS.join(",");
  field.addEventListener("change", () => {
    const file = field.files?.[0];
    if (!file || !id) return;
    attachModel(file, id).catch((error: unknown) => {
      lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
    });
  });
  field.click();
}
