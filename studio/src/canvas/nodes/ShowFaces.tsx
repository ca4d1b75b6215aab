import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { useOutput } from "../hooks";
import { useRows } from "../rows";

/** An Image Sampler: the picture that it reads. */
export function ImageFace({ object, file, hash }: { object: ObjectView; file: string; hash: string | null }) {
  const name = file.split(/[\\/]/).at(-1) ?? file;
  return hash ? (
    <img className="picture" src={`image/${hash}`} alt={name} draggable={false} />
  ) : (
    <span className="no-picture">{name === "" ? t("canvas.image.none", { name: object.name }) : name}</span>
  );
}

/** A Param Viewer: the tree as a picture of branches, or its paths as a list. */
export function ViewerFace({ object, text, size }: { object: ObjectView; text: boolean; size: readonly [number, number] }) {
  const port = object.outputs[0]?.id ?? object.id;
  const output = useOutput(port);
  const rows = useRows(object.inputs[0]?.id ?? port, 0, text ? 60 : 0, output);
  if (!output || output.items === 0) return <span className="no-picture">{t("canvas.empty")}</span>;
  if (!text) return <Tree branches={output.branches} items={output.items} size={size} />;
  const paths = rows?.rows.filter((row) => row.is === "path") ?? [];
  return (
    <div className="paths nowheel" data-scrolls>
      <p>{t("canvas.data.count", { items: output.items, branches: output.branches })}</p>
      {paths.map((row, k) => (
        <p key={k}>
          <span>{row.path}</span> <span>N = {row.items}</span>
        </p>
      ))}
    </div>
  );
}

const MOST_DRAWN = 48;

/** Branches about a trunk: as many as there are, as far as they can be told apart. */
function Tree({ branches, items, size: [width, height] }: { branches: number; items: number; size: readonly [number, number] }) {
  const radius = Math.max(Math.min(width, height) / 2 - 10, 4);
  const count = Math.min(branches, MOST_DRAWN);
  const lines = Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * k) / count - Math.PI / 2;
    return [Math.cos(angle) * radius, Math.sin(angle) * radius] as const;
  });
  return (
    <svg className="tree" width={width} height={height} viewBox={`${-width / 2} ${-height / 2} ${width} ${height}`}>
      <title>{t("canvas.data.count", { items, branches })}</title>
      {lines.map(([x, y], k) => (
        <g key={k}>
          <line x1={0} y1={0} x2={x} y2={y} />
          <circle cx={x} cy={y} r={Math.max(1.5, 4 - count / 16)} />
        </g>
      ))}
      <circle className="trunk" r={4} />
    </svg>
  );
}
