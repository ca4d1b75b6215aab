/** What moves a number of the selected object, and inputs for a wanted one. */

import { useEffect, useState, type FormEvent } from "react";
import { useStore } from "zustand";

import type { DerivativeView } from "../core/protocol/DerivativeView";
import type { HereView } from "../core/protocol/HereView";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { RangedView } from "../core/protocol/RangedView";
import { title } from "../core/outline";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { ask } from "../state/session";
import { findEffects, keyOf, look, showMotion, solveFor, studyStore } from "../state/study";
import { uiStore } from "../state/ui";
import "./effects.css";

const set = studyStore.setState;

/** A number as it is read, not as it is kept. */
function short(value: number): string {
  return String(Number(value.toPrecision(5)));
}

/** The outputs of which numbers can be asked; an object without any stands for what comes to it. */
function portsOf(object: ObjectView): { id: string; name: string }[] {
  return object.outputs.length > 0 ? object.outputs : [{ id: object.id, name: title(object) }];
}

export function Effects() {
  const id = useStore(uiStore, (ui) => (ui.selection.size === 1 ? [...ui.selection][0] : undefined));
  const object = useStore(documentStore, (mirror) => (id ? mirror.objects.get(id) : undefined));
  const target = useStore(studyStore, (study) => study.target);
  const ports = object ? portsOf(object) : [];
  const port = ports.find((one) => one.id === target) ?? ports[0];
  useEffect(() => look(port?.id), [port?.id]);
  useEffect(() => () => {
    set({ drags: false });
    void showMotion(undefined);
    look(undefined);
  }, []);
  if (!object || !port) return <p>{t("effects.choose")}</p>;
  return (
    <>
      <h3>{title(object)}</h3>
      {ports.length > 1 && (
        <label>
          {t("effects.of")}{" "}
          <select value={port.id} onChange={(event) => look(event.target.value)}>
            {ports.map((one) => (
              <option key={one.id} value={one.id}>
                {one.name}
              </option>
            ))}
          </select>
        </label>
      )}
      <Ask />
      <Here />
      <Ranges />
      <Wanted />
    </>
  );
}

function Ask() {
  const { busy, refused, effects, of } = useStore(studyStore);
  const revision = useStore(documentStore, (mirror) => mirror.revision);
  return (
    <>
      <div className="row">
        <button type="button" title={t("effects.hereHelp")} disabled={busy !== undefined} onClick={() => void findEffects(false)}>
          {t("effects.here")}
        </button>
        <button type="button" title={t("effects.rangesHelp")} disabled={busy !== undefined} onClick={() => void findEffects(true)}>
          {t("effects.ranges")}
        </button>
      </div>
      <p role="status">
        {busy && (
          <>
            {t("effects.busy")}{" "}
            <button type="button" onClick={() => void ask({ ask: "endStudy" }).catch(() => {})}>
              {t("effects.stop")}
            </button>
          </>
        )}
        {!busy && refused}
        {!busy && !refused && effects && t("effects.value", { value: short(effects.value) })}
        {!busy && effects && of && of.revision !== revision && ` ${t("effects.stale")}`}
      </p>
    </>
  );
}

function Here() {
  const effects = useStore(studyStore, (study) => study.effects);
  const motion = useStore(studyStore, (study) => study.motion);
  if (!effects) return null;
  if (effects.here.length === 0) return <p>{t("effects.none")}</p>;
  return (
    <section>
      <h4>{t("effects.here")}</h4>
      <table className="effects">
        <thead>
          <tr>
            <th scope="col">{t("effects.input")}</th>
            <th scope="col">{t("effects.change")}</th>
            <th scope="col">{t("effects.holds")}</th>
          </tr>
        </thead>
        <tbody>
          {effects.here.map((here) => (
            <HereRow key={keyOf(here.input)} here={here} isShown={motion?.input === keyOf(here.input)} />
          ))}
        </tbody>
      </table>
      {motion && motion.view.leftOut.length > 0 && <p className="soft">{t("effects.motionLeft", { n: motion.view.leftOut.length })}</p>}
    </section>
  );
}

function HereRow({ here, isShown }: { here: HereView; isShown: boolean }) {
  const { input, slope, holds } = here;
  const isEven = slope.is !== "steps";
  return (
    <tr>
      <th scope="row">
        {isEven ? (
          <button
            type="button"
            className="link"
            aria-pressed={isShown}
            aria-label={t("effects.motion", { name: nameOf(here) })}
            title={t("effects.motion", { name: nameOf(here) })}
            onClick={() => void showMotion(isShown ? undefined : input)}
          >
            {isShown ? "↗ " : ""}
            {nameOf(here)}
          </button>
        ) : (
          nameOf(here)
        )}
      </th>
      <td>{slopeText(slope)}</td>
      <td>
        {holds && (
          <>
            {t("effects.from", { from: short(holds[0].at), to: short(holds[1].at) })}
            {holds.filter((end) => !end.isLimit).map((end) => (
              <small key={end.at}>{t("effects.why", { at: short(end.at), why: end.why })}</small>
            ))}
          </>
        )}
      </td>
    </tr>
  );
}

