import { engine } from "#engine";
import { useEffect, useState } from "react";

import { pathNumbers, treePicture } from "../../core/treePicture";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { useOutput } from "../hooks";
import { usePaths, type PathRow } from "../paths";

/** Where the page finds a picture of the document; nothing until it is there. */
function usePicture(hash: string | null): string | undefined {
  const [found, setFound] = useState<string>();
  useEffect(() => {
    if (!engine || hash === null) return;
    let made: string | undefined;
    let isHere = true;
    const take = (address: string) => {
      made = address;
      if (isHere) setFound(address);
      else URL.revokeObjectURL(address);
    };
    // One that is gone is not shown.
    engine.picture(hash).then(take, () => undefined);
    return () => {
      isHere = false;
      if (made !== undefined) URL.revokeObjectURL(made);
      setFound(undefined);
    };
  }, [hash]);
  return engine ? found : `image/${hash}`;
}

/** An Image Sampler: the picture that it reads. */
export function ImageFace({ object, file, hash }: { object: ObjectView; file: string; hash: string | null }) {
  const name = file.split(/[\\/]/).at(-1) ?? file;
  const picture = usePicture(hash);
  return hash ? (
    <img className="picture" src={picture} alt={name} draggable={false} />
  ) : (
    <span className="no-picture">{name === "" ? t("canvas.image.none", { name: object.name }) : name}</span>
  );
}

/** What is set on a Cherry Picker or Path Mapper, below its name. */
export function LinesFace({ object, lines }: { object: ObjectView; lines: readonly string[] }) {
  return (
    <div className="lines-face">
      <strong>{object.nickname.trim() || object.name}</strong>
      {lines.map((line, k) => (
        <span key={k}>{line}</span>
      ))}
    </div>
  );
}

/** As many branches as a picture can show and a list need hold. */
const MOST_PATHS = 120;

/** A Param Viewer: the tree as a picture of branches, or its paths as a list. */
export function ViewerFace({ object, text, size }: { object: ObjectView; text: boolean; size: readonly [number, number] }) {
  const port = object.outputs[0]?.id ?? object.id;
  const output = useOutput(port);
  const paths = usePaths(object.inputs[0]?.id ?? port, MOST_PATHS, output);
  if (!output || output.items === 0) return <span className="no-picture">{t("canvas.empty")}</span>;
  // What a viewer gives is the paths of what it shows: an item for each branch.
  const branches = output.items;
  const items = (paths ?? []).reduce((sum, path) => sum + path.items, 0);
  const count = t("canvas.data.count", { items, branches });
  if (!text) return <Tree title={count} paths={paths ?? []} size={size} />;
  return (
    <div className="paths nowheel" data-scrolls>
      <p>{count}</p>
      {(paths ?? []).map(({ path, items }, k) => (
        <p key={k}>
          <span>{path}</span> <span>N = {items}</span>
        </p>
      ))}
      {paths && branches > paths.length ? <p>{t("canvas.data.more", { count: branches - paths.length })}</p> : null}
    </div>
  );
}

function Tree({ title, paths, size: [width, height] }: { title: string; paths: readonly PathRow[]; size: readonly [number, number] }) {
  const radius = Math.max(Math.min(width, height) / 2 - 10, 4);
  const { twigs, leaves } = treePicture(paths.map(({ path }) => pathNumbers(path)), radius);
  const dot = Math.max(1.2, 4 - leaves.length / 16);
  return (
    <svg className="tree" width={width} height={height} viewBox={`${-width / 2} ${-height / 2} ${width} ${height}`}>
      <title>{title}</title>
      {twigs.map(({ from, to }, k) => (
        <line key={k} x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      ))}
      {leaves.map(([x, y], k) => (
        <circle key={k} cx={x} cy={y} r={dot} />
      ))}
    </svg>
  );
}
