/** The rows of a study, as the server tells them piece by piece. */

export type Cell = number | string | boolean | null;

export interface Row {
  /** The number of the point in its plan. */
  point: number;
  /** The word for how it came out; empty where the table has none. */
  status: string;
  reason: string;
  /** Files in the folder; empty where there is none. */
  picture: string;
  geometry: string;
  /** A cell for each column. */
  cells: readonly Cell[];
}

export interface Column {
  name: string;
  kind: "in" | "out";
  /** Whether all cells are numbers or nothing. */
  number: boolean;
}

/** What an output is to be. */
export type Goal = "least" | "most" | { near: number };

/** A side on which an output must stay. */
export type Bound = { "at-most": number } | { "at-least": number };

export type State = "empty" | "running" | "stopped" | "done";

interface About {
  /** Changes when rows that were there are gone. */
  generation: number;
  /** Rows of the study, with those that are not told. */
  total: number;
  planned: number | null;
  state: State;
  name: string;
  /** The name of the definition, where points can be opened. */
  definition: string | null;
  goals: { output: string; goal: Goal }[] | null;
  bounds: { output: string; bound: Bound }[] | null;
  columns: Column[];
  problem: string | null;
}

/** What the server tells: the rows from a place on. */
export interface Answer extends About {
  from: number;
  rows: [number, string, string, string, string, Cell[]][];
}

export interface Study extends About {
  rows: readonly Row[];
}

const rowOf = ([point, status, reason, picture, geometry, cells]: Answer["rows"][number]): Row => ({ point, status, reason, picture, geometry, cells });

/** A study with what came; the same one where nothing did. */
export function merged(known: Study | undefined, answer: Answer): Study {
  const { from, rows, ...about } = answer;
  const kept = from === 0 ? [] : (known?.rows.slice(0, from) ?? []);
  if (known && rows.length === 0 && from === known.rows.length && sameAbout(known, about)) return known;
  const all = rows.length === 0 && known && from === known.rows.length ? known.rows : [...kept, ...rows.map(rowOf)];
  // What hangs on the columns is not made anew with each point.
  const columns = known && JSON.stringify(known.columns) === JSON.stringify(about.columns) ? known.columns : about.columns;
  return { ...about, columns, rows: all };
}

function sameAbout({ rows: _, ...known }: Study, about: About): boolean {
  return JSON.stringify(known) === JSON.stringify(about);
}

/** Whether a row has results that can be used. */
export const isGood = ({ status }: Row) => status === "" || status === "ok" || status === "warning";
