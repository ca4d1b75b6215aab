import { t } from "../i18n";
import { Dialog } from "./Dialog";

/** What this is, and that nothing leaves the machine. */
export function About() {
  return (
    <Dialog title={t("about.title")}>
      <p>{t("about.what")}</p>
      <p>{t("about.privacy")}</p>
      <p>{t("about.licence")}</p>
    </Dialog>
  );
}
