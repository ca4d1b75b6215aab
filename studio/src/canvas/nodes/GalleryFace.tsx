import { useEffect, useState } from "react";

import { css } from "../../core/colours";
import { told } from "../../core/charts";
import { gridFor } from "../../core/gallery";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { OutputView } from "../../core/protocol/OutputView";
import type { PictureView } from "../../core/protocol/PictureView";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { ask } from "../../state/session";
import { useOutput } from "../hooks";

const EDGE = 6;

/** The small pictures of a port's data, asked for anew when its result changes; none where there is no data. */
function usePictures(port: string, output: OutputView | undefined): readonly PictureView[] | undefined {
  const [pictures, setPictures] = useState<readonly PictureView[] | undefined>(undefined);
  useEffect(() => {
    if (!output || output.items === 0) {
      setPictures(undefined);
      return undefined;
    }
    let here = true;
    ask({ ask: "pictures", port, within: documentStore.getState().within }).then(
      (answer) => {
        if (here && answer.event === "pictures") setPictures(answer.pictures);
      },
      () => undefined,
    );
    return () => {
      here = false;
    };
  }, [port, output]);
  return pictures;
}

/** An Image Gallery: a frame for each picture, colour or name. */
export function GalleryFace({ object, size }: { object: ObjectView; size: readonly [number, number] }) {
  const port = object.outputs[0]?.id ?? object.id;
  const output = useOutput(port);
  const pictures = usePictures(port, output);
  if (!pictures || pictures.length === 0) return <span className="no-picture">{t("canvas.empty")}</span>;
  const [columns, rows] = gridFor(pictures.length, [size[0] - 2 * EDGE, size[1] - 2 * EDGE]);
  const name = object.nickname.trim() || object.name;
  const label = t("canvas.chart", { name, values: told(pictures.map((picture) => picture.name)) });
  const style = { inset: EDGE, gridTemplateColumns: `repeat(${columns}, 1fr)`, gridTemplateRows: `repeat(${rows}, 1fr)` };
  return (
    <div className="gallery" style={style} role="group" aria-label={label}>
      {pictures.map((picture, k) => (
        <Picture key={k} {...picture} />
      ))}
    </div>
  );
}

function Picture({ name, image, colour }: PictureView) {
  if (image !== null) return <img src={image} alt={name} title={name} draggable={false} />;
  if (colour !== null) return <span role="img" aria-label={name} title={name} style={{ background: css(colour) }} />;
  return <span title={name}>{name}</span>;
}
