/** All actions of the canvas: importing this registers them. */
import "./canvasEdit";
import "./canvasObjects";
import "./canvasView";
import "./canvasViews";
