import { useStore } from "zustand";

import { action } from "../../actions/registry";
import { shownKeys } from "../../actions/keys";
import { t, type Key } from "../../i18n";
import { PREVIEWS, settingsStore, viewportStore, type Shown } from "../settings";
import { VIEW_NAMES, type ViewName } from "../views";
import { AnalysisSheet } from "./AnalysisSheet";
import { Check } from "./fields";
import { Icon, type IconName } from "./icons";
import { Popover } from "./Popover";
import { CameraSheet } from "./CameraSheet";
import { DisplaySheet } from "./DisplaySheet";
import { LayerSheet } from "./LayerSheet";
import { SectionSheet } from "./SectionSheet";

/** A button for an action, with its keys in the tooltip. */
function ActionButton({ id, icon, isOn }: { id: string; icon: IconName; isOn?: boolean }) {
  const known = action(id);
  if (!known) return null;
  const label = t(known.label);
  const keys = known.keys?.[0];
  return (
    <button
      type="button"
      aria-label={label}
      title={keys ? `${label} (${shownKeys(keys)})` : label}
      aria-pressed={isOn}
      onClick={() => void known.run()}
    >
      <Icon name={icon} />
    </button>
  );
}

const SHOWN: readonly (keyof Shown)[] = ["grid", "edges", "isocurves", "points", "controlPoints", "texts"];

export function Toolbar() {
  const mode = useStore(settingsStore, (settings) => settings.mode);
  const layout = useStore(settingsStore, (settings) => settings.layout);
  const view = useStore(viewportStore, (state) => state.view);
  const projection = useStore(viewportStore, (state) => state.projection);
  return (
    <div className="viewport-toolbar" role="toolbar" aria-label={t("viewport.toolbar")}>
      <select
        aria-label={t("viewport.view")}
        title={t("viewport.view")}
        value={view ?? ""}
        onChange={({ target }) => void action(`viewport.view.${target.value as ViewName}`)?.run()}
      >
        {!view && <option value="">{t("viewport.viewFree")}</option>}
        {VIEW_NAMES.map((name) => (
          <option key={name} value={name}>
            {t(`viewport.view.${name}` as Key)}
          </option>
        ))}
      </select>
      <ActionButton id="viewport.parallel" icon="parallel" isOn={projection === "parallel"} />
      <ActionButton id="viewport.four" icon="four" isOn={layout === "four"} />
      <span className="viewport-gap" />
      <DisplaySheet />
      <ActionButton id="viewport.mode.rendered" icon="rendered" isOn={mode === "rendered"} />
      <span className="viewport-gap" />
      <ActionButton id="viewport.zoomExtents" icon="extents" />
      <ActionButton id="viewport.zoomSelected" icon="selected" />
      <span className="viewport-gap" />
      <ShowSheet />
      <LayerSheet />
      <AnalysisSheet />
      <SectionSheet />
      <CameraSheet />
      <ActionButton id="viewport.save" icon="save" />
    </div>
  );
}

function ShowSheet() {
  const { shown, previews, trackpad, snap, gumball } = useStore(settingsStore);
  return (
    <Popover label={t("viewport.show")} icon="show">
      {SHOWN.map((name) => (
        <Check
          key={name}
          label={`viewport.show.${name}`}
          checked={shown[name]}
          onChange={(on) => settingsStore.setState({ shown: { ...shown, [name]: on } })}
        />
      ))}
      <hr />
      <div role="group" aria-label={t("viewport.previews")}>
        {PREVIEWS.map((name) => (
          <label key={name} className="viewport-check">
            <input type="radio" name="previews" checked={previews === name} onChange={() => settingsStore.setState({ previews: name })} />
            {t(`viewport.previews.${name}`)}
          </label>
        ))}
      </div>
      <hr />
      <Check label="viewport.snap" checked={snap} onChange={(on) => settingsStore.setState({ snap: on })} />
      <Check label="viewport.gumball" checked={gumball} onChange={(on) => settingsStore.setState({ gumball: on })} />
      <Check label="viewport.trackpad" checked={trackpad} onChange={(on) => settingsStore.setState({ trackpad: on })} />
    </Popover>
  );
}
