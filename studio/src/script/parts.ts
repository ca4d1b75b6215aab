/** The texts of a script: C# and VB of Grasshopper 1 keep further members and imports beside it. */

import type { Control } from "../core/protocol/Control";
import type { Key } from "../i18n";

export type Script = Extract<Control, { is: "script" }>;
export type Part = "text" | "additional" | "using";

export interface PartText {
  part: Part;
  label: Key;
  text: string;
}

const LABELS: Record<Part, Key> = {
  text: "script.part.text",
  additional: "script.part.additional",
  using: "script.part.using",
};

/** The texts that a script has. */
export function partsOf(script: Script): PartText[] {
  const parts: Part[] = ["text", "additional", "using"];
  return parts.flatMap((part) => {
    const text = script[part];
    return text === null ? [] : [{ part, label: LABELS[part], text }];
  });
}

/** A script with another text in one of its parts. */
export function withPart(script: Script, part: Part, text: string): Script {
  return { ...script, [part]: text };
}
