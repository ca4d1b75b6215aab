/** Cameras with names, and the turntable. */

import { useState, type FormEvent } from "react";
import { useStore } from "zustand";

import { action } from "../../actions/registry";
import { t } from "../../i18n";
import { cameraStore, removeCamera, saveCamera, showCamera } from "../cameras";
import { isStill } from "../pane/open";
import { settingsStore } from "../settings";
import { Check } from "./fields";
import { Popover } from "./Popover";
import "./sheets.css";

export function CameraSheet() {
  const cameras = useStore(cameraStore, (store) => store.cameras);
  const [name, setName] = useState("");
  const save = (event: FormEvent) => {
    event.preventDefault();
    saveCamera(name);
    setName("");
  };
  return (
    <Popover label={t("viewport.cameras")} icon="camera">
      {cameras.length === 0 && <p>{t("viewport.cameras.none")}</p>}
      <ul className="viewport-layers" aria-label={t("viewport.cameras")}>
        {cameras.map((camera) => (
          <li key={camera.name} className="viewport-camera">
            <button type="button" className="quiet" onClick={() => showCamera(camera, isStill())}>
              {camera.name}
            </button>
            <button type="button" className="quiet" aria-label={t("viewport.cameras.remove", { name: camera.name })} onClick={() => removeCamera(camera.name)}>
              ×
            </button>
          </li>
        ))}
      </ul>
      <form className="viewport-camera" onSubmit={save}>
        <input type="text" aria-label={t("viewport.cameras.name")} placeholder={t("viewport.cameras.name")} value={name} onChange={({ target }) => setName(target.value)} />
        <button type="submit">{t("viewport.cameras.save")}</button>
      </form>
      <hr />
      <Turntable />
      <FilmButton />
      <small>{t("viewport.cameras.kept")}</small>
    </Popover>
  );
}

/** Not for those who asked their system for less motion. */
function Turntable() {
  const isOn = useStore(settingsStore, (settings) => settings.turntable);
  if (isStill()) return null;
  return <Check label="viewport.turntable" checked={isOn} onChange={() => void action("viewport.turntable")?.run()} />;
}

/** Films one turn of the model; it is kept by the browser as a file. */
function FilmButton() {
  const [isFilming, setFilming] = useState(false);
  const film = async () => {
    setFilming(true);
    try {
      await action("viewport.film")?.run();
    } finally {
      setFilming(false);
    }
  };
  return (
    <>
      <button type="button" disabled={isFilming} onClick={() => void film()}>
        {t("viewport.film")}
      </button>
      <small role="status">{isFilming ? t("viewport.film.running") : ""}</small>
    </>
  );
}
