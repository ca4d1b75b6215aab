import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { App } from "./app/App";
import { Boundary } from "./app/Boundary";
import { Broken } from "./app/Broken";

const root = document.getElementById("root");
if (root) {
  createRoot(root).render(
    <StrictMode>
      <Boundary fallback={<Broken />}>
        <App />
      </Boundary>
    </StrictMode>,
  );
}
