/** Highlighting of the languages of script components. */

import { python } from "@codemirror/lang-python";
import { StreamLanguage, HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { csharp } from "@codemirror/legacy-modes/mode/clike";
import { vb } from "@codemirror/legacy-modes/mode/vb";
import type { Extension } from "@codemirror/state";
import { tags } from "@lezer/highlight";

/** The language by the name that the session gives it; none for one that is not known. */
export function languageOf(name: string): Extension {
  if (/python/i.test(name)) return python();
  if (name === "C#") return StreamLanguage.define(csharp);
  if (name === "VB") return StreamLanguage.define(vb);
  return [];
}

/** Colours by the page's tokens: they change with the theme. */
export const colours: Extension = syntaxHighlighting(
  HighlightStyle.define([
    { tag: [tags.keyword, tags.operatorKeyword, tags.modifier, tags.self], color: "var(--code-keyword)" },
    { tag: [tags.string, tags.special(tags.string), tags.regexp], color: "var(--code-string)" },
    { tag: [tags.number, tags.bool, tags.null, tags.atom], color: "var(--code-number)" },
    { tag: [tags.comment, tags.meta], color: "var(--code-comment)", fontStyle: "italic" },
    { tag: [tags.definition(tags.variableName), tags.function(tags.variableName), tags.className], color: "var(--code-name)" },
    { tag: [tags.typeName, tags.standard(tags.name)], color: "var(--code-type)" },
  ]),
);
