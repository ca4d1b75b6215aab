/** The layers of the Rhino model beside the definition: each can be shown and hidden. */

import { useStore } from "zustand";

import { action } from "../../actions/registry";
import type { ModelLayerView } from "../../core/protocol/ModelLayerView";
import { t } from "../../i18n";
import { isLayerOn, modelStore, turnLayers } from "../../state/model";
import { Check } from "./fields";
import { Popover } from "./Popover";
import "./sheets.css";

export function LayerSheet() {
  const store = useStore(modelStore);
  const { model, isOn } = store;
  return (
    <Popover label={t("viewport.layers")} icon="layers">
      {model ? (
        <>
          <strong className="viewport-model">{model.name}</strong>
          <Check label="viewport.layers.on" checked={isOn} onChange={(on) => modelStore.setState({ isOn: on })} />
          <ul className="viewport-layers" aria-label={t("viewport.layers.each")}>
            {model.layers.map((layer) => (
              <Layer key={layer.id} layer={layer} isOn={isLayerOn(store, layer)} isOff={!isOn} />
            ))}
          </ul>
          {model.leftOut.map((text) => (
            <small key={text}>{text}</small>
          ))}
        </>
      ) : (
        <p>{t("viewport.layers.none")}</p>
      )}
      <button type="button" onClick={() => void action("file.model")?.run()}>
        {t(model ? "viewport.layers.other" : "action.model")}
      </button>
      {model && (
        <button type="button" onClick={() => void action("file.detach")?.run()}>
          {t("action.detach")}
        </button>
      )}
    </Popover>
  );
}

function Layer({ layer, isOn, isOff }: { layer: ModelLayerView; isOn: boolean; isOff: boolean }) {
  const names = layer.path.split("::");
  const [red, green, blue] = layer.colour;
  return (
    <li style={{ paddingLeft: `${(names.length - 1) * 12}px` }}>
      <label className="viewport-check" title={names.join(" › ")}>
        <input type="checkbox" checked={isOn} disabled={isOff} onChange={({ target }) => turnLayers([layer], target.checked)} />
        <span className="viewport-swatch" style={{ background: `rgb(${red}, ${green}, ${blue})` }} />
        <span className="viewport-layer">{names.at(-1) || t("viewport.layers.unnamed")}</span>
        <span className="viewport-count">{layer.objects.length}</span>
      </label>
    </li>
  );
}
