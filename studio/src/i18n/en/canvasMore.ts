/** What the boxes, dialogs and handles of the canvas say. */
export const canvasMore = {
  "help.component": "Help on the component",
  "help.asked": "Looking it up …",
  "help.failed": "There is no help on this component.",
  "help.unsupported": "This component cannot run here. It is kept with its wires and saved unchanged.",
  "help.old": "kept for old files",
  "help.inputs": "Inputs",
  "help.outputs": "Outputs",
  "help.name": "Name",
  "help.type": "Type",
  "help.what": "What it is",
  "help.optional": "optional",
  "help.many": "any number of these",

  "canvas.radial": "Ring of commands",
  "canvas.aligning": "Handles for lining up",
} as const;
