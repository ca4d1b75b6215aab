/** The page's colours as a sheet of pixels needs them: worked out by the browser, since tokens may depend on the theme. */

import type { Look } from "../core/look";
import type { Inks } from "../icons/sprite";

export interface FarColours {
  edge: string;
  ink: string;
  icon: Inks;
  /** Of icons on the red of an error. */
  iconOnError: Inks;
  wire: Record<"plain" | "empty" | "selected", string>;
  ground: string;
  look: Record<Look, string>;
  selected: Record<Look, string>;
  panelInk: string;
  errorInk: string;
  disabledInk: string;
  band: string;
  bandInk: string;
}

const LOOKS: readonly Look[] = ["plain", "hidden", "disabled", "unsupported", "empty", "warning", "error"];

/** The token that fills a look. */
function token(look: Look, selected: boolean): string {
  const base = look === "empty" ? "warning" : look === "unsupported" && selected ? "disabled" : look;
  return `--canvas-${base}${selected ? "-selected" : ""}`;
}

export function farColours(beside: HTMLElement): FarColours {
  const probe = document.createElement("span");
  probe.hidden = true;
  beside.after(probe);
  const read = (name: string) => {
    probe.style.color = `var(${name})`;
    return getComputedStyle(probe).color;
  };
  const looks = (selected: boolean) =>
    Object.fromEntries(LOOKS.map((look) => [look, read(token(look, selected))])) as Record<Look, string>;
  const colours: FarColours = {
    edge: read("--canvas-edge"),
    ink: read("--canvas-ink"),
    icon: { ink: read("--canvas-ink"), accent: read("--icon-accent") },
    iconOnError: { ink: read("--canvas-error-ink"), accent: read("--canvas-error-ink") },
    wire: {
      plain: read("--canvas-wire"),
      empty: read("--canvas-wire-empty"),
      selected: read("--canvas-wire-selected"),
    },
    ground: read("--canvas-ground"),
    look: looks(false),
    selected: looks(true),
    panelInk: read("--canvas-panel-ink"),
    errorInk: read("--canvas-error-ink"),
    disabledInk: read("--canvas-disabled-ink"),
    band: read("--canvas-band"),
    bandInk: read("--canvas-band-ink"),
  };
  probe.remove();
  return colours;
}
