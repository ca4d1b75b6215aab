import { useState } from "react";

import { MODEL_FORMATS, exportAs, exportCanvas, place, type ExportFormat } from "../app";
import { selectedMembers } from "../canvas/edits";
import { t, type Key } from "../i18n";
import { Dialog } from "./Dialog";

/** A picture shows what the viewport does. */
const isPicture = (format: ExportFormat) => format === "png" || format === "svg";

/** What the definition makes, as a file of another program. */
export function Export() {
  const [state, setState] = useState<{ busy?: string; wrong?: string }>({});
  const id = place(location.search).document;
  const chosen = selectedMembers();
  const [isPart, setIsPart] = useState(false);
  const run = async (format: ExportFormat, make = exportAs) => {
    if (!id) return;
    setState({ busy: format });
    try {
      await make(id, format);
      setState({});
    } catch (error) {
      setState({ wrong: error instanceof Error ? error.message : String(error) });
    }
  };
  return (
    <Dialog title={t("export.title")}>
      <table>
        <tbody>
          {MODEL_FORMATS.map((format) => (
            <tr key={format}>
              <th scope="row">
                  <button
                  type="button"
                  disabled={state.busy !== undefined}
                  onClick={() => void run(format, (document, as) => exportAs(document, as, isPart && !isPicture(format) ? chosen : []))}
                >
                  .{format}
                </button>
              </th>
              <td>{t(`export.${format}` as Key)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {chosen.length > 0 && (
        <label>
          <input type="checkbox" checked={isPart} onChange={(event) => setIsPart(event.target.checked)} /> {t("export.selected")}
        </label>
      )}
      <h3>{t("export.canvas")}</h3>
      <div className="row">
        {(["svg", "png"] as const).map((format) => (
          <button
            key={format}
            type="button"
            disabled={state.busy !== undefined}
            onClick={() => void run(format, (document) => exportCanvas(document, format))}
          >
            {t(`export.canvas.${format}`)}
          </button>
        ))}
      </div>
      <p role="status">{state.busy && t("export.busy")}</p>
      {state.wrong && <p role="alert">{state.wrong}</p>}
    </Dialog>
  );
}
