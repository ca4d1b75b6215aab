/** The components that can be placed, from their pages of help: those are written from the program, and compared with it. */

import { readdirSync, readFileSync } from "node:fs";

export interface Listed {
  id: string;
  name: string;
  tab: string;
  panel: string;
  /** Whether it is kept for old files only. */
  old: boolean;
}

const PAGES = new URL("../../docs/components/", import.meta.url);
const ID = /^`([0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12})`$/m;

export function listed(): Listed[] {
  return readdirSync(PAGES)
    .filter((file) => file.endsWith(".md") && file !== "README.md")
    .flatMap((file) => ofPage(readFileSync(new URL(file, PAGES), "utf8")));
}

/** A page is a panel: its heading says which. It lists its components, then tells of each in the same order. */
function ofPage(page: string): Listed[] {
  const [, tab = "", panel = ""] = /^# (.+?) \/ (.+)$/m.exec(page) ?? [];
  const entries = page.match(/^- \[.+\]\(#.+$/gm) ?? [];
  return page
    .split(/^## /m)
    .slice(1)
    .map((section, k) => {
      const name = section.slice(0, section.indexOf("\n")).trim();
      const [, id = ""] = ID.exec(section) ?? [];
      return { id, name, tab, panel, old: entries[k]?.includes("(earlier version)") === true };
    });
}
