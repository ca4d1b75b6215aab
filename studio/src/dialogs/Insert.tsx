import { useStore } from "zustand";

import { take } from "../app/DropZone";
import { goTo, upload } from "../app/files";
import { insert, insertStore, type Inserting } from "../app/insert";
import { t } from "../i18n";
import { lineStore } from "../state/session";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

const WAYS: readonly Inserting[] = ["loose", "group", "cluster"];

/** What shall become of a definition that was let go on the page: a document of its own, or part of this one. */
export function Insert() {
  const { file, at } = useStore(insertStore);
  if (!file) return null;
  const open = () => {
    showDialog(undefined);
    void take([file]);
  };
  const examine = () => {
    showDialog(undefined);
    upload(file, undefined, true).then(goTo, (error: unknown) => lineStore.setState({ complaint: String(error) }));
  };
  const put = (how: Inserting) => {
    showDialog(undefined);
    void insert(file, at, how);
  };
  return (
    <Dialog title={file.name}>
      <div className="ways">
        <button type="button" className="primary" autoFocus onClick={open}>
          <strong>{t("insert.open")}</strong>
          <span>{t("insert.open.what")}</span>
        </button>
        <button type="button" onClick={examine}>
          <strong>{t("insert.examine")}</strong>
          <span>{t("insert.examine.what")}</span>
        </button>
        {WAYS.map((how) => (
          <button key={how} type="button" onClick={() => put(how)}>
            <strong>{t(`insert.${how}`)}</strong>
            <span>{t(`insert.${how}.what`)}</span>
          </button>
        ))}
      </div>
      <p>
        <small>{t("insert.hint")}</small>
      </p>
    </Dialog>
  );
}
