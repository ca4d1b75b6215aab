/** A box and a ball as a display mode draws them. */

import { useId } from "react";

import type { DisplayMode } from "../scene/looks";

/** The faces of the box that are seen, from the lightest to the darkest. */
const FACES = ["M8 16l14-6 14 6-14 6z", "M8 16l14 6v16l-14-6z", "M22 22l14-6v16l-14 6z"] as const;
const EDGES = "M8 16l14-6 14 6-14 6zM8 16v16l14 6 14-6V16M22 22v16";
const HIDDEN = "M22 10v16M8 32l14-6 14 6";
const BALL = { cx: 55, cy: 29, r: 11 } as const;
/** Lines on the ball. */
const RINGS = "M44 29a11 4 0 0 0 22 0a11 4 0 0 0-22 0M55 18a4 11 0 0 0 0 22a4 11 0 0 0 0-22";

export function DisplayPicture({ mode }: { mode: DisplayMode }) {
  const id = useId();
  const hasFaces = mode !== "wireframe";
  return (
    <svg className={`display-picture is-${mode}`} viewBox="0 0 72 48" aria-hidden="true">
      {mode === "rendered" && (
        <>
          <radialGradient id={id} cx="0.38" cy="0.3" r="0.75">
            <stop offset="0" className="display-light" />
            <stop offset="1" className="display-dark" />
          </radialGradient>
          <path className="display-ground" d="M22 38l14-6 14 5-14 6z" />
          <ellipse className="display-ground" cx="61" cy="39.5" rx="10" ry="3" />
        </>
      )}
      {hasFaces && FACES.map((face, at) => <path key={face} className={`display-face is-${at}`} d={face} />)}
      {hasFaces && <circle {...BALL} className="display-face is-ball" {...(mode === "rendered" && { style: { fill: `url(#${CSS.escape(id)})` } })} />}
      {(mode === "wireframe" || mode === "ghosted" || mode === "technical") && <path className="display-hidden" d={HIDDEN} />}
      {mode !== "rendered" && <path className="display-line" d={EDGES} />}
      {mode !== "rendered" && <circle {...BALL} className="display-line" />}
      {(mode === "wireframe" || mode === "ghosted") && <path className="display-hidden" d={RINGS} />}
    </svg>
  );
}
