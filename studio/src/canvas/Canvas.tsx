import "@xyflow/react/dist/base.css";
import "./tokens.css";
import "./canvas.css";
import "./nodes.css";
import "./notes.css";
import "./faces.css";
import "./moments.css";
import "./fields.css";
import "./boxes.css";
import "./more.css";
import "./colours.css";

import { ReactFlow, ReactFlowProvider, useReactFlow, useStore as useFlowStore, useStoreApi, type EdgeTypes, type NodeTypes } from "@xyflow/react";
import { useEffect, useLayoutEffect, useRef, useState, type PointerEvent, type ReactNode } from "react";
import { useStore } from "zustand";

import "../actions/canvas";
import { paste } from "../actions/canvasEdit";
import { FARTHEST } from "../core/geometry";
import { t } from "../i18n";
import { loadCatalogue } from "../state/catalogue";
import { documentStore } from "../state/document";
import { uiStore } from "../state/ui";
import { AlignWidget } from "./AlignWidget";
import { Boxes } from "./Boxes";
import { Crumbs } from "./Crumbs";
import { FarLayer } from "./FarLayer";
import { EdgeMaker, NodeMaker, type CanvasNode, type WireEdge } from "./flow";
import { Compass } from "./Compass";
import { Likely } from "./Likely";
import { FoundArrows } from "./FoundArrows";
import { keysChanged, pointerDown, pointerMove, pointerUp, wheel } from "./gestures/bind";
import { doubleClick, drop, keyDown, placeClick } from "./gestures/more";
import { Hints } from "./Hints";
import { Near, useCanvas } from "./hooks";
import { hoverOver, hoverOut } from "./tips/hover";
import { Capsule, Parameter, Relay } from "./nodes/Capsule";
import { Control } from "./nodes/Control";
import { Group, Scribble, Sketch } from "./nodes/Notes";
import { ofObject } from "./nodes/ofObject";
import { focusCanvas } from "./open";
import { Overlay } from "./Overlay";
import { Ribbon } from "./Ribbon";
import { tellEdits } from "./tell";
import { forgetLook, keepLook, lens, setFlow, setPane, takeLens } from "./view";
import { loadViews } from "./views";
import { Wire } from "./wires/Wire";
import { ZoomBox } from "./ZoomBox";

/** Names of our own: xyflow has types such as `group` with a look that nobody asked for. */
const NODE_TYPES: NodeTypes = {
  "k-component": ofObject(Capsule),
  "k-cluster": ofObject(Capsule),
  "k-parameter": ofObject(Parameter),
  "k-control": ofObject(Control),
  "k-group": ofObject(Group),
  "k-scribble": ofObject(Scribble),
  "k-sketch": ofObject(Sketch),
  "k-relay": ofObject(Relay),
};
const EDGE_TYPES: EdgeTypes = { wire: Wire };
/** What the page is made of is named in About Katydid. */
const NO_LABEL = { hideAttribution: true };
const NO_NODES: CanvasNode[] = [];
const NO_WIRES: WireEdge[] = [];

/** The canvas: the definition, and everything that hands do with it. It needs the stores and nothing else. */
export function Canvas() {
  useEffect(() => void loadCatalogue(), []);
  useEffect(() => tellEdits(), []);
  useEffect(loadViews, []);
  return (
    <div className="canvas-pane">
      <Ribbon />
      <Crumbs />
      <ReactFlowProvider>
        <Ground>
          <Flow />
        </Ground>
      </ReactFlowProvider>
      <Said />
    </div>
  );
}

/** The ground of the canvas: it takes the pointer, the wheel and the keys of all that lies on it. */
function Ground({ children }: { children: ReactNode }) {
  const ground = useRef<HTMLDivElement>(null);
  const placing = useCanvas((canvas) => canvas.placing !== undefined);
  const finding = useCanvas((canvas) => canvas.found !== undefined);
  const wiring = useCanvas((canvas) => canvas.wire?.how);

  useEffect(() => {
    const element = ground.current;
    if (!element) return;
    setPane(element);
    // React listens to wheels passively; here the page must not scroll.
    element.addEventListener("wheel", wheel, { passive: false });
    window.addEventListener("keydown", keysChanged);
    window.addEventListener("keyup", keysChanged);
    // Not captured by the ground: a double-click must reach the element that it is meant for.
    window.addEventListener("pointermove", pointerMove);
    window.addEventListener("pointerup", pointerUp);
    window.addEventListener("pointercancel", pointerUp);
    // Who goes to the room that the canvas is in goes to the canvas.
    const room = element.closest('[data-scope="canvas"]');
    const enter = (event: FocusEvent) => {
      if (event.target === room) focusCanvas();
    };
    window.addEventListener("focusin", enter);
    return () => {
      window.removeEventListener("focusin", enter);
      window.removeEventListener("pointermove", pointerMove);
      window.removeEventListener("pointerup", pointerUp);
      window.removeEventListener("pointercancel", pointerUp);
      setPane(undefined);
      element.removeEventListener("wheel", wheel);
      window.removeEventListener("keydown", keysChanged);
      window.removeEventListener("keyup", keysChanged);
    };
  }, []);

  const press = (event: PointerEvent<HTMLDivElement>) => {
    if (placeClick(event)) return;
    const inBox = event.target instanceof Element && event.target.closest(".box");
    if (inBox) return;
    // A control keeps the left button for itself; the others mean the same on it as beside it.
    const own = event.button === 0 && event.target instanceof Element && event.target.closest("[data-own]");
    if (own) return;
    event.currentTarget.focus({ preventScroll: true });
    pointerDown(event.nativeEvent);
  };
  return (
    <div
      ref={ground}
      className={`ground ${placing ? "placing" : ""} ${finding ? "finding" : ""} ${wiring ? `wiring-${wiring}` : ""}`}
      role="group"
      aria-label={t("canvas.title")}
      aria-describedby="canvas-help"
      tabIndex={0}
      onPointerDown={press}
      onPointerMove={(event) => hoverOver(event.nativeEvent)}
      onPointerLeave={hoverOut}
      onDoubleClick={(event) => doubleClick(event.nativeEvent)}
      onContextMenu={(event) => event.preventDefault()}
      // A middle click pastes the marked text on some systems: here it opens the ring of commands. Firefox pastes after
      // the click, Chromium when the button comes up.
      onAuxClick={(event) => event.preventDefault()}
      onMouseUp={(event) => event.button === 1 && event.preventDefault()}
      onKeyDown={(event) => keyDown(event)}
      onPaste={(event) => {
        if (event.target instanceof Element && event.target.matches("input, textarea")) return;
        event.preventDefault();
        void paste(event.clipboardData.getData("text/plain"));
      }}
      onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => drop(event.nativeEvent)}
    >
      <p id="canvas-help" className="unseen">
        {t("canvas.help")}
      </p>
      <div className="grid" aria-hidden="true" />
      {children}
      <Hints />
      <Boxes />
    </div>
  );
}

