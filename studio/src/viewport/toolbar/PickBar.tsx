/** What is being picked or drawn for an input: which tool, what comes next, and a field for coordinates. */

import { useEffect, useRef, useState, type FormEvent } from "react";
import { useStore } from "zustand";

import { isTyping } from "../../actions/keys";
import { typedPoint } from "../../core/coordinates";
import { measures } from "../../core/drawing";
import { shortNumber } from "../../core/falseColour";
import { t, type Key } from "../../i18n";
import { documentStore } from "../../state/document";
import { modelStore } from "../../state/model";
import { chooseTool, dropPoint, finish, leave, pickStore, takePoint, takeSource, toolsOf, type PickJob } from "../../state/pickJob";
import { currentDrawer, currentViewport } from "../current";
import { settingsStore, type Snaps } from "../settings";
import { frameOf } from "../tools/drawer";
import { Check } from "./fields";
import "./picking.css";

export function PickBar() {
  const job = useStore(pickStore, (store) => store.job);
  return job ? <Bar key={job.gesture} job={job} /> : null;
}

const frame = () => {
  const viewport = currentViewport();
  return viewport && frameOf(viewport);
};

const end = () => {
  const plane = frame();
  if (plane) void finish(plane);
};

/** Keys work wherever the focus is, but for those that a field or a button takes itself. */
function followKeys(event: KeyboardEvent): void {
  if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
  const isButton = event.target instanceof HTMLButtonElement || event.target instanceof HTMLInputElement;
  if (event.key === "Escape") leave();
  else if (event.key === "Enter" && !isButton && !isTyping(event.target)) end();
  else if (event.key === "Backspace" && !isTyping(event.target)) dropPoint();
  else return;
  event.preventDefault();
  event.stopPropagation();
}

function Bar({ job }: { job: PickJob }) {
  const name = useStore(documentStore, ({ inputs, objects }) => {
    const place = inputs.get(job.port);
    const object = place && objects.get(place.object);
    return object?.nickname || object?.name || "";
  });
  useEffect(() => {
    addEventListener("keydown", followKeys, true);
    return () => removeEventListener("keydown", followKeys, true);
  }, []);
  const title = t(job.isMany ? "pick.many" : "pick.one", { kind: t(`pick.kind.${job.kind}` as Key), name });
  return (
    <section className="viewport-telling viewport-picking" aria-label={title}>
      <header>
        <strong>{title}</strong>
        {job.isMany && <span role="status">{t("pick.count", { count: job.items.length })}</span>}
      </header>
      <div className="pick-tools" role="radiogroup" aria-label={t("pick.tool")}>
        {toolsOf(job).map((tool) => (
          <button key={tool} type="button" role="radio" aria-checked={job.tool === tool} onClick={() => chooseTool(tool)}>
            {t(`pick.tool.${tool}`)}
          </button>
        ))}
      </div>
      {job.tool === "pick" ? <ModelObjects job={job} /> : <Coordinates job={job} />}
      <footer>
        <button type="button" className="primary" onClick={end}>
          {t("pick.done")}
        </button>
        <button type="button" onClick={leave}>
          {t("pick.leave")}
        </button>
      </footer>
    </section>
  );
}

const SNAPS: readonly (keyof Snaps)[] = ["end", "mid", "near"];

function Coordinates({ job }: { job: PickJob }) {
  const [text, setText] = useState("");
  const [isWrong, setWrong] = useState(false);
  const { snaps, snap } = useStore(settingsStore);
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.focus({ preventScroll: true }), [job.tool]);
  const take = (event: FormEvent) => {
    event.preventDefault();
    const plane = frame();
    if (!plane) return;
    if (text.trim() === "") return void finish(plane);
    const last = job.points.at(-1);
    const point = typedPoint(text, { frame: plane, last, towards: currentDrawer()?.towards });
    setWrong(point === undefined);
    if (!point) return;
    setText("");
    takePoint(point, plane);
  };
  const plane = frame();
  const sizes = plane && job.tool !== "pick" ? measures(job.tool, job.points, plane).map(shortNumber).join(" × ") : "";
  const next = `pick.next.${job.tool}.${Math.min(job.points.length, 1)}` as Key;
  return (
    <>
      <form onSubmit={take}>
        <label>
          <span>
            {t(next)} <small>{job.points.length > 1 && sizes}</small>
          </span>
          <input
            ref={field}
            type="text"
            spellCheck={false}
            autoComplete="off"
            value={text}
            placeholder={t("pick.placeholder")}
            title={t("pick.coordinates")}
            aria-invalid={isWrong}
            aria-describedby={isWrong ? "pick-wrong" : undefined}
            onChange={({ target }) => {
              setText(target.value);
              setWrong(false);
            }}
          />
        </label>
      </form>
      {isWrong && (
        <p id="pick-wrong" role="alert">
          {t("pick.wrong")}
        </p>
      )}
      <div className="pick-snaps" role="group" aria-label={t("pick.snaps")}>
        {SNAPS.map((each) => (
          <Check key={each} label={`pick.snap.${each}`} checked={snaps[each]} onChange={(on) => settingsStore.setState({ snaps: { ...snaps, [each]: on } })} />
        ))}
        <Check label="pick.snap.grid" checked={snap} onChange={(on) => settingsStore.setState({ snap: on })} />
      </div>
    </>
  );
}

/** A list has so many objects of the model at most. */
const MOST_LISTED = 300;

/** The objects of the model, for hands that do not point. */
function ModelObjects({ job }: { job: PickJob }) {
  const model = useStore(modelStore, (store) => store.model);
  const fitting = (model?.layers ?? []).flatMap(({ path, objects }) => objects.filter(({ kind }) => fits(kind, job.kind)).map((object) => ({ ...object, path })));
  const taken = new Set(job.items.flatMap((item) => (item.from === "model" ? [item.object] : [])));
  return (
    <>
      <p>{t(model ? "pick.fromModel" : "pick.fromPreviews")}</p>
      {fitting.length > 0 && (
        <select
          aria-label={t("pick.objects")}
          value=""
          onChange={({ target }) => target.value && void takeSource({ from: "model", object: target.value })}
        >
          <option value="">{t("pick.objects")}</option>
          {fitting.slice(0, MOST_LISTED).map(({ id, name, kind, path }) => (
            <option key={id} value={id} disabled={taken.has(id)}>
              {`${name || kind} · ${path} · ${id.slice(0, 8)}`}
            </option>
          ))}
        </select>
      )}
    </>
  );
}

/** Whether an object of one type can be set in an input of another: the session has the last word. */
function fits(object: string, input: string): boolean {
  if (object === "") return false;
  if (input === "Geometry" || object === input) return true;
  if (input === "Curve") return ["Line", "Circle", "Arc", "Rectangle"].includes(object);
  return (input === "Brep" || input === "Surface") && ["Brep", "Surface", "Geometry"].includes(object);
}
