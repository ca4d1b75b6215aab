/** Where the module comes from. */
export type Source = string | URL | Request | Response | Promise<Response> | BufferSource | WebAssembly.Module;
/** Katydid's text as a string, or the bytes of a .gh, .ghx or .kd file. */
export type Input = string | ArrayBuffer | Uint8Array;
/** The forms of a definition. */
export type Form = "gh" | "ghx" | "kd";

/**
 * Loads the module; once, however often it is asked. All functions that give promises do it by themselves: it is for those
 * who keep `katydid_bg.wasm` elsewhere, or want it loaded early.
 */
export function init(source?: Source): Promise<void>;

/** Opens a definition. An error says what is wrong with it, and where. */
export function open(definition: Input): Promise<Definition>;

/** A definition in another form. */
export function convert(definition: Input, to: Form): Promise<Uint8Array>;

/** The components that there are. */
export function components(): Promise<{ guid: string; name: string; nick: string; tab: string; panel: string; help: string }[]>;

/** The version of Katydid. */
export function version(): Promise<string>;

/** What can be set: a slider, panel, toggle, value list, parameter, or what a group `RH_IN:name` holds. */
export interface InputOf {
  name: string;
  id: string;
}

/** An output of an object. */
export interface OutputOf {
  /** The name of a group `RH_OUT:name`; else the object's nickname, and behind a dot the port's. */
  name: string;
  /** The port, and the object. */
  id: string;
  object: string;
  /** Whether such a group marks it. */
  marked: boolean;
}

/** What a solve did. */
export interface Solved {
  milliseconds: number;
  /** How many objects were solved, and how many are left since time was over. */
  solved: number;
  unfinished: number;
}

/** How pictures are made. */
export interface PictureWishes {
  format?: "svg" | "png";
  /** In pixels; 1600 by 1000. */
  width?: number;
  height?: number;
  view?: "perspective" | "top" | "front" | "right" | "iso";
  /** The definition itself instead of what it makes. */
  canvas?: boolean;
}

/** The results, as `katydid run --json` prints them. */
export interface Report {
  katydid: string;
  units: string;
  milliseconds: number;
  objects: {
    id: string;
    component: string;
    name: string;
    nickname: string;
    kind: "component" | "parameter" | "annotation";
    status: "ok" | "warning" | "error" | "disabled" | "unsupported" | "no-data";
    messages: { level: "remark" | "warning" | "error"; text: string }[];
    milliseconds: number;
    outputs: { name: string; nickname: string; type: string; branches: { path: string; items: unknown[] }[] }[];
  }[];
}

/** The data of an output when it was read. */
export interface Data {
  /** The type of the items: `Number`, `Point`, `Curve`. */
  readonly kind: string;
  /** The paths of the branches, and where each ends among the items. */
  readonly paths: string[];
  readonly ends: number[];
  readonly count: number;
  /** The items as panels show them. */
  texts(): (string | null)[];
  /** Numbers, integers and booleans: one number each; points and vectors: three. NaN where an item is null. */
  numbers(): Float64Array;
}

/** A definition that is open. */
export class Definition {
  private constructor();
  readonly inputs: InputOf[];
  readonly outputs: OutputOf[];
  /** Sets an input by its name or id; gives the id of the object. What is given is read as a panel's text would be. */
  set(name: string, value: string | number | boolean): string;
  /** Solves what has changed; with `seconds`, for no longer. The thread waits for it: use a worker for what may be long. */
  solve(options?: { seconds?: number }): Solved;
  /** The results of all objects; with `values` numbers in full precision. */
  report(options?: { values?: boolean }): Report;
  /** The data of an output by its id or name. */
  read(name: string): Data;
  picture(wishes?: PictureWishes & { format?: "svg" }): string;
  picture(wishes: PictureWishes & { format: "png" }): Uint8Array;
  /** What it makes as a file: `3dm`, `glb`, `step`, `obj`, `stl`, `ply` and others; of some objects only, by their ids. */
  export(format: string, options?: { objects?: string[] }): Uint8Array;
  /** The definition itself. */
  save(format?: Form): Uint8Array;
  /** Gives its memory back. It cannot be used after that. */
  close(): void;
}

/** What the studio's worker is made of; its names may change with any version. */
export const raw: {
  Document: new (name: string, bytes: Uint8Array | undefined, journal: Uint8Array, locked: boolean) => RawDocument;
  components(): string;
  component(guid: string): string | undefined;
  gallery(): string;
  galleryText(id: string): Uint8Array | undefined;
  convert(bytes: Uint8Array, to: string): Uint8Array;
  portrait(bytes: Uint8Array): Uint8Array | undefined;
  version(): string;
};

/** A document that one client works on, in the words of the studio's protocol. */
export interface RawDocument {
  join(): void;
  ask(request: string): void;
  isDue(): boolean;
  work(): void;
  take(): (string | Uint8Array)[];
  takeWritten(): [boolean, Uint8Array][];
  tick(): void;
  flush(): void;
  name(): string;
  isChanged(): boolean;
  bytes(to: string): Uint8Array;
  saved(name: string): void;
  isKeptIn(name: string): void;
  keepRestored(): void;
  attach(name: string, bytes: Uint8Array): void;
  export(wishes: string): Uint8Array;
  geometry(hash: string): Uint8Array | undefined;
  picture(name: string): [Uint8Array, string] | undefined;
  free(): void;
}
