/** Documents in and out, over HTTP or by the page's own engine: opening, uploading, downloading. */

import { engine } from "#engine";

import { EXCHANGE_FORMATS } from "../core/exchangeFormats";
import { t } from "../i18n";

/** What the start page offers. */
export interface Start {
  recent: { path: string; name: string; modified: number }[];
  gallery: { id: string; name: string; title: string; group: string; description: string }[];
  open: { id: string; name: string; changed: boolean }[];
  version: string;
  /** Whether the server runs on this machine: paths are those of the person at the keyboard then. */
  local: boolean;
}

export type Opening = { path: string } | { gallery: string } | { new: true };
export type DownloadFormat = "gh" | "ghx" | "kd";

/** The formats that what a definition makes is exported in. */
export const MODEL_FORMATS = ["3dm", ...EXCHANGE_FORMATS, "png"] as const;
export type ExportFormat = (typeof MODEL_FORMATS)[number] | "txt";

/** The files that can be dropped on the page, by the ends of their names. */
export const DEFINITIONS = [".gh", ".ghx", ".kd"];
export const MODELS = [".3dm"];

/** The token of the server, as the address of the page told it; empty where the cookie has it. */
export function token(): string {
  return new URLSearchParams(location.search).get("token") ?? "";
}

export function address(path: string, query: Record<string, string> = {}): string {
  const url = new URL(path, location.href);
  const all = token() ? { ...query, token: token() } : query;
  url.search = new URLSearchParams(all).toString();
  return url.toString();
}

export async function checked(response: Response): Promise<Response> {
  if (response.ok) return response;
  const said = (await response.json().catch(() => undefined)) as { error?: string } | undefined;
  throw new Error(said?.error ?? t("files.failed", { status: response.status }));
}

export async function readStart(): Promise<Start> {
  if (engine) return await engine.start();
  const response = await checked(await fetch(address("api/start")));
  return (await response.json()) as Start;
}

/** Opens a document on the server; gives its id. */
export async function open(what: Opening): Promise<string> {
  if (engine) return await engine.open(what);
  const headers = { "content-type": "application/json" };
  const response = await checked(await fetch(address("api/open"), { method: "POST", headers, body: JSON.stringify(what) }));
  return ((await response.json()) as { document: string }).document;
}

/** Closes a document that nobody shows. */
export async function close(document: string): Promise<void> {
  if (engine) return await engine.close(document);
  const headers = { "content-type": "application/json" };
  await checked(await fetch(address("api/close"), { method: "POST", headers, body: JSON.stringify({ document }) }));
}

/** The address of a picture that the server makes of a definition which is not open. */
export function portrait(of: { gallery: string } | { recent: string }): string {
  return engine && "gallery" in of ? engine.portrait(of.gallery) : address("api/portrait", of);
}

/** Sends a file to the server; gives the id of the document that it is or belongs to. One that is locked is not solved. */
export async function upload(file: File, document?: string, isLocked = false): Promise<string> {
  if (engine) return await engine.upload(file, document, isLocked);
  const query = { name: file.name, ...(document && { document }), ...(isLocked && { locked: "true" }) };
  const response = await checked(await fetch(address("api/upload", query), { method: "POST", body: file }));
  return ((await response.json()) as { document: string }).document;
}

/** A document that is open, as text. */
export async function definitionOf(document: string): Promise<string> {
  if (engine) return new TextDecoder().decode((await engine.bytes(document, "kd")).bytes);
  return await (await checked(await fetch(address("api/save", { document, format: "kd" })))).text();
}

/** A definition as text: files that are none are read by the server and written anew. */
export async function definitionText(file: File): Promise<string> {
  if (!isNamed(file.name, [".gh"])) return await file.text();
  if (engine) return await engine.text(file);
  const asked = { name: file.name, format: "ghx" };
  return await (await checked(await fetch(address("api/convert", asked), { method: "POST", body: file }))).text();
}

/** Has the browser keep the document as a file; a page without a server asks where, if the browser lets it. */
export function download(document: string, format: DownloadFormat): Promise<void> {
  if (engine) return engine.save(document, format);
  return keep(address("api/save", { document, format }));
}

/** Has the browser keep what the definition makes, or what some of its objects have, as a file. */
export function exportAs(document: string, format: ExportFormat, objects: readonly string[] = []): Promise<void> {
  const wishes = objects.length > 0 ? { format, objects: objects.join(",") } : { format };
  if (engine) return engine.export(document, wishes).then(handOver);
  return keep(address("api/export", { document, ...wishes }));
}

/** Has the browser keep a picture of the definition itself: all of its canvas. */
export function exportCanvas(document: string, format: "svg" | "png"): Promise<void> {
  if (engine) return engine.export(document, { format, canvas: true }).then(handOver);
  return keep(address("api/export", { document, format, canvas: "true" }));
}

async function keep(from: string): Promise<void> {
  const response = await checked(await fetch(from));
  const stated = /filename\*?="?([^";]+)"?/.exec(response.headers.get("content-disposition") ?? "")?.[1];
  handOver({ name: stated ?? "katydid", bytes: await response.blob() });
}

function handOver({ name, bytes }: { name: string; bytes: Blob | Uint8Array<ArrayBuffer> }): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(bytes instanceof Blob ? bytes : new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Whether the name ends as one of those. */
export function isNamed(name: string, ends: readonly string[]): boolean {
  const lower = name.toLowerCase();
  return ends.some((end) => lower.endsWith(end));
}

/** Shows another document: a page of its own, so that Back and bookmarks work. */
export function goTo(document: string | undefined, player = false): void {
  const query = new URLSearchParams(location.search);
  query.delete("document");
  query.delete("player");
  if (document) query.set("document", document);
  if (player) query.set("player", "");
  location.search = query.toString();
}

/** Opens the definition that the page's address holds, where it holds one. */
export async function openLink(): Promise<void> {
  const id = await engine?.openLink();
  if (id === undefined) return;
  const url = new URL(location.href);
  url.hash = "";
  url.searchParams.set("document", id);
  location.replace(url);
}

/** The address by which others see the document: with all of it inside, where no server keeps it. */
export async function linkOf(document: string): Promise<string> {
  return engine ? await engine.link(document) : location.href;
}
