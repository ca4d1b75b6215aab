/** The pictures of the canvas's commands, drawn with lines in the colour of their text. */

const PATHS = {
  search: "M8.5 3a5.5 5.5 0 1 0 0 11a5.5 5.5 0 0 0 0-11zM12.5 12.5L17 17",
  find: "M3 4h9M3 8h6M3 12h4M12 9a3.5 3.5 0 1 0 0 7a3.5 3.5 0 0 0 0-7zM14.5 15L17 17.5",
  extents: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M8 8h4v4H8z",
  selected: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7 10l2 2 4-4",
  recompute: "M16 10a6 6 0 1 1-2-4.5M16 3v3.5h-3.5",
  lock: "M5 9h10v8H5zM7 9V6.5a3 3 0 0 1 6 0V9M10 12v2",
  paste: "M5 4h10v13H5zM8 2.5h4v3H8zM8 9h4M8 12h4",
  undo: "M4 8h8a4 4 0 0 1 0 8H8M4 8l4-4M4 8l4 4",
  redo: "M16 8H8a4 4 0 0 0 0 8h4M16 8l-4-4M16 8l-4 4",
  preview: "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM10 8a2 2 0 1 0 0 4a2 2 0 0 0 0-4z",
  enabled: "M10 3v7M6 5.5a6 6 0 1 0 8 0",
  group: "M3 3h14v14H3zM6 6h4v3H6zM11 11h4v3h-4z",
  cluster: "M3 6h11v11H3zM6 6V3h11v11h-3M6 10h5M6 13h5",
  duplicate: "M3 3h9v9H3zM8 12v5h9V8h-5",
  remove: "M4 6h12M8 6V3.5h4V6M6 6l.8 11h6.4L14 6M8.5 9v5M11.5 9v5",
  bake: "M10 3c3 3 5 5 5 8a5 5 0 0 1-10 0c0-2 1-3 2-4c0 2 1 2.5 2 2.5c1-2 0-4 1-6.5z",
  help: "M10 2.5a7.5 7.5 0 1 0 0 15a7.5 7.5 0 0 0 0-15zM7.5 8a2.5 2.5 0 1 1 3.5 2.300c-.7.4-1 .8-1 1.700M10 14.5v.1",
  views: "M6 3h8v14l-4-3.5L6 17z",
  left: "M3 3v14M6 5h11v3.5H6zM6 11.5h6V15H6z",
  centre: "M10 3v14M4 5h12v3.5H4zM6.5 11.5h7V15h-7z",
  right: "M17 3v14M3 5h11v3.5H3zM8 11.5h6V15H8z",
  top: "M3 3h14M5 6h3.5v11H5zM11.5 6H15v6h-3.5z",
  middle: "M3 10h14M5 4h3.5v12H5zM11.5 6.5H15v7h-3.5z",
  bottom: "M3 17h14M5 3h3.5v11H5zM11.5 8H15v6h-3.5z",
  spreadAcross: "M3 3v14M17 3v14M7.5 5h5v10h-5z",
  spreadDown: "M3 3h14M3 17h14M5 7.5h10v5H5z",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 20 }: { name: IconName; size?: number }) {
  return (
    <svg className="canvas-icon" viewBox="0 0 20 20" width={size} height={size} aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}

/** A picture inside another drawing, its middle at a point. */
export function IconAt({ name, at: [x, y] }: { name: IconName; at: readonly [number, number] }) {
  return <path className="canvas-icon" d={PATHS[name]} transform={`translate(${x - 10} ${y - 10})`} />;
}
