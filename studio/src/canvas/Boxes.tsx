import { ConnectBox } from "./search/ConnectBox";
import { FindBox } from "./search/FindBox";
import { SearchBox } from "./search/SearchBox";
import { ContextMenu } from "./menus/ContextMenu";
import { Radial } from "./menus/Radial";
import { Editor } from "./editors/Editor";
import { Tip } from "./tips/Tip";

/** The boxes that open over the canvas. Each shows itself when its part of the store says so. */
export function Boxes() {
  return (
    <>
      <Tip />
      <ContextMenu />
      <Radial />
      <SearchBox />
      <ConnectBox />
      <FindBox />
      <Editor />
    </>
  );
}
