/** Registers every action; order here is order in menus. */
import "./file";
import "./canvas";
import "./solution";
import "./view";
import "./help";
import "./helpComponent";
