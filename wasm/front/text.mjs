// Markdown of our own documents as HTML: tables and what stands in their cells. Links lead to files that the site has not, and stay
// as words.

export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

export function inline(text) {
  return escaped(text)
    .replace(/ \(\[docs[^)]*\)\)/g, "")
    .replace(/ \(\[[^\]]*\]\(docs[^)]*\)\)/g, "")
    .replace(/\[([^\]]+)\]\([^)]+\)/g, "$1")
    .replace(/`([^`]+)`/g, "<code>$1</code>")
    .replace(/\*\*([^*]+)\*\*/g, "<b>$1</b>");
}

/** The part of a document below a heading, up to the next heading of its kind. */
export function section(document, heading) {
  const from = document.indexOf(`\n## ${heading}\n`);
  if (from < 0) throw new Error(`there is no heading "${heading}"`);
  const body = document.slice(from + heading.length + 5);
  const end = body.search(/^## /m);
  return end < 0 ? body : body.slice(0, end);
}

/** The rows of the first table of a text, each a list of cells; the line below its head is left out. */
export function rows(text) {
  const lines = text.split("\n");
  const from = lines.findIndex((line) => line.startsWith("|"));
  if (from < 0) throw new Error("there is no table");
  const length = lines.slice(from).findIndex((line) => !line.startsWith("|"));
  const own = lines.slice(from, length < 0 ? undefined : from + length);
  return own.filter((_, at) => at !== 1).map((line) => line.split("|").slice(1, -1).map((cell) => cell.trim()));
}

/** The first block of code in a language; without one, of none. */
export function code(text, language = "") {
  const found = new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\``, "m").exec(text);
  if (!found) throw new Error(`there is no code in ${language || "no language"}`);
  return found[1].trimEnd();
}
