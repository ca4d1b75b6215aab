/** Where the view is cut. */

import { useStore } from "zustand";

import type { Point3 } from "../../core/preview";
import { t, type Key } from "../../i18n";
import { currentViewport } from "../current";
import { settingsStore, type Section } from "../settings";
import { Check } from "./fields";
import { Popover } from "./Popover";

const AXES: Record<"x" | "y" | "z", Point3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

function change(section: Partial<Section>): void {
  settingsStore.setState((now) => ({ section: { ...now.section, ...section } }));
}

/** Along an axis, and so that what is nearer to the eye is taken away. */
function towardsEye([x, y, z]: Point3): Point3 {
  const backward = currentViewport()?.panes.active.rig.backward();
  const isAway = backward !== undefined && x * backward.x + y * backward.y + z * backward.z < 0;
  return isAway ? [0 - x, 0 - y, 0 - z] : [x, y, z];
}

export function SectionSheet() {
  const { isOn, normal, at } = useStore(settingsStore, (settings) => settings.section);
  const isAlong = (axis: Point3) => Math.abs(axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2]) > 1 - 1e-9;
  const facing = () => {
    const backward = currentViewport()?.panes.active.rig.backward();
    if (backward) change({ isOn: true, normal: [backward.x, backward.y, backward.z], at: undefined });
  };
  return (
    <Popover label={t("viewport.section")} icon="section">
      <Check label="viewport.section.on" checked={isOn} onChange={(on) => change(on && at === undefined ? { isOn: on, normal: towardsEye(normal) } : { isOn: on })} />
      <fieldset>
        <legend>{t("viewport.section.across")}</legend>
        {Object.entries(AXES).map(([name, axis]) => (
          <label className="viewport-check" key={name}>
            <input
              type="radio"
              name="viewport-section"
              checked={isAlong(axis)}
              onChange={() => change({ isOn: true, normal: towardsEye(axis), at: undefined })}
            />
            {t(`viewport.section.${name}` as Key)}
          </label>
        ))}
        <button type="button" onClick={facing}>
          {t("viewport.section.view")}
        </button>
      </fieldset>
      <button
        type="button"
        disabled={!isOn}
        onClick={() => change({ normal: [0 - normal[0], 0 - normal[1], 0 - normal[2]], at: at === undefined ? undefined : -at })}
      >
        {t("viewport.section.flip")}
      </button>
      <button type="button" disabled={!isOn || at === undefined} onClick={() => change({ at: undefined })}>
        {t("viewport.section.middle")}
      </button>
    </Popover>
  );
}
