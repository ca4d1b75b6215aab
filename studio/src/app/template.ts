/** The definition that new ones begin as: kept in this browser, as text. */

import { lineStore } from "../state/session";
import { definitionOf, open, upload } from "./files";
import { t } from "../i18n";

const KEY = "katydid.template";
/** A browser keeps some megabytes for a page. */
const MOST_LETTERS = 2_000_000;

export function template(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    // Storage is forbidden: there is none.
    return null;
  }
}

/** New definitions begin as this one from now on. */
export async function keepTemplate(document: string): Promise<void> {
  const text = await definitionOf(document);
  try {
    if (text.length > MOST_LETTERS) throw new Error(t("template.large"));
    localStorage.setItem(KEY, text);
    lineStore.setState({ complaint: t("template.kept") });
  } catch {
    lineStore.setState({ complaint: t("template.large") });
  }
}

export function forgetTemplate(): void {
  localStorage.removeItem(KEY);
  lineStore.setState({ complaint: t("template.gone") });
}

/** Opens a new definition; gives its id. A template that cannot be read any more is left aside. */
export async function openNew(): Promise<string> {
  const text = template();
  if (text === null) return await open({ new: true });
  return await upload(new File([text], `${t("document.unnamed")}.kd`)).catch(() => open({ new: true }));
}
