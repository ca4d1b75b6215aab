/** Rows of data asked for while somebody looks at them. */

import { useEffect, useState } from "react";

import type { Page } from "../core/protocol/Page";
import { documentStore } from "../state/document";
import { ask } from "../state/session";

/** Asks for rows of a port's data; nothing when they cannot be had. */
export async function rowsOf(port: string, from: number, count: number): Promise<Page | undefined> {
  try {
    const answer = await ask({ ask: "rows", port, from, count, within: documentStore.getState().within });
    return answer.event === "rows" ? answer.page : undefined;
  } catch {
    return undefined;
  }
}

/** Rows of a port, asked for anew when `stamp` changes: the port's result. None are asked for when `count` is 0. */
export function useRows(port: string, from: number, count: number, stamp: unknown): Page | undefined {
  const [page, setPage] = useState<Page | undefined>(undefined);
  useEffect(() => {
    let here = true;
    if (count > 0) {
      void rowsOf(port, from, count).then((rows) => {
        if (here) setPage(rows);
      });
    }
    return () => {
      here = false;
    };
  }, [port, from, count, stamp]);
  return count > 0 ? page : undefined;
}
