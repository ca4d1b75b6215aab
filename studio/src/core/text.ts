/** The room that text takes in the page's typeface, to lay capsules out without asking the browser. */

/** How wide the letters from space to `~` are in Inter, in hundredths of its size. */
const LETTERS: readonly number[] = [
  28, 29, 47, 63, 64, 98, 64, 30, 36, 36, 50, 66, 29, 46, 29, 36, 63, 41, 61, 62, 65, 59, 62, 57,
  62, 62, 29, 30, 66, 66, 66, 51, 97, 69, 65, 73, 72, 60, 59, 75, 74, 27, 57, 67, 57, 90, 75, 76,
  64, 76, 64, 64, 65, 74, 69, 99, 68, 68, 63, 36, 36, 36, 47, 46, 32, 56, 61, 57, 61, 58, 37, 61,
  59, 24, 24, 55, 24, 88, 59, 60, 61, 61, 38, 53, 33, 59, 56, 82, 55, 56, 55, 43, 33, 43, 66,
];
/** Letters of other alphabets: about as wide as a capital; signs of the east are square. */
const OTHER = 0.66;
const SQUARE = 1;
/** Digits that stand below each other, as numbers have them. */
export const DIGIT = 0.65;
/** Half-bold letters are this much wider. */
export const HALF_BOLD = 1.04;

export function textWidth(text: string, size: number): number {
  let width = 0;
  for (const letter of text) {
    const known = LETTERS[(letter.codePointAt(0) ?? 0) - 32];
    width += known === undefined ? (letter > "\u2e80" ? SQUARE : OTHER) : known / 100;
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
