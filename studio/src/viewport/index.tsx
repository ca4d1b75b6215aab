import "./geometry";

export { ViewportPane } from "./ViewportPane";
export { currentViewport } from "./current";
