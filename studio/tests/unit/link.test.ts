import { describe, expect, it } from "vitest";

import { addressOf, textOf } from "../../src/engine/link";

const bytes = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>;

describe("a definition in an address", () => {
  it("comes back as it was, with its name", async () => {
    const text = 'katydid 1\nname = Panel("Größe ± 3 °")\n'.repeat(40);
    const link = await addressOf("https://example.org/studio/?document=abc&player=", "Turm & Dach.kd", bytes(text));
    const url = new URL(link);
    expect(url.searchParams.has("document")).toBe(false);
    expect(url.searchParams.has("player")).toBe(true);
    expect(link.length).toBeLessThan(400);
    const found = await textOf(url.hash);
    expect(found?.name).toBe("Turm & Dach.kd");
    expect(new TextDecoder().decode(found?.bytes)).toBe(text);
  });

  it("is none where the fragment holds none", async () => {
    expect(await textOf("")).toBeUndefined();
    expect(await textOf("#canvas")).toBeUndefined();
  });

  it("is refused where it is too long, damaged, or unpacks to too much", async () => {
    let state = 1;
    const noise = Uint8Array.from({ length: 60_000 }, () => {
      // Marsaglia's xorshift: what cannot be packed.
      state ^= state << 13;
      state ^= state >>> 17;
      state ^= state << 5;
      return state & 255;
    }) as Uint8Array<ArrayBuffer>;
    await expect(addressOf("https://example.org/", "x", noise)).rejects.toThrow(RangeError);
    await expect(textOf("#d=AAAA")).rejects.toThrow();
    await expect(textOf("#d=%%%")).rejects.toThrow();
    const zeros = await addressOf("https://example.org/", "x", new Uint8Array(4 << 20));
    expect((await textOf(new URL(zeros).hash))?.bytes.length).toBe(4 << 20);
  });
});