/** The name of an input as the canvas has it, since several may have the same; elsewhere its path. */
function nameOf({ input, name }: { input: HereView["input"]; name: string }): string {
  const { objects, within } = documentStore.getState();
  const isShown = within.join() === input.within.join();
  const object = isShown ? objects.get(input.object) : undefined;
  const own = object?.nickname || object?.name;
  if (!own) return name;
  return input.gene === null ? own : `${own}.${input.gene}`;
}

/** How a number changes, in words. Exported for tests. */
export function slopeText(slope: HereView["slope"]): string {
  const one = (by: DerivativeView | null) => (by ? t("effects.even", { value: short(by.value), error: by.error.toPrecision(1) }) : t("effects.nothing"));
  const step = (by: number | null) => (by === null ? t("effects.nothing") : short(by));
  if (slope.is === "even") return one(slope.by);
  if (slope.is === "corner") return t("effects.corner", { left: one(slope.left), right: one(slope.right) });
  if (slope.is === "steps") return t("effects.steps", { down: step(slope.down), up: step(slope.up) });
  return t("effects.jump");
}

function Ranges() {
  const effects = useStore(studyStore, (study) => study.effects);
  if (!effects || effects.ranged.length === 0) return null;
  const [points, failed] = effects.points;
  const sorted = [...effects.ranged].sort((a, b) => (b.share?.total[0] ?? 0) - (a.share?.total[0] ?? 0));
  return (
    <section>
      <h4>{t("effects.ranges")}</h4>
      <table className="effects">
        <thead>
          <tr>
            <th scope="col">{t("effects.input")}</th>
            <th scope="col">{t("effects.share")}: {t("effects.alone")}</th>
            <th scope="col">{t("effects.total")}</th>
          </tr>
        </thead>
        <tbody>
          {sorted.map((ranged) => (
            <tr key={keyOf(ranged.input)}>
              <th scope="row">{nameOf(ranged)}</th>
              <td><Share of={ranged} which="alone" /></td>
              <td><Share of={ranged} which="total" /></td>
            </tr>
          ))}
        </tbody>
      </table>
      <p className="soft">{t("effects.points", { points, failed })}</p>
    </section>
  );
}

/** A share as a bar and in numbers, with its confidence. */
function Share({ of: { share }, which }: { of: RangedView; which: "alone" | "total" }) {
  if (!share) return <>{t("effects.nothing")}</>;
  const [value, confidence] = share[which];
  const percent = (part: number) => Math.round(part * 100);
  return (
    <>
      <span className="share" aria-hidden="true" style={{ width: `${Math.min(100, Math.max(0, percent(value)))}%` }} />
      {percent(value)} ± {percent(confidence)} %
    </>
  );
}

function Wanted() {
  const { effects, fixed, solved, drags, busy } = useStore(studyStore);
  const [text, setText] = useState("");
  const [isWrong, setWrong] = useState(false);
  const find = (event: FormEvent) => {
    event.preventDefault();
    const numbers = text.split(",").map((part) => Number(part.trim() === "" ? NaN : part));
    const isRight = numbers.every(Number.isFinite) && (numbers.length === 1 || numbers.length === 3);
    setWrong(!isRight);
    if (isRight) void solveFor(numbers);
  };
  const even = effects?.here.filter(({ slope }) => slope.is !== "steps") ?? [];
  const toggle = (key: string, on: boolean) => {
    const next = new Set(fixed);
    if (on) next.delete(key);
    else next.add(key);
    set({ fixed: next });
  };
  return (
    <section>
      <h4>{t("effects.wanted")}</h4>
      <p className="soft">{t("effects.wantedHelp")}</p>
      <form className="row" onSubmit={find}>
        <label>
          {t("effects.wantedLabel")}{" "}
          <input type="text" inputMode="decimal" value={text} aria-invalid={isWrong} onChange={({ target }) => setText(target.value)} />
        </label>
        <button type="submit" disabled={busy !== undefined}>
          {t("effects.find")}
        </button>
      </form>
      {isWrong && <p role="alert">{t("effects.wrong")}</p>}
      {even.length > 0 && (
        <fieldset>
          <legend>{t("effects.moves")}</legend>
          {even.map((here) => (
            <label key={keyOf(here.input)} className="effects-check">
              <input type="checkbox" checked={!fixed.has(keyOf(here.input))} onChange={({ target }) => toggle(keyOf(here.input), target.checked)} />
              {nameOf(here)}
            </label>
          ))}
        </fieldset>
      )}
      <label className="effects-check" title={t("effects.dragHelp")}>
        <input type="checkbox" checked={drags} onChange={({ target }) => set({ drags: target.checked })} />
        {t("effects.drag")}
      </label>
      <p role="status">{solved && t("effects.found", { numbers: solved.numbers.map(short).join(", "), off: short(solved.off) })}</p>
    </section>
  );
}
