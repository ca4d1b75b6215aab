/** The best of the gallery, live: its model turns under the hand, and a few of its inputs move it. */

import { useEffect, useState } from "react";
import { useStore } from "zustand";

import { goTo, open, token, type Start } from "../app/files";
import { t } from "../i18n";
import { inputGroups } from "../player/groups";
import { Input } from "../player/Input";
import { documentStore } from "../state/document";
import { join } from "../state/session";
import { ViewportPane } from "../viewport";

/** The definition that is shown, and how many of its inputs. */
const SHOWN = "tower";
const INPUTS = 4;

const KEY = "katydid.hero";

/** The document that was opened for this before, where the server still has it: not another with each visit. */
function known({ open }: Start): string | undefined {
  try {
    const id = localStorage.getItem(KEY);
    return open.find((document) => document.id === id)?.id;
  } catch {
    return undefined;
  }
}

/** Whether a document is only open to be shown here. */
export function isHero(document: Start["open"][number]): boolean {
  try {
    return !document.changed && document.id === localStorage.getItem(KEY);
  } catch {
    return false;
  }
}

export function Hero({ start }: { start: Start }) {
  const entry = start.gallery.find(({ id }) => id === SHOWN);
  const [id, setId] = useState<string>();
  useEffect(() => {
    if (!entry) return;
    let isGone = false;
    // What the page is for comes first.
    const wait = setTimeout(async () => {
      const document = known(start) ?? (await open({ gallery: SHOWN }));
      if (isGone) return;
      try {
        localStorage.setItem(KEY, document);
      } catch {
        // Another is opened with the next visit.
      }
      setId(document);
    }, 50);
    return () => {
      isGone = true;
      clearTimeout(wait);
    };
    // The start page is read once; closing documents does not open this one anew.
  }, [entry?.id]);
  if (!entry) return null;
  return (
    <section className="hero" aria-label={entry.title}>
      <div className="hero-model">{id && <Live id={id} />}</div>
      <div className="hero-side">
        <h2>{entry.title}</h2>
        <p>{entry.description}</p>
        {id && <Inputs />}
        <button type="button" disabled={!id} onClick={() => goTo(id)}>
          {t("start.hero")}
        </button>
      </div>
    </section>
  );
}

function Live({ id }: { id: string }) {
  useEffect(() => join(id, token()), [id]);
  return <ViewportPane isPlain />;
}

function Inputs() {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const inputs = inputGroups(objects).flatMap((group) => group.inputs).filter(({ object }) => object.control?.is === "slider");
  return (
    <div className="player-inputs">
      {inputs.slice(0, INPUTS).map((input) => (
        <Input key={input.object.id} input={input} />
      ))}
    </div>
  );
}
