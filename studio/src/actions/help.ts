import { showDialog } from "../dialogs/store";
import { register } from "./registry";

register(
  { id: "help.palette", label: "action.palette", group: "help", keys: ["Mod+K", "/"], run: () => showDialog("palette") },
  { id: "help.keys", label: "action.keys", group: "help", keys: ["?"], run: () => showDialog("keys") },
  { id: "help.about", label: "action.about", group: "help", run: () => showDialog("about") },
);
