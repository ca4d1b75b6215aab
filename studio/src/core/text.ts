/** The room that text takes, near enough to lay capsules out without asking the browser. */

/** Widths of letters of a sans-serif face, in units of its size. */
const NARROW = new Set("iljtfrI.,:;'|!()[]{} ");
const BROAD = new Set("mwMW@%—∑");

export function textWidth(text: string, size: number): number {
  let width = 0;
  for (const letter of text) {
    if (NARROW.has(letter)) width += 0.31;
    else if (BROAD.has(letter)) width += 0.86;
    else if (letter >= "A" && letter <= "Z") width += 0.68;
    else width += letter > "\u2e80" ? 1 : 0.55;
  }
  return width * size;
}

/** A text cut to a width, with an ellipsis where something is left out. */
export function cut(text: string, size: number, room: number): string {
  if (textWidth(text, size) <= room) return text;
  const letters = [...text];
  while (letters.length > 0 && textWidth(`${letters.join("")}…`, size) > room) letters.pop();
  return `${letters.join("")}…`;
}

/** A text in lines no wider than the room, broken between words where it can be. */
export function wrapped(text: string, size: number, room: number): string[] {
  const lines: string[] = [];
  for (const paragraph of text.split("\n")) {
    let line = "";
    for (const word of paragraph.split(" ")) {
      const longer = line === "" ? word : `${line} ${word}`;
      if (line !== "" && textWidth(longer, size) > room) {
        lines.push(line);
        line = word;
      } else line = longer;
    }
    lines.push(line);
  }
  return lines;
}
