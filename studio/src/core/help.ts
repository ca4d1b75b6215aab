/** What the help window says of a component, read from `GET /api/help`. */

import type { CatalogueEntry, CataloguePort } from "./catalogue";

export interface HelpPort extends CataloguePort {
  /** Whether there can be any number of such ports. */
  many: boolean;
}

export type Help =
  | ({ is: "component"; inputs: readonly HelpPort[]; outputs: readonly HelpPort[] } & Pick<
      CatalogueEntry,
      "guid" | "name" | "nick" | "tab" | "panel" | "help" | "old" | "floating"
    >)
  | { is: "unsupported"; name: string; reason: string };

type Loose = Record<string, unknown>;

function loose(value: unknown): Loose {
  return typeof value === "object" && value !== null ? (value as Loose) : {};
}

const text = (value: unknown) => (typeof value === "string" ? value : "");

function ports(value: unknown): HelpPort[] {
  const list: unknown[] = Array.isArray(value) ? value : [];
  return list.map(loose).map((port) => ({
    name: text(port.name),
    nick: text(port.nick),
    help: text(port.help),
    kind: text(port.kind),
    access: text(port.access),
    optional: port.optional === true,
    many: port.many === true,
  }));
}

/** The help in an answer of the server; none where there is none in it. */
export function readHelp(answer: unknown): Help | undefined {
  const found = loose(answer);
  const name = text(found.name);
  if (name === "") return undefined;
  if (typeof found.unsupported === "string") return { is: "unsupported", name, reason: found.unsupported };
  return {
    is: "component",
    guid: text(found.guid),
    name,
    nick: text(found.nick),
    tab: text(found.tab),
    panel: text(found.panel),
    help: text(found.help),
    old: found.old === true,
    floating: found.floating === true,
    inputs: ports(found.inputs),
    outputs: ports(found.outputs),
  };
}

/** The first line of a help text, which says what the component does, and the paragraphs after it. */
export function paragraphs(help: string): string[] {
  return help
    .split("\n")
    .map((line) => line.trim())
    .filter((line) => line !== "");
}
