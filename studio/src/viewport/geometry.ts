/** The geometry of the document that is open: kept while no viewport is on the page, drawn by the one that is. */

import { setPreviewSink } from "../state/preview";
import { GeometryStore } from "./geometryStore";

export const geometry = new GeometryStore();
setPreviewSink(geometry);
