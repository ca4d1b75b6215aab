import { lazy, Suspense, useEffect, useRef, useState } from "react";
import { useStore } from "zustand";

import { shownKeys } from "../actions/keys";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { ResultView } from "../core/protocol/ResultView";
import { Dialog } from "../dialogs/Dialog";
import { dialogStore, showDialog } from "../dialogs/store";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { ask, edit, newGesture } from "../state/session";
import { Messages } from "./Messages";
import { PortTable } from "./PortTable";
import { partsOf, withPart, type Part, type Script } from "./parts";
import "./script.css";

const CodeField = lazy(() => import("./CodeField"));

/** The editor of a script component: its text, its ports, and what its last run said. */
export function ScriptDialog() {
  const id = useStore(dialogStore, (state) => state.object);
  const object = useStore(documentStore, (mirror) => (id === undefined ? undefined : mirror.objects.get(id)));
  const result = useStore(runStore, (run) => (id === undefined ? undefined : run.results.get(id)));
  // One that goes while it is edited, as an undo elsewhere has it, takes its editor along.
  const isGone = object?.control?.is !== "script";
  useEffect(() => {
    if (isGone) showDialog(undefined);
  }, [isGone]);
  if (!object || object.control?.is !== "script") return null;
  return <Editor key={object.id} object={object} script={object.control} result={result} />;
}

interface EditorProps {
  object: ObjectView;
  script: Script;
  result: ResultView | undefined;
}

const NOTHING_SAID: ResultView["messages"] = [];

function Editor({ object, script, result }: EditorProps) {
  // All that is done in here is one step for Undo.
  const [gesture] = useState(newGesture);
  const [draft, setDraft] = useState(script);
  const [part, setPart] = useState<Part>("text");
  const [goTo, setGoTo] = useState<{ line: number; wish: number }>();
  const sent = useRef(script);
  const isChanged = partsOf(draft).some(({ part: own, text }) => text !== partsOf(sent.current).find((other) => other.part === own)?.text);
  const test = async () => {
    sent.current = draft;
    await edit({ do: "reshape", object: object.id, control: draft }, gesture);
  };
  const discard = async () => {
    await ask({ ask: "abandon", gesture }).catch(() => undefined);
    showDialog(undefined);
  };
  const keep = () => {
    if (isChanged) void test();
  };
  const parts = partsOf(draft);
  const name = object.nickname.trim() || object.name;
  const messages = isChanged ? NOTHING_SAID : (result?.messages ?? NOTHING_SAID);
  return (
    <Dialog title={t("script.title", { name, language: script.language })} className="script-editor" onClosing={keep}>
      {parts.length > 1 && (
        <div className="parts" role="radiogroup" aria-label={t("script.part")}>
          {parts.map(({ part: own, label }) => (
            <label key={own}>
              <input type="radio" name="part" checked={part === own} onChange={() => setPart(own)} />
              {t(label)}
            </label>
          ))}
        </div>
      )}
      <div className="columns">
        <div className="text">
          {script.fromWire && <p className="faint">{t("script.fromWire")}</p>}
          <Suspense fallback={<p className="faint">{t("script.loading")}</p>}>
            <CodeField
              key={part}
              language={script.language}
              label={t("script.editor")}
              text={parts.find((one) => one.part === part)?.text ?? ""}
              readOnly={script.fromWire}
              messages={part === "text" ? messages : NOTHING_SAID}
              goTo={goTo}
              onChange={(text) => setDraft((old) => withPart(old, part, text))}
              onTest={() => void test()}
            />
          </Suspense>
          <small className="faint">{t("script.keys", { test: shownKeys("Mod+Enter") })}</small>
        </div>
        <div className="ports">
          <PortTable object={object} side="input" hints={script.hints} gesture={gesture} />
          <PortTable object={object} side="output" hints={script.hints} gesture={gesture} />
        </div>
      </div>
      <Messages
        messages={messages}
        isChanged={isChanged}
        status={result?.status}
        onLine={(line) => {
          setPart("text");
          setGoTo((old) => ({ line, wish: (old?.wish ?? 0) + 1 }));
        }}
      />
      <footer>
        <button type="button" onClick={() => void discard()}>
          {t("script.discard")}
        </button>
        <button type="button" onClick={() => void test()} disabled={script.fromWire}>
          {t("script.test")}
        </button>
        <button
          type="button"
          className="primary"
          onClick={() => {
            keep();
            showDialog(undefined);
          }}
        >
          {t("script.done")}
        </button>
      </footer>
    </Dialog>
  );
}
