/** The head of a page: search, and light or dark. */

import { figureOf } from "./figure";
import { button, make } from "./elements";
import { page, word } from "./words";

declare global {
  interface Window {
    /** Folder, title, summary and words of each page: `search.js`. */
    katydidSearch?: [string, string, string, string][];
  }
}

const KEY = "katydid.book.theme";
const MOST = 12;

function kept(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function isDark(): boolean {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

function retheme(): void {
  for (const figure of document.querySelectorAll("figure.figure")) figureOf(figure.id)?.retheme();
}

function themeButton(): HTMLElement {
  return button("◐", () => {
    const theme = isDark() ? "light" : "dark";
    document.documentElement.dataset.theme = theme;
    try {
      localStorage.setItem(KEY, theme);
    } catch {
      // A browser that keeps nothing still changes.
    }
    retheme();
  }, { "aria-label": word("theme"), title: word("theme"), class: "theme" });
}

/** The pages that have all words of a text: those with a word in their title first. */
export function found(text: string, pages: readonly [string, string, string, string][]): [string, string, string, string][] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const score = ([folder, title, summary, all]: [string, string, string, string]) => {
    const [head, rest] = [`${folder} ${title}`.toLowerCase(), `${summary} ${all}`.toLowerCase()];
    let sum = 0;
    for (const one of words) {
      if (head.includes(one)) sum += 3;
      else if (rest.includes(one)) sum += 1;
      else return 0;
    }
    return sum;
  };
  const scored = pages.map((one) => [score(one), one] as const).filter(([sum]) => sum > 0);
  return scored.sort(([a], [b]) => b - a).map(([, one]) => one).slice(0, MOST);
}

function searchField(): HTMLElement {
  const input = make("input", { type: "search", placeholder: word("search"), "aria-label": word("search") });
  const list = make("ul", { class: "found", hidden: true });
  input.addEventListener("input", () => {
    const pages = found(input.value, window.katydidSearch ?? []);
    list.hidden = input.value.trim() === "";
    const rows = pages.map(([folder, title, summary]) =>
      make("li", {}, make("a", { href: `${page.own}${folder}/index.html` }, title), ` ${summary}`),
    );
    list.replaceChildren(...(rows.length > 0 ? rows : [make("li", {}, word("search-none"))]));
  });
  return make("div", { class: "search", role: "search" }, input, list);
}

export function readyTools(): void {
  const theme = kept();
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);
  document.getElementById("tools")?.append(searchField(), themeButton());
}
