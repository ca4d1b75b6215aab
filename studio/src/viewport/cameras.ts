/** The named cameras of the document that is open: this browser keeps them, as it keeps the named views of the canvas. */

import { createStore } from "zustand/vanilla";

import { place } from "../app/place";
import { readCameras, type NamedCamera } from "../core/cameras";
import { freshName, without, withNamed } from "../core/named";
import { t } from "../i18n";
import { currentViewport } from "./current";

const KEPT = "katydid.cameras.";
const key = () => KEPT + (place(location.search).document ?? "");

function kept(): NamedCamera[] {
  try {
    return readCameras(localStorage.getItem(key()));
  } catch {
    // Storage may be forbidden: then there are none.
    return [];
  }
}

export const cameraStore = createStore<{ cameras: readonly NamedCamera[] }>(() => ({ cameras: kept() }));

function put(cameras: readonly NamedCamera[]): void {
  cameraStore.setState({ cameras });
  try {
    localStorage.setItem(key(), JSON.stringify(cameras));
  } catch {
    // They hold for this page then.
  }
}

/** Gives the camera of the active view a name: the one told, or the next free number. */
export function saveCamera(told = ""): void {
  const viewport = currentViewport();
  if (!viewport) return;
  const { cameras } = cameraStore.getState();
  const name = told.trim() || freshName(cameras, (number) => t("viewport.cameras.numbered", { number }));
  put(withNamed(cameras, { name, pose: { ...viewport.panes.active.rig.pose } }));
}

export function removeCamera(name: string): void {
  put(without(cameraStore.getState().cameras, name));
}

/** Turns the active view to a named camera. */
export function showCamera({ pose }: NamedCamera, isStill: boolean): void {
  currentViewport()?.panes.goTo(pose, isStill);
}
