/** The script of a page of the book. */

import "./learn.css";

import { Figure } from "./figure";
import { readyDrags, readyTies } from "./live";
import { readyExercises, readyPredictions } from "./questions";
import { readySteps } from "./steps";
import { readyTools } from "./tools";

readyTools();
customElements.define("katydid-figure", Figure);
readyDrags();
readyTies();
readySteps();
readyPredictions();
readyExercises();
