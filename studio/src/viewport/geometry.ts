/** The geometry of the document that is open: kept while no viewport is on the page, drawn by the one that is. */

import { setGeometrySink } from "../state/preview";
import { GeometryStore } from "./geometryStore";

/** What the document's objects show. */
export const geometry = new GeometryStore();
/** What is looked at closely: combs, circles, control points, by the objects that they are of. */
export const analysisGeometry = new GeometryStore();

setGeometrySink("preview", geometry);
setGeometrySink("analysis", analysisGeometry);
