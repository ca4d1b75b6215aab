import { expect, it } from "vitest";

import { abbreviation } from "../../src/core/abbreviation";

it("names become short", () => {
  expect(abbreviation("Add")).toBe("Add");
  expect(abbreviation(" A×B ")).toBe("A×B");
  expect(abbreviation("Divide Curve")).toBe("DC");
  expect(abbreviation("Brep | Brep")).toBe("BB");
  expect(abbreviation("Explode")).toBe("Exp");
  expect(abbreviation("")).toBe("");
});
