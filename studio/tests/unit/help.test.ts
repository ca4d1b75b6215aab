import { describe, expect, test } from "vitest";

import { paragraphs, readHelp } from "../../src/core/help";

describe("help", () => {
  test("is read from the server's answer, and what is missing in it does no harm", () => {
    const help = readHelp({ guid: "g", name: "Addition", nick: "A+B", help: "Adds.", inputs: [{ name: "A", many: true }, 7], outputs: null });
    expect(help?.is).toBe("component");
    if (help?.is !== "component") return;
    expect(help.inputs.map((port) => [port.name, port.many, port.optional])).toEqual([["A", true, false], ["", false, false]]);
    expect(help.outputs).toEqual([]);
  });

  test("of a component that cannot run says why", () => {
    expect(readHelp({ name: "Galapagos", unsupported: "It is a search" })).toEqual({ is: "unsupported", name: "Galapagos", reason: "It is a search" });
  });

  test("is none in what is no answer", () => {
    for (const answer of [null, 3, "text", [], {}, { name: 4 }]) expect(readHelp(answer)).toBeUndefined();
  });

  test("has paragraphs", () => {
    expect(paragraphs("One.\n\n  Two. \n")).toEqual(["One.", "Two."]);
  });
});
