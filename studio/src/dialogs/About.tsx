// The licence of the typeface goes where the typeface goes.
import typeface from "@fontsource-variable/inter/LICENSE?url";

import { t } from "../i18n";
import { Dialog } from "./Dialog";

/** What this is, and that nothing leaves the machine. */
export function About() {
  return (
    <Dialog title={t("about.title")}>
      <p>{t("about.what")}</p>
      <p>{t("about.privacy")}</p>
      <p>{t("about.licence")}</p>
      <p>{t("about.parts")}</p>
      <p>
        <a href={typeface} target="_blank" rel="noreferrer">
          {t("about.typeface")}
        </a>
      </p>
    </Dialog>
  );
}
