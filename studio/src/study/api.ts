/** The study over HTTP. */

import { address, checked, token } from "../app/files";
import type { Answer } from "./core/rows";

/** The rows that the page does not have. */
export async function readRows(generation: number, from: number): Promise<Answer> {
  const response = await checked(await fetch(address("api/study", { generation: String(generation), from: String(from) })));
  return (await response.json()) as Answer;
}

/** The address of a picture or of geometry in the folder. */
export function fileAddress(name: string): string {
  return address(`api/study/file/${name.split("/").map(encodeURIComponent).join("/")}`);
}

/** Opens a point's definition with its values; gives the address of the studio on it. */
export async function openPoint(point: number): Promise<string> {
  const headers = { "content-type": "application/json" };
  const response = await checked(await fetch(address("api/study/open"), { method: "POST", headers, body: JSON.stringify({ point }) }));
  const { document } = (await response.json()) as { document: string };
  return `./?${new URLSearchParams({ document, ...(token() ? { token: token() } : {}) }).toString()}`;
}
