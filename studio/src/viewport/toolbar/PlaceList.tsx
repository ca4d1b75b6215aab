import { useStore } from "zustand";

import { shortNumber } from "../../core/falseColour";
import type { Probed } from "../../core/protocol/Probed";
import { unitSuffix } from "../../core/units";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { placesStore, unpin, type Place } from "../tools/probes";

/** The places that are looked at, in numbers: those that are pinned, and that under the pointer. */
export function PlaceList() {
  const { pinned, pointed } = useStore(placesStore);
  if (pinned.length === 0 && !pointed?.found) return null;
  return (
    <section className="viewport-note viewport-places" aria-label={t("viewport.places")}>
      <h2>{t("viewport.places")}</h2>
      {pinned.map((place, at) => (
        <PlaceRow key={at} place={place} isPinned />
      ))}
      {pointed?.found && <PlaceRow place={pointed} isPinned={false} />}
      <p>{t("viewport.places.help")}</p>
    </section>
  );
}

function PlaceRow({ place, isPinned }: { place: Place; isPinned: boolean }) {
  const units = useStore(documentStore, (mirror) => mirror.document?.units);
  const name = useStore(documentStore, (mirror) => {
    const object = mirror.objects.get(place.probe.object);
    return object ? object.nickname || object.name : "";
  });
  const remove = t("viewport.places.remove", { object: name });
  return (
    <div className="viewport-place">
      <div>
        <strong>{name}</strong>
        {isPinned && (
          <button type="button" aria-label={remove} title={remove} onClick={() => unpin(place)}>
            ×
          </button>
        )}
      </div>
      <dl>
        {place.found
          ? rowsOf(place.found, units).map(([label, value]) => (
              <div key={label}>
                <dt>{label}</dt>
                <dd>{value}</dd>
              </div>
            ))
          : t("viewport.places.none")}
      </dl>
    </div>
  );
}

/** What is said of a place. Exported for tests. */
export function rowsOf({ point, parameter, bend }: Probed, units: string | undefined): [string, string][] {
  const number = (value: number, power: 1 | -1 | -2) => shortNumber(value) + unitSuffix(units, power);
  const place: [string, string][] = [
    [t("viewport.place.point"), point.map((value) => String(Number(value.toPrecision(7)))).join(", ")],
    [bend.is === "curve" ? "t" : "u, v", parameter.map((value) => String(Number(value.toPrecision(7)))).join(", ")],
  ];
  if (bend.is === "curve") {
    return [
      ...place,
      [t("viewport.place.curvature"), number(bend.curvature, -1)],
      [t("viewport.place.radius"), bend.circle ? number(bend.circle.radius, 1) : "∞"],
    ];
  }
  const [greater, lesser] = bend.principal;
  return [
    ...place,
    [t("viewport.analysis.gaussian"), number(bend.gaussian, -2)],
    [t("viewport.analysis.mean"), number(bend.mean, -1)],
    ["k₁, k₂", `${shortNumber(greater)}, ${shortNumber(lesser)}${unitSuffix(units, -1)}`],
    [t("viewport.place.radii"), bend.circles.map((circle) => (circle ? shortNumber(circle.radius) : "∞")).join(", ") + unitSuffix(units, 1)],
  ];
}
