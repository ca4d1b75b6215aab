// @vitest-environment jsdom
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";
import { afterEach, expect, test, vi } from "vitest";

import { Boundary } from "../../src/app/Boundary";

afterEach(() => vi.restoreAllMocks());

test("what cannot be drawn has its fallback, the rest stays, and a change is tried again", () => {
  vi.spyOn(console, "error").mockImplementation(() => {});
  const Face = ({ value }: { value: number | null }) => createElement("b", null, value!.toFixed(1));
  const page = (value: number | null) =>
    createElement("p", null, "page ", createElement(Boundary, { of: value, fallback: "nothing", children: createElement(Face, { value }) }));
  const place = document.createElement("div");
  const root = createRoot(place);
  const draw = (value: number | null) => flushSync(() => root.render(page(value)));
  draw(2);
  expect(place.textContent).toBe("page 2.0");
  draw(null);
  expect(place.textContent).toBe("page nothing");
  draw(3);
  expect(place.textContent).toBe("page 3.0");
  root.unmount();
});
