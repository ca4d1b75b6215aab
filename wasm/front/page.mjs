// The front page, made of the README's tables, of what was measured, and of figures that the book has built.
import { readFile } from "node:fs/promises";
import { join } from "node:path";

import { code, escaped, inline, rows, section } from "./text.mjs";

const own = (name) => readFile(new URL(name, import.meta.url), "utf8");
const project = (name) => own(`../../${name}`);

/** The figure that moves: a solid with a hole, which two sliders change. */
const FIGURE = ["N13", "drilled"];
/** Figures of the gallery: page, figure, what is seen. */
const GALLERY = [
  ["N11", "point", "A point of a surface, its normal and tangent plane"],
  ["C9", "construction", "De Casteljau: three rounds of dividing lines"],
  ["N5", "two", "Two knot vectors, two curves"],
  ["S1", "first", "Points of a circle, lifted one above the other"],
  ["M7", "six", "The six shears of a cube"],
];

/** The definition that README.md begins with. */
const EXAMPLE = `<a href="studio.html"><div class="stage"><img src="attractor.svg" alt="" loading="lazy"></div><span>Circles on a grid, larger the nearer they are to a point: examples/attractor.ghx</span></a>`;

/** A page of the book, with the ways in it made those of the site's root. */
async function bookPage(folder, page) {
  const html = await readFile(join(folder, "learn", page, "index.html"), "utf8");
  return html
    .replaceAll(/ (src|href)="(?![a-z]+:|#)([^"]+)"/g, (_, name, way) => ` ${name}="${resolved(page, way)}"`)
    .replaceAll(/"file":"([^"]+)"/g, (_, way) => `"file":"${resolved(page, way)}"`);
}

/** Where a way leads from a page of the book, seen from the root of the site. */
function resolved(page, way) {
  return new URL(way, `file:///learn/${page}/index.html`).pathname.slice(1) + (/[?#].*/.exec(way)?.[0] ?? "");
}

function figureOf(html, id) {
  const found = new RegExp(`<figure class="figure" id="${id}">[\\s\\S]*?</figure>`).exec(html);
  if (!found) throw new Error(`the book has no figure ${id}`);
  // Its numbers are those of the book's page and of the guide.
  return found[0].replace(/<b>[^<]*<\/b> /, "").replace(/ <small>[^<]*<\/small>(?=<\/figcaption>)/, "");
}

/** What the script of figures reads from a page: its words, and ways that begin at the site's root. */
function wordsOf(html) {
  const found = /<script type="application\/json" id="words">([\s\S]*?)<\/script>/.exec(html);
  // Where the script was not built, the pages have neither.
  if (!found) return "";
  const data = { ...JSON.parse(found[1]), root: "learn/", own: "learn/", page: "" };
  return `<script type="application/json" id="words">${JSON.stringify(data).replaceAll("<", "\\u003c")}</script>`;
}

function table(kind, head, body) {
  const cells = (tag, row) => row.map((cell) => `<${tag}${cell.attributes ?? ""}>${cell.html}</${tag}>`).join("");
  return `<div class="wide" tabindex="0" role="region" aria-label="${kind.label}"><table class="${kind.name}"><thead><tr>${cells("th", head)}</tr></thead>
<tbody>${body.map((row) => `<tr>${cells("td", row)}</tr>`).join("\n")}</tbody></table></div>`;
}

function works(readme) {
  const [head, ...body] = rows(section(readme, "What works, and what does not"));
  const titles = ["of what", ...head.slice(1)].map((html) => ({ html: html[0].toUpperCase() + html.slice(1), attributes: ' scope="col"' }));
  const attributes = (at) => (at ? ` data-head="${titles[at].html}"` : "");
  const cells = body.map((row) => row.map((cell, at) => ({ html: inline(cell), attributes: attributes(at) })));
  return table({ name: "works", label: "What works" }, titles, cells);
}

function measured(list) {
  const titles = ["Work", "Beside", "Ratio", "Measured"].map((html) => ({ html, attributes: ' scope="col"' }));
  const sorted = [...list].sort((a, b) => Number(b.ratio) - Number(a.ratio));
  const cells = sorted.map(({ what, peer, ratio, date }) => [
    { html: escaped(what) },
    { html: escaped(peer) },
    { html: `${Number(Number(ratio).toPrecision(2))}`, attributes: Number(ratio) > 1 ? ' class="number slower"' : ' class="number"' },
    { html: `<time>${date}</time>` },
  ]);
  return table({ name: "measured", label: "Beside other programs" }, titles, cells);
}

async function gallery(folder) {
  const tiles = GALLERY.map(async ([page, id, what]) => {
    const stage = /<div class="stage">[\s\S]*?<\/div>/.exec(figureOf(await bookPage(folder, page), id));
    if (!stage) throw new Error(`the figure ${id} of ${page} has no still`);
    // The words below say what it is.
    const still = stage[0].replaceAll(/ alt="[^"]*"/g, ' alt=""');
    return `<a href="learn/${page}/index.html#${id}">${still}<span>${escaped(what)}</span></a>`;
  });
  return [EXAMPLE, ...(await Promise.all(tiles))].join("\n");
}

/** The page and its sheet, by their names in the site. */
export async function frontPage(folder) {
  const [page, id] = FIGURE;
  const book = await bookPage(folder, page);
  const readme = await project("README.md");
  const style = /<link rel="stylesheet" href="([^"]+)"/.exec(book)?.[1];
  const script = /<script src="([^"]+)" type="module"><\/script>/.exec(book);
  if (!style) throw new Error("the book has no style sheet");
  const parts = {
    style,
    script: script?.[0] ?? "",
    figure: figureOf(book, id),
    command: escaped(code(section(readme, "First command"))),
    python: escaped(code(readme, "python")),
    works: works(readme),
    measured: measured(JSON.parse(await own("measured.json"))),
    gallery: await gallery(folder),
    words: wordsOf(book),
  };
  const html = (await own("template.html")).replaceAll(/\{\{(\w+)\}\}/g, (_, name) => {
    if (!(name in parts)) throw new Error(`template.html asks for ${name}`);
    return parts[name];
  });
  return { "index.html": html, "front.css": await own("front.css") };
}
