/** The picture of each component: a drawing of its own for each that can be placed. */

import { hotFill, layers, type Drawing, type Piece } from "./piece";
import { curve } from "./table/curve";
import { display } from "./table/display";
import { intersect } from "./table/intersect";
import * as loops from "./table/loops";
import { maths, scalar } from "./table/maths";
import { meshes } from "./table/mesh";
import { params } from "./table/params";
import * as plugins from "./table/plugins";
import { rhino } from "./table/rhino";
import { sets } from "./table/sets";
import { special, unknown } from "./table/special";
import { surface } from "./table/surface";
import type { Tab } from "./table/tab";
import * as terrains from "./table/terrains";
import { transform } from "./table/transform";
import { vectors } from "./table/vector";
import * as volumes from "./table/volumes";

const TABS: Readonly<Record<string, Tab>> = {
  Params: params,
  Maths: maths,
  Scalar: scalar,
  Sets: sets,
  Vector: vectors,
  Curve: curve,
  Surface: surface,
  Mesh: meshes,
  Intersect: intersect,
  Transform: transform,
  Display: display,
  Rhino: rhino,
  Anemone: loops.anemone,
  Bison: terrains.bison,
  BitmapPlus: terrains.bitmapPlus,
  ColorPlus: volumes.colorplus,
  Dendro: volumes.dendro,
  Docofossor: terrains.docofossor,
  EdiTree: plugins.editree,
  EleFront: volumes.elefront,
  gHowl: plugins.ghowl,
  Heteroptera: plugins.heteroptera,
  HoopSnake: loops.hoopSnake,
  Human: plugins.human,
  jSwan: volumes.jswan,
  Kangaroo2: plugins.kangaroo2,
  LunchBox: plugins.lunchbox,
  MeshEdit: plugins.meshedit,
  Noise4D: terrains.noise4D,
  Pufferfish: terrains.pufferfish,
  Telepathy: plugins.telepathy,
  TreeFrog: plugins.treefrog,
  TreeSloth: volumes.treesloth,
  VoxelTools: terrains.voxelTools,
  Weaverbird: plugins.weaverbird,
};

/** The part of the plane that a picture is shown from: see README.md. */
export const VIEW = "0.25 0.25 24 24";

/** Where a component stands in the tabs. */
export interface Place {
  tab: string;
  panel: string;
  old: boolean;
}

const OBSOLETE = / \[OBSOLETE\]$/;
/** Components that once took a fixed number of inputs, such as Merge 05. */
const COUNT = / (\d\d|Multiple)$/;
/** Old components have the picture of what came after them, with a folded corner. */
const FOLD = hotFill("M0 0H7L0 7Z");

/** The drawing of a component of the tabs, if it has one of its own. */
export function drawingOf(id: string, name: string, { tab, panel, old }: Place): Drawing | undefined {
  const pictures = TABS[tab]?.[panel];
  const drawing = pictures?.[`${name} ${id.slice(0, 8)}`] ?? pictures?.[name] ?? pictures?.[name.replace(OBSOLETE, "")];
  return drawing && (old || OBSOLETE.test(name)) ? [drawing, FOLD] : drawing;
}

/** By the name alone: for what is not in the tabs, or not in those of this program. */
function drawingNamed(name: string): Drawing {
  const plain = name.replace(OBSOLETE, "").replace(COUNT, "");
  const own = special[plain];
  if (own) return own;
  for (const tab of Object.values(TABS)) {
    for (const pictures of Object.values(tab)) {
      const found = pictures[plain];
      if (found) return found;
    }
  }
  return unknown;
}

const drawn = new Map<string, readonly Piece[]>();

/** The paths of a component's picture, from the back to the front. They are put together once. */
export function pictureOf(id: string, name: string, place: Place | undefined): readonly Piece[] {
  const key = place ? `${id} ${name}` : name;
  const known = drawn.get(key);
  if (known) return known;
  const paths = layers((place && drawingOf(id, name, place)) ?? drawingNamed(name));
  drawn.set(key, paths);
  return paths;
}
