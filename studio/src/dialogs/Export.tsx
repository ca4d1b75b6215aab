import { useState } from "react";

import { exportAs, exportCanvas, place, type ExportFormat } from "../app";
import { t, type Key } from "../i18n";
import { Dialog } from "./Dialog";

const FORMATS: ExportFormat[] = ["3dm", "step", "glb", "obj", "stl", "svg", "png"];

/** What the definition makes, as a file of another program. */
export function Export() {
  const [state, setState] = useState<{ busy?: string; wrong?: string }>({});
  const id = place(location.search).document;
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
          {FORMATS.map((format) => (
            <tr key={format}>
              <th scope="row">
                <button type="button" disabled={state.busy !== undefined} onClick={() => void run(format)}>
                  .{format}
                </button>
              </th>
              <td>{t(`export.${format}` as Key)}</td>
            </tr>
          ))}
        </tbody>
      </table>
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
