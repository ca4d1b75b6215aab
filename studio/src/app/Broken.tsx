import { t } from "../i18n";

/** Stands in the place of a page that cannot be drawn. The document is the server's, so nothing of it is lost. */
export function Broken() {
  return (
    <main className="broken" role="alert">
      <h1>{t("broken.title")}</h1>
      <p>{t("broken.what")}</p>
      <button type="button" onClick={() => location.reload()}>
        {t("broken.again")}
      </button>
    </main>
  );
}
