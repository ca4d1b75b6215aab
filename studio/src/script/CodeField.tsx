/** The text field of the script editor: CodeMirror, fetched when the first one opens. */

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit } from "@codemirror/language";
import { lintGutter, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension, type Text } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { useEffect, useRef } from "react";

import type { MessageView } from "../core/protocol/MessageView";
import { colours, languageOf } from "./languages";

export interface CodeFieldProps {
  language: string;
  label: string;
  /** The text that it begins with. */
  text: string;
  readOnly: boolean;
  messages: readonly MessageView[];
  /** The line that is gone to, and a number that tells one wish from the next. */
  goTo: { line: number; wish: number } | undefined;
  onChange(text: string): void;
  onTest(): void;
}

export default function CodeField(props: CodeFieldProps) {
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView>(undefined);
  const latest = useRef(props);
  useEffect(() => {
    latest.current = props;
  });
  const { messages, goTo } = props;
  useEffect(() => {
    if (!place.current) return;
    const { language, label, text, readOnly } = latest.current;
    const state = EditorState.create({
      doc: text,
      extensions: [
        basics(readOnly),
        languageOf(language),
        EditorView.contentAttributes.of({ "aria-label": label }),
        keymap.of([{ key: "Mod-Enter", run: () => (latest.current.onTest(), true) }]),
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, indentWithTab]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) latest.current.onChange(update.state.doc.toString());
        }),
      ],
    });
    const made = new EditorView({ state, parent: place.current });
    view.current = made;
    made.focus();
    return () => made.destroy();
  }, []);
  useEffect(() => {
    const editor = view.current;
    if (editor) editor.dispatch(setDiagnostics(editor.state, diagnostics(editor.state.doc, messages)));
  }, [messages]);
  useEffect(() => {
    const editor = view.current;
    if (!editor || !goTo) return;
    const line = editor.state.doc.line(Math.min(Math.max(goTo.line, 1), editor.state.doc.lines));
    editor.dispatch({ selection: { anchor: line.from }, effects: EditorView.scrollIntoView(line.from, { y: "center" }) });
    editor.focus();
  }, [goTo]);
  return <div ref={place} className="code-field" />;
}

function basics(readOnly: boolean): Extension {
  return [
    lineNumbers(),
    lintGutter(),
    history(),
    drawSelection(),
    indentOnInput(),
    // Four spaces, as Python's own guide has it.
    indentUnit.of("    "),
    bracketMatching(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSelectionMatches(),
    colours,
    EditorState.readOnly.of(readOnly),
  ];
}

/** What was said of lines, each at its line. */
function diagnostics(text: Text, messages: readonly MessageView[]): Diagnostic[] {
  return messages.flatMap(({ line, level, text: message }): Diagnostic[] => {
    if (line === undefined || line > text.lines) return [];
    const { from, to } = text.line(line);
    return [{ from, to, message, severity: level === "error" ? "error" : level === "warning" ? "warning" : "info" }];
  });
}