/**
 * Sizes and grips are told by the document. xyflow would measure each element that it mounts all the same, find no
 * handles of its own in it, and drop the wires; so it is kept from measuring.
 */
function useNoMeasuring(): void {
  const store = useStoreApi();
  useState(() => store.setState({ updateNodeInternals: () => {} }));
}

function Flow() {
  useNoMeasuring();
  const flow = useReactFlow();
  const distance = useCanvas((canvas) => canvas.distance);
  const full = useStore(uiStore, (ui) => ui.fullNames);
  const shifts = useCanvas((canvas) => canvas.shifts);
  const [nodeMaker] = useState(() => new NodeMaker());
  const [edgeMaker] = useState(() => new EdgeMaker());
  const seen = useFirstLook();
  const far = distance === "far";
  // Nothing is mounted before it is known how far away it is looked at: thousands of objects would all come and go.
  const mounted = seen && !far;
  // Most changes of the document move nothing: then there is nothing to be done here.
  const nodes = useStore(documentStore, ({ objects, order }) => (mounted ? nodeMaker.make(objects, order, shifts, full) : NO_NODES));
  const edges = useStore(documentStore, ({ objects, outputs }) => (mounted ? edgeMaker.make(objects, outputs) : NO_WIRES));

  useEffect(() => {
    setFlow(flow);
    return () => setFlow(undefined);
  }, [flow]);

  return (
    <Near.Provider value={distance === "near"}>
      <ReactFlow
        nodes={nodes}
        edges={edges}
        nodeTypes={NODE_TYPES}
        edgeTypes={EDGE_TYPES}
        onMove={(_, lens) => takeLens(lens)}
        onlyRenderVisibleElements
        proOptions={NO_LABEL}
        minZoom={FARTHEST}
        maxZoom={5}
        panOnDrag={false}
        panOnScroll={false}
        zoomOnScroll={false}
        zoomOnPinch={false}
        zoomOnDoubleClick={false}
        preventScrolling={false}
        nodesDraggable={false}
        nodesConnectable={false}
        nodesFocusable={false}
        edgesFocusable={false}
        edgesReconnectable={false}
        elementsSelectable={false}
        selectionOnDrag={false}
        selectionKeyCode={null}
        deleteKeyCode={null}
        multiSelectionKeyCode={null}
        panActivationKeyCode={null}
        zoomActivationKeyCode={null}
        disableKeyboardA11y
        zIndexMode="manual"
        elevateNodesOnSelect={false}
      >
        {far ? <FarLayer /> : null}
        <Overlay />
        <AlignWidget />
        <ZoomBox />
        <FoundArrows />
        <Compass />
        <Likely />
      </ReactFlow>
    </Near.Provider>
  );
}

/** A document that is shown for the first time is shown whole, or from its beginning; so is the inside of a cluster. Gives whether it was. */
function useFirstLook(): boolean {
  const within = useStore(documentStore, (mirror) => mirror.within.join());
  const here = useStore(documentStore, (mirror) => mirror.document !== undefined);
  const [looked, setLooked] = useState<string | undefined>(undefined);
  useLayoutEffect(forgetLook, [here, within]);
  useEffect(() => {
    if (!here || looked === within) return undefined;
    // The window has its size only after the first drawing.
    const request = requestAnimationFrame(() => {
      keepLook();
      takeLens(lens());
      setLooked(within);
    });
    return () => cancelAnimationFrame(request);
  }, [here, within, looked]);
  useRefit(looked === within);
  return looked === within;
}

/**
 * Until a hand looks elsewhere or changes something all is kept in the window, however large that becomes: a phone is
 * turned, a pane is drawn wider, a line of news comes above.
 */
function useRefit(seen: boolean): void {
  const width = useFlowStore((flow) => flow.width);
  const height = useFlowStore((flow) => flow.height);
  /** The revision that was looked at first. */
  const looked = useRef<number | undefined>(undefined);
  useEffect(() => {
    const { revision } = documentStore.getState();
    if (!seen || looked.current === undefined) {
      looked.current = seen ? revision : undefined;
      return;
    }
    if (looked.current !== revision) return;
    keepLook();
    takeLens(lens());
  }, [seen, width, height]);
}

/** What is said to screen readers while something is done. */
function Said() {
  const said = useCanvas((canvas) => canvas.said);
  return (
    <div className="unseen" role="status" aria-live="polite">
      {said}
    </div>
  );
}
