/** The paths of a port's data without the items between them. */

import { useEffect, useState } from "react";

import { rowsOf } from "./rows";

export interface PathRow {
  path: string;
  items: number;
}

/** Rows that are asked for at once, while branches are small. */
const ROWS = 400;
/** Questions for one tree, at most: after that what is known is shown. */
const MOST_QUESTIONS = 60;

/** Asks for the first paths. The head of each branch tells where the next one is, so that long ones are skipped. */
export async function pathsOf(port: string, most: number, ask = rowsOf): Promise<PathRow[]> {
  const paths: PathRow[] = [];
  let [from, total, last] = [0, Infinity, 0];
  for (let question = 0; question < MOST_QUESTIONS && from < total && paths.length < most; question++) {
    const page = await ask(port, from, last > ROWS / 2 ? 1 : ROWS);
    if (!page || page.rows.length === 0) break;
    total = page.total;
    let next = page.from + page.rows.length;
    page.rows.forEach((row, k) => {
      if (row.is !== "path") return;
      paths.push({ path: row.path, items: row.items });
      last = row.items;
      next = Math.max(page.from + k + row.items + 1, page.from + page.rows.length);
    });
    from = next;
  }
  return paths.slice(0, most);
}

/** The paths of a port, asked for anew when `stamp` changes. */
export function usePaths(port: string, most: number, stamp: unknown): readonly PathRow[] | undefined {
  const [paths, setPaths] = useState<readonly PathRow[] | undefined>(undefined);
  useEffect(() => {
    let here = true;
    void pathsOf(port, most).then((found) => {
      if (here) setPaths(found);
    });
    return () => {
      here = false;
    };
  }, [port, most, stamp]);
  return paths;
}
