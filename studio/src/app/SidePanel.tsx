import { t } from "../i18n";
import { Data } from "../panels/Data";
import { Effects } from "../panels/Effects";
import { Outline } from "../panels/Outline";
import { Problems } from "../panels/Problems";
import { settingsStore, type SidePanel as Name } from "./settings";

const PANELS = { outline: Outline, problems: Problems, data: Data, effects: Effects };

/** The panel beside the two great panes. */
export function SidePanel({ name }: { name: Name }) {
  const Content = PANELS[name];
  return (
    <aside className="side" aria-label={t(`side.${name}`)}>
      <header>
        <h2>{t(`side.${name}`)}</h2>
        <button type="button" aria-label={t("side.close")} onClick={() => settingsStore.setState({ side: undefined })}>
          ✕
        </button>
      </header>
      {/* What scrolls can be reached by Tab, so that the arrow keys scroll it. */}
      <div className="content" tabIndex={0} role="region" aria-label={t(`side.${name}`)}>
        <Content />
      </div>
    </aside>
  );
}
