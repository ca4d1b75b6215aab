/** The book as it lies in the repository: its pages, and what their figures must give. */
import { existsSync, readFileSync } from "node:fs";

const BOOK = new URL("../../../book/", import.meta.url);

const read = (path: string) => readFileSync(new URL(path, BOOK), "utf8");

/** The folders of the pages of a language, in their order: `V1`, `more/difference`. */
export function pagesOf(language = ""): string[] {
  const listed = read(`${language}contents.md`).matchAll(/^- (\S+)$/gm);
  return [...listed].map(([, folder]) => folder ?? "");
}

/** What the outputs of a definition must give: of `definition.kd` in the file beside it, of another one in a file of its name. */
export function expectedOf(definition: string): Record<string, unknown[]> {
  const path = definition.replace(/definition\.kd$/, "expected.kd").replace(/\.kd$/, ".json");
  if (!existsSync(new URL(path, BOOK))) return {};
  return (JSON.parse(read(path)) as { expect: Record<string, unknown[]> }).expect;
}

export interface Exercise {
  id: string;
  /** Sliders with their values, and `answer`. */
  values: [string, number | boolean][];
}

/** The exercises of a page whose solution is set by sliders and switches. */
export function exercisesOf(folder: string): Exercise[] {
  const found: Exercise[] = [];
  for (const [, block = ""] of read(`${folder}/page.md`).matchAll(/^```exercise\n([\s\S]*?)^```/gm)) {
    const [, id = ""] = /^id: (.+)$/m.exec(block) ?? [];
    const [, solution = ""] = /^solution: (.+)$/m.exec(block) ?? [];
    // Points are set by hand: what they need is tested by the builder of the pages.
    if (solution === "" || solution.includes("(")) continue;
    const values = solution.split(",").map((pair): [string, number | boolean] => {
      const [name = "", value = ""] = pair.split("=").map((side) => side.trim());
      return [name, value === "true" || value === "false" ? value === "true" : Number(value)];
    });
    found.push({ id, values });
  }
  return found;
}

/** What a panel shows is a text, of a number, a point or a domain too. */
function valueIn(found: unknown, wanted: unknown): unknown {
  if (typeof found !== "string" || typeof wanted === "string") return found;
  return Array.isArray(wanted) ? found.replace(/^\{(.*)\}$/, "$1").split(/,| To /).map(Number) : typeof wanted === "number" ? Number(found) : found;
}

/** A matrix comes to a page as its size: its entries are compared by the program's own test (`crates/cli/tests/book.rs`). */
function sizeOf(wanted: unknown): string | undefined {
  if (!Array.isArray(wanted) || !wanted.every((row) => Array.isArray(row))) return undefined;
  const [rows, columns] = [wanted.length, (wanted[0] as unknown[]).length];
  return `Matrix (${rows} row${rows === 1 ? "" : "s"}, ${columns} column${columns === 1 ? "" : "s"})`;
}

/** Numbers agree to a billionth of their size, and to as much where they are smaller than 1. */
export function agrees(shown: unknown, wanted: unknown): boolean {
  if (typeof shown === "string" && shown.startsWith("Matrix (")) return shown === sizeOf(wanted);
  const found = valueIn(shown, wanted);
  if (typeof found === "number" && typeof wanted === "number") return Math.abs(found - wanted) <= 1e-9 * Math.max(Math.abs(wanted), 1);
  if (Array.isArray(found) && Array.isArray(wanted)) return found.length === wanted.length && found.every((one, at) => agrees(one, wanted[at]));
  return found === wanted;
}
