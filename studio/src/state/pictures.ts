/** Small pictures of what definitions made when they were looked at last: this browser keeps them for the start page. */

const KEY = "katydid.pictures";
/** As many as a start page shows; the oldest goes first. */
const MOST = 48;

interface Kept {
  picture: string;
  at: number;
}

function kept(): Record<string, Kept> {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return typeof found === "object" && found !== null ? (found as Record<string, Kept>) : {};
  } catch {
    return {};
  }
}

/** A definition is known by its path, one without by its name. */
export function keepPicture(of: string, picture: string, at = Date.now()): void {
  const all = Object.entries({ ...kept(), [of]: { picture, at } });
  const newest = all.sort(([, a], [, b]) => b.at - a.at).slice(0, MOST);
  try {
    localStorage.setItem(KEY, JSON.stringify(Object.fromEntries(newest)));
  } catch {
    // There is no room, or storage is forbidden: the start page shows no picture then.
  }
}

/** The pictures by path or name, as addresses of images. */
export function pictures(): ReadonlyMap<string, string> {
  return new Map(Object.entries(kept()).flatMap(([of, { picture }]) => (/^data:image\//.test(picture) ? [[of, picture]] : [])));
}
