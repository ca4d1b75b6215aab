/** The page on a study. */

import "../app/tokens.css";
import "../app/app.css";
import "./study.css";

import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { Boundary } from "../app/Boundary";
import { Broken } from "../app/Broken";
import { followTheme } from "../app/settings";
import { StudyPage } from "./StudyPage";

followTheme();
const root = document.getElementById("root");
if (root) {
  createRoot(root).render(
    <StrictMode>
      <Boundary fallback={<Broken />}>
        <StudyPage />
      </Boundary>
    </StrictMode>,
  );
}
