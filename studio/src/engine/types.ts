/** What a page without a server has instead of one. */

import type { DownloadFormat, ExportFormat, Opening, Start } from "../app/files";
import type { CatalogueEntry } from "../core/catalogue";
import type { Line, Listener } from "../core/connection";

export interface Engine {
  /** Joins a document, as a socket would. */
  connect(document: string, listener: Listener): Line;
  start(): Promise<Start>;
  open(what: Opening): Promise<string>;
  close(document: string): Promise<void>;
  /** The address of a picture of a definition of the gallery. */
  portrait(gallery: string): string;
  upload(file: File, document: string | undefined, isLocked: boolean): Promise<string>;
  /** A document that is open, in a form. */
  bytes(document: string, format: DownloadFormat): Promise<Kept>;
  /** A definition as text. */
  text(file: File): Promise<string>;
  export(document: string, wishes: { format: ExportFormat; objects?: string; canvas?: boolean }): Promise<Kept>;
  components(): Promise<CatalogueEntry[]>;
  /** What the help window says of a component. */
  help(component: string): Promise<unknown>;
  geometry(hash: string): Promise<ArrayBuffer>;
  /** A picture that the document holds, as an address. */
  picture(hash: string): Promise<string>;
  /** Saves a document in a file that the user names, where the browser can; else has the browser keep it. */
  save(document: string, format: DownloadFormat): Promise<void>;
  /** An address with all of the document in it. */
  link(document: string): Promise<string>;
  /** Opens what the page's address holds; gives the id, or nothing where it holds none. */
  openLink(): Promise<string | undefined>;
}

/** A file to be kept. */
export interface Kept {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}
