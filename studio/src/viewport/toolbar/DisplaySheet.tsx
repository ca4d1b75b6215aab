/** The display modes, each as a picture of a box and a ball that are drawn in it. */

import { useStore } from "zustand";

import { t } from "../../i18n";
import { DISPLAY_MODES } from "../scene/looks";
import { settingsStore } from "../settings";
import { DisplayPicture } from "./DisplayPicture";
import { Popover } from "./Popover";
import "./display.css";

export function DisplaySheet() {
  const mode = useStore(settingsStore, (settings) => settings.mode);
  return (
    <Popover label={t("viewport.mode")} icon={mode === "rendered" ? "shaded" : mode}>
      <div className="display-modes" role="radiogroup" aria-label={t("viewport.mode")}>
        {DISPLAY_MODES.map((name) => (
          <label key={name} className="display-mode">
            <input type="radio" name="display" checked={mode === name} onChange={() => settingsStore.setState({ mode: name })} />
            <DisplayPicture mode={name} />
            <span>{t(`viewport.mode.${name}`)}</span>
          </label>
        ))}
      </div>
    </Popover>
  );
}
