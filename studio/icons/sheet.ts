/** The sheet of all icons: a page, and a picture for each tab, with the names below. */

import { tabRank } from "../src/core/catalogue";
import { pictureOf } from "../src/icons";
import { listed, type Listed } from "./components";

const CELL = [92, 64] as const;
const ACROSS = 10;
const MARGIN = 12;
const HEADING = 28;
/** Icons are drawn larger than on the page. */
const SCALE = 1.5;

/** Light or dark as the reader has it. The tones are those of src/icons/icons.css. */
const STYLE = `
svg { color: #18191d; background: #fff; --accent: #0f5fc4; }
@media (prefers-color-scheme: dark) { svg { color: #ececf0; background: #1d1e22; --accent: #7db8ff; } }
text { fill: currentColor; font: 9px system-ui, sans-serif; text-anchor: middle; }
.panel { font-size: 13px; font-weight: 600; text-anchor: start; }
path { fill: none; stroke-width: 1.5; stroke-linecap: round; stroke-linejoin: round; }
.ink, .faint, .dash { stroke: currentColor; } .hot { stroke: var(--accent); }
.faint { stroke-opacity: 0.5; } .dash { stroke-dasharray: 1.5 2.5; }
.fill, .shade { fill: currentColor; } .hotFill, .tint { fill: var(--accent); }
.shade { fill-opacity: 0.16; } .tint { fill-opacity: 0.35; }
`;

/** Files by name, in the folder of documents. */
export function sheet(): Map<string, string> {
  const tabs = grouped(listed().filter(({ old }) => !old), ({ tab }) => tab);
  const names = [...tabs.keys()].sort((a, b) => tabRank(a) - tabRank(b) || a.localeCompare(b));
  const files = new Map(names.map((name) => [`icons/${name.toLowerCase()}.svg`, ofTab(tabs.get(name) ?? [])]));
  const sections = names.map((name) => `## ${name}\n\n![The icons of ${name}](icons/${name.toLowerCase()}.svg)\n`);
  files.set("icons.md", `# Icons\n\n${INTRODUCTION}\n\n${sections.join("\n")}`);
  return files;
}

const INTRODUCTION = `Every component has an icon of its own, drawn for Katydid. Black is what a component works on, blue what it adds or what
comes of it, grey what was there before. Components of earlier versions have the icon of the new one with a folded corner.
The drawings are code, in \`studio/src/icons\`; \`npm run icons\` in \`studio/\` writes this page from them.`;

function grouped<T>(all: readonly T[], by: (one: T) => string): Map<string, T[]> {
  const groups = new Map<string, T[]>();
  for (const one of all) groups.set(by(one), [...(groups.get(by(one)) ?? []), one]);
  return groups;
}

function ofTab(all: readonly Listed[]): string {
  const panels = [...grouped(all, ({ panel }) => panel)].sort(([a], [b]) => a.localeCompare(b));
  let y = MARGIN;
  const drawn = panels.map(([panel, entries]) => {
    const heading = `<text class="panel" x="${MARGIN}" y="${y + 14}">${escaped(panel)}</text>`;
    const top = y + HEADING;
    const cells = entries.map((entry, k) => cell(entry, MARGIN + (k % ACROSS) * CELL[0], top + Math.floor(k / ACROSS) * CELL[1]));
    y = top + Math.ceil(entries.length / ACROSS) * CELL[1] + MARGIN;
    return [heading, ...cells].join("\n");
  });
  const width = 2 * MARGIN + ACROSS * CELL[0];
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${y}" viewBox="0 0 ${width} ${y}">
<style>${STYLE}</style>
${drawn.join("\n")}
</svg>
`;
}

function cell(entry: Listed, x: number, y: number): string {
  const paths = pictureOf(entry.id, entry.name, entry).map(([tone, path]) => `<path class="${tone}" d="${path}"/>`);
  const middle = x + CELL[0] / 2;
  const lines = wrapped(entry.name).map((line, k) => `<text x="${middle}" y="${y + 46 + k * 10}">${escaped(line)}</text>`);
  return `<g transform="translate(${middle - 12 * SCALE} ${y}) scale(${SCALE})">${paths.join("")}</g>${lines.join("")}`;
}

/** A name on two lines at most. */
function wrapped(name: string): string[] {
  const words = name.split(" ");
  const first: string[] = [];
  while (words.length > 0 && [...first, words[0]].join(" ").length <= 18) first.push(words.shift() ?? "");
  return first.length === 0 ? [name] : [first.join(" "), words.join(" ")].filter(Boolean);
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}
