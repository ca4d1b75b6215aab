/** Draws many lines over several frames, so that the page answers in between. */

/** Some rows that are drawn alike. */
export interface Job {
  rows: readonly number[];
  /** Sets how they are drawn. */
  style: () => void;
}

/** So many rows are drawn in the first frame; in each later one as many as frames of this length in milliseconds allow. */
const FIRST = 400;
const FRAME = 40;
const [LEAST, MOST] = [100, 4000];

/**
 * The jobs in pieces of at most so many rows. A piece may have the ends of one job and the beginning of the next.
 */
export function* pieces(jobs: readonly Job[], size: () => number): Generator<{ style: () => void; rows: readonly number[] }[]> {
  let piece: { style: () => void; rows: readonly number[] }[] = [];
  let room = size();
  for (const { rows, style } of jobs) {
    for (let from = 0; from < rows.length; ) {
      const taken = rows.slice(from, from + room);
      piece.push({ style, rows: taken });
      [from, room] = [from + taken.length, room - taken.length];
      if (room > 0) continue;
      yield piece;
      [piece, room] = [[], size()];
    }
  }
  if (piece.length > 0) yield piece;
}

/** Begins to draw; gives what ends it. `begin` clears the canvas, in the frame in which the first lines are drawn. */
export function paint(jobs: readonly Job[], begin: () => void, stroke: (rows: readonly number[]) => void): () => void {
  let count = FIRST;
  let before: number | undefined;
  const left = pieces(jobs, () => count);
  let request = requestAnimationFrame(function frame(now) {
    if (before === undefined) begin();
    else if (now - before > FRAME) count = Math.max(LEAST, Math.floor(count / 2));
    else count = Math.min(MOST, count * 2);
    before = now;
    const piece = left.next();
    if (piece.done) return;
    for (const { style, rows } of piece.value) {
      style();
      stroke(rows);
    }
    request = requestAnimationFrame(frame);
  });
  return () => cancelAnimationFrame(request);
}
