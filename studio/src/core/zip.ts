/** Zip archives of files that are packed already: each is stored as it is (PKWARE's APPNOTE.TXT, 4.3). */

export interface ZipFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit++) rest = rest & 1 ? 0xedb88320 ^ (rest >>> 1) : rest >>> 1;
  return rest;
});

/** The checksum of zip and PNG. */
export function crc32(bytes: Uint8Array): number {
  let rest = 0xffffffff;
  for (const byte of bytes) rest = (TABLE[(rest ^ byte) & 255] ?? 0) ^ (rest >>> 8);
  return (rest ^ 0xffffffff) >>> 0;
}

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
/** The names are UTF-8. */
const UTF_8 = 1 << 11;
/** The first of January 1980: the same files give the same archive. */
const DATE = 33;

/** A zip archive of these files, in their order. */
export function zipOf(files: readonly ZipFile[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const list: Uint8Array<ArrayBuffer>[] = [];
  let at = 0;
  for (const { name, bytes } of files) {
    const letters = new TextEncoder().encode(name);
    const about = [UTF_8, 0, 0, DATE];
    const sizes = [crc32(bytes), bytes.length, bytes.length];
    const head = record([[LOCAL, 4], [20, 2], ...about.map(two), ...sizes.map(four), [letters.length, 2], [0, 2]]);
    list.push(record([[CENTRAL, 4], [20, 2], [20, 2], ...about.map(two), ...sizes.map(four), [letters.length, 2], [0, 2], [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]]), letters);
    parts.push(head, letters, bytes);
    at += head.length + letters.length + bytes.length;
  }
  const size = list.reduce((sum, part) => sum + part.length, 0);
  const end = record([[END, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [size, 4], [at, 4], [0, 2]]);
  return new Blob([...parts, ...list, end], { type: "application/zip" });
}

type Field = [value: number, bytes: number];
const two = (value: number): Field => [value, 2];
const four = (value: number): Field => [value, 4];

/** Numbers one after the other, the lowest byte first. */
function record(fields: readonly Field[]): Uint8Array<ArrayBuffer> {
  const bytes = fields.flatMap(([value, count]) => Array.from({ length: count }, (_, k) => (value >>> (8 * k)) & 255));
  return Uint8Array.from(bytes);
}
