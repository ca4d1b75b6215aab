/** What a page of the book and its worker say to each other. Definitions have numbers: a page has several figures. */

export type ToWorker =
  | { is: "open"; definition: number; name: string; text: string }
  | { is: "join"; definition: number }
  | { is: "ask"; definition: number; request: string }
  | { is: "geometry"; number: number; hash: string }
  | { is: "close"; definition: number };

export type FromWorker =
  /** The definition is open; or why it cannot be. */
  | { is: "opened"; definition: number; reason?: string }
  | { is: "event"; definition: number; text: string }
  /** Geometry that belongs to what the definition has just told. */
  | { is: "frame"; definition: number; bytes: ArrayBuffer }
  /** Geometry that was asked for by its hash. */
  | { is: "geometry"; number: number; bytes?: ArrayBuffer };
