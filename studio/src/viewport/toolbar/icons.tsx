/** The pictures on the viewport's buttons, drawn with lines in the colour of their text. */

const PATHS = {
  wireframe: "M3 6l7-3 7 3v8l-7 3-7-3zM3 6l7 3 7-3M10 9v8",
  shaded: "M3 6l7-3 7 3v8l-7 3-7-3z M3 6l7 3v8l-7-3z",
  ghosted: "M3 6l7-3 7 3v8l-7 3-7-3zM3 6l7 3 7-3M10 9v8M10 3v7M10 10l-7 4M10 10l7 4",
  rendered: "M10 3a7 7 0 1 0 0 14a7 7 0 0 0 0-14zM7 7a3 3 0 0 1 3-2",
  technical: "M4 16L14 6l2-3 1 1-3 2L4 16zM4 16l2-1M9 16h8",
  extents: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M8 8h4v4H8z",
  selected: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7 10l2 2 4-4",
  four: "M3 3h6v6H3zM11 3h6v6h-6zM3 11h6v6H3zM11 11h6v6h-6z",
  parallel: "M4 7l6-3v9l-6 3zM10 4l6 3v9l-6-3",
  show: "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM10 8a2 2 0 1 0 0 4a2 2 0 0 0 0-4z",
  analysis: "M3 16c3-1 4-11 7-11s3 8 7 9M3 16h14M6 12v4M10 5v11M14 13v3",
  section: "M4 6l6-3 6 3v8l-6 3-6-3zM7 2l7 15",
  layers: "M10 3l7 4-7 4-7-4zM3 10.5l7 4 7-4M3 14l7 4 7-4",
  camera: "M3 7h8v7H3zM11 9l6-3v9l-6-3M5 4.5a1.5 1.5 0 1 0 3 0",
  save: "M4 5h3l1-2h4l1 2h3v11H4zM10 8a3 3 0 1 0 0 6a3 3 0 0 0 0-6z",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg className="viewport-icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
