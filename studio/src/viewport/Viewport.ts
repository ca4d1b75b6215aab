/** The picture of the model: draws when something changed, and never else. */

import { SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import type { StoreApi } from "zustand/vanilla";

import { union } from "../core/bounds";
import type { Bounds, Point3, Preview, Rgba } from "../core/preview";
import { rectangle } from "../core/screen";
import { placeOf } from "../core/section";
import { FalseColours } from "./analysis";
import { isSoftware } from "./graphics";
import { Panes, placeOf as placeOfPanes, type PlacedPane } from "./panes";
import { Backdrop } from "./scene/backdrop";
import type { Budget } from "./scene/drawable";
import { dress } from "./scene/dress";
import { Model } from "./scene/model";
import { Painter, type Layer } from "./scene/painter";
import { paintOn, pixelOf, pngOf } from "./snapshot";
import { settingsStore, viewportStore, type ViewportSettings, type ViewportState } from "./settings";
import { readTheme, type Theme } from "./theme";
import { isOfDocument, isTool } from "./tools/beside";
import { Picker, type Pick, type PickView } from "./tools/picking";
import { vertexAt } from "./tools/vertices";
import { inWindow } from "./tools/windowSelect";
import { areAlike, isHidden, type Surroundings } from "./surroundings";
import { TextLayer } from "./overlay/texts";

export interface Options {
  /** Smooth borders; off where pictures are compared, and where the graphics card is software. */
  antialias?: boolean;
  pixelRatio?: number;
  /** Settings and state of its own, where several viewports stand on a page; else those of the studio. */
  settings?: StoreApi<ViewportSettings>;
  state?: StoreApi<ViewportState>;
  /** How many times as wide as usual lines, points and arrowheads are. */
  weight?: number;
  /** How much of the view geometry leaves free after it was framed: 1.1 is a tenth. */
  margin?: number;
  /** The size of texts that have none of their own, in pixels. */
  textSize?: number;
}

/** What a graphics card draws in one go, and what software does. */
const CARD: Budget = { wide: 300_000, points: Infinity, edges: Infinity, areInstances: true, areDraftsThin: false };
const SOFTWARE: Budget = { wide: 4_000, points: 2_500, edges: 10_000, areInstances: false, areDraftsThin: true };
/** From this many triangles and segments on software draws a quick picture first, and the right one when it rests. */
const HEAVY = 10_000;
/** A turn of the turntable takes so many milliseconds. */
const TURNTABLE = 24_000;
/** A quick picture has so many of the pixels of a fine one along each side: what moves is not looked at closely. */
const QUICK_SHARE = 0.5;
const REST = 350;

export class Viewport {
  readonly canvas: HTMLCanvasElement;
  readonly model: Model;
  readonly panes: Panes;
  readonly isSoftware: boolean;
  /** How many pictures were drawn. */
  frames = 0;
  #renderer: WebGLRenderer;
  #host: HTMLElement;
  #painter: Painter;
  /** Where the card is software, what stands behind the picture. */
  #backdrop: Backdrop | undefined;
  #texts: TextLayer;
  #theme: Theme;
  #picker: Picker;
  #falseColours = new FalseColours(() => {
    this.#areColoursStale = true;
    this.invalidate();
  });
  #around: Surroundings;
  #settings: ViewportSettings;
  readonly #state: StoreApi<ViewportState>;
  #request = 0;
  #rest: ReturnType<typeof setTimeout> | undefined;
  #isFine = false;
  /** Whether the last picture left something for one that is drawn when all rests. */
  #isRough = false;
  /** Whether a picture was drawn before the frame that it belongs to. */
  #isHastened = false;
  #isLost = false;
  /** When the turntable was turned last. */
  #turned: number | undefined;
  /** Pixels of the canvas to one of the page, in fine pictures. */
  #ratio: number;
  #areLooksStale = true;
  #areColoursStale = true;
  /** Whether geometry was framed since the document came. */
  #isFramed = false;
  /** Whether what is shown, or the room for it, is other than when it was framed. */
  #isFramingStale = false;
  #stop: (() => void)[] = [];
  /** Called after each picture, for what is drawn over it. */
  afterDraw: (placed: readonly PlacedPane[]) => void = () => {};

  constructor(host: HTMLElement, around: Surroundings, options: Options = {}) {
    this.#host = host;
    this.#around = around;
    this.#settings = (options.settings ?? settingsStore).getState();
    this.#state = options.state ?? viewportStore;
    this.canvas = document.createElement("canvas");
    this.canvas.className = "viewport-canvas";
    host.prepend(this.canvas);
    this.isSoftware = isSoftware();
    const antialias = options.antialias ?? !this.isSoftware;
    const about = { canvas: this.canvas, antialias, alpha: this.isSoftware, powerPreference: "high-performance" } as const;
    this.#renderer = new WebGLRenderer(about);
    if (this.isSoftware) this.#backdrop = new Backdrop(this.canvas);
    this.#renderer.outputColorSpace = SRGBColorSpace;
    this.#renderer.autoClear = false;
    this.#renderer.sortObjects = true;
    this.#ratio = options.pixelRatio ?? Math.min(devicePixelRatio, 2);
    this.#renderer.setPixelRatio(this.#ratio);
    const weight = options.weight ?? 1;
    this.model = new Model(this.isSoftware ? SOFTWARE : CARD, () => this.#renderer.getPixelRatio() * weight);
    this.#painter = new Painter(this.#renderer, this.model);
    this.panes = new Panes(() => this.invalidate(), options.margin);
    this.#picker = new Picker(this.model);
    this.#texts = new TextLayer(host, options.textSize);
    this.#theme = readTheme(host);
    this.#watch(options);
  }

  put(object: string, preview: Preview): void {
    this.model.put(object, preview);
    this.#refresh();
    this.#hasten();
  }

  drop(object: string): void {
    this.model.drop(object);
    this.#refresh();
    this.#hasten();
  }

  clear(): void {
    this.clearWhere(isOfDocument);
    this.#isFramed = false;
    this.panes.letGo();
  }

  clearWhere(isMeant: (object: string) => boolean): void {
    for (const id of [...this.model.objects.keys()]) if (isMeant(id)) this.model.drop(id);
    this.#refresh();
  }

  surround(around: Surroundings): void {
    // Most of what is edited or pointed at leaves the picture as it is, and a picture in software costs much.
    if (areAlike(around, this.#around)) return;
    this.#around = around;
    this.#isFramingStale = true;
    this.#areLooksStale = true;
    this.invalidate();
  }

  /** Takes up other colours of the page. */
  retheme(): void {
    this.#theme = readTheme(this.#host);
    this.#backdrop?.forget();
    this.#areLooksStale = true;
    this.invalidate();
  }

  /** Asks for a new picture. */
  invalidate(): void {
    this.#isFine = false;
    this.#schedule();
  }

  /** What is at a place: of the document, or of the Rhino model too. */
  pickAt(x: number, y: number, withLayers = false): Pick | undefined {
    const placed = this.panes.at(x, y);
    this.#settle();
    return this.#picker.at(this.#view(placed), x - placed.left, y - placed.top, withLayers);
  }

  /** The point of what is shown that is nearest to a place, within so many pixels. */
  vertexAt(x: number, y: number, reach: number): Point3 | undefined {
    const placed = this.panes.at(x, y);
    this.#settle();
    return vertexAt(this.model, this.#view(placed), x - placed.left, y - placed.top, reach);
  }

  /** The objects in a window, whose corners are in pixels of the canvas. */
  inWindow([x, y, u, v]: readonly [number, number, number, number]): string[] {
    const { left, top, ...placed } = this.panes.at(x, y);
    this.#settle();
    const box = rectangle(x - left, y - top, u - left, v - top);
    return inWindow(this.model, this.#view({ left, top, ...placed }), box, u < x).filter(isOfDocument);
  }

  zoomExtents(isStill: boolean): void {
    this.#settle();
    this.panes.fit(this.#boxesWhere((id) => !isTool(id)), this.panes.layout === "one" ? [this.panes.active] : this.panes.all(), isStill);
  }

  zoomSelected(isStill: boolean): void {
    this.panes.fit(this.#boxes(this.#around.selection), [this.panes.active], isStill);
  }

  /** The box around what the document shows. */
  documentBounds(): Bounds | null {
    return this.#boxes().reduce<Bounds | null>(union, null);
  }

  /** The boxes of the objects that are shown, or of some of them. */
  #boxes(only?: ReadonlySet<string>): Bounds[] {
    return this.#boxesWhere((id) => isOfDocument(id) && (!only || only.has(id)));
  }

  #boxesWhere(isMeant: (id: string) => boolean): Bounds[] {
    const objects = [...this.model.objects.values()].filter(({ id }) => isMeant(id));
    return objects.flatMap(({ bounds, id }) => (bounds && !isHidden(this.#around, id) ? [bounds] : []));
  }

  /** The camera of a pane, and its size. */
  viewOf(placed: PlacedPane): PickView {
    return this.#view(placed);
  }

  /** Where a point of the model is on the canvas, in pixels; undefined behind the eye. */
  placeOf(point: readonly [number, number, number], placed = this.panes.placedOf(this.panes.active)): [number, number] | undefined {
    this.#settle();
    const { camera, width, height } = this.#view(placed);
    const [x, y, z] = this.model.origin;
    const seen = new Vector3(point[0] - x, point[1] - y, point[2] - z).applyMatrix4(camera.matrixWorldInverse);
    if (seen.z >= 0 && placed.pane.rig.pose.projection === "perspective") return undefined;
    seen.applyMatrix4(camera.projectionMatrix);
    return [placed.left + (seen.x + 1) * 0.5 * width, placed.top + (1 - seen.y) * 0.5 * height];
  }

  /** Draws at once. */
  draw(isFine = true): void {
    this.#draw(isFine, false);
  }

  /** Draws all of the picture on the canvas, for who takes it from there. */
  #draw(isFine: boolean, isWhole: boolean): void {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#isFine = isFine;
    this.#frame(isWhole);
  }

  /** The picture with its texts, as PNG. */
  picture(): Promise<Blob | null> {
    this.#draw(true, true);
    return pngOf(this.canvas, this.#texts, this.#renderer.getPixelRatio());
  }

  /** The picture with its texts, on another canvas. */
  paint(copy: HTMLCanvasElement): void {
    this.#draw(true, true);
    paintOn(copy, this.canvas, this.#texts, this.#renderer.getPixelRatio());
  }

  /** The colour of a pixel of the canvas as it would be drawn now. */
  pixel(x: number, y: number, isFine = true): Rgba {
    this.#draw(isFine, true);
    return this.read(x, y);
  }

  /** What is in a pixel just after drawing: nothing of what stands behind the canvas. Waits for the graphics card. */
  read(x: number, y: number): Rgba {
    return pixelOf(this.#renderer.getContext(), this.#renderer.getPixelRatio(), x, y);
  }

  /** How much memory of the graphics card is in use, in things. */
  memory(): { geometries: number; textures: number; isLost: boolean } {
    return { ...this.#renderer.info.memory, isLost: this.#isLost };
  }

  dispose(): void {
    // Nothing that is still to be drawn is drawn any more.
    this.#isLost = true;
    for (const stop of this.#stop) stop();
    cancelAnimationFrame(this.#request);
    clearTimeout(this.#rest);
    this.#texts.dispose();
    this.#falseColours.dispose();
    this.model.dispose();
    this.#painter.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
    this.canvas.remove();
    this.#backdrop?.element.remove();
  }

  #watch(options: Options): void {
    const resize = new ResizeObserver(() => this.#resize());
    resize.observe(this.#host);
    this.#resize();
    const ratio = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    const rescale = () => {
      this.#ratio = options.pixelRatio ?? Math.min(devicePixelRatio, 2);
      this.#renderer.setPixelRatio(this.#ratio);
      this.#resize();
    };
    ratio.addEventListener("change", rescale);
    const lost = (event: Event) => {
      event.preventDefault();
      this.#isLost = true;
      this.#state.setState({ notice: "viewport.lost" });
    };
    const restored = () => {
      this.#isLost = false;
      this.#painter.forget();
      this.#state.setState({ notice: undefined });
      this.invalidate();
    };
    this.canvas.addEventListener("webglcontextlost", lost);
    this.canvas.addEventListener("webglcontextrestored", restored);
    const unsubscribe = (options.settings ?? settingsStore).subscribe((settings, before) => this.#take(settings, before));
    this.panes.layout = this.#settings.layout;
    this.#stop.push(
      () => resize.disconnect(),
      () => ratio.removeEventListener("change", rescale),
      () => this.canvas.removeEventListener("webglcontextlost", lost),
      () => this.canvas.removeEventListener("webglcontextrestored", restored),
      unsubscribe,
    );
  }

  #take(settings: ViewportSettings, before: ViewportSettings): void {
    this.#settings = settings;
    this.#areLooksStale = true;
    if (settings.analysis !== before.analysis) this.#areColoursStale = true;
    if (settings.layout !== before.layout) {
      this.panes.layout = settings.layout;
      if (settings.layout === "four") this.panes.fit(this.#boxes(), this.panes.all().filter((pane) => pane !== this.panes.active), true);
    }
    this.invalidate();
  }

  #refresh(): void {
    this.#isFramingStale = true;
    this.#areLooksStale = true;
    this.#areColoursStale = true;
    this.invalidate();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#host;
    this.panes.width = Math.max(clientWidth, 1);
    this.panes.height = Math.max(clientHeight, 1);
    this.#renderer.setSize(this.panes.width, this.panes.height);
    this.#isFramingStale = true;
    this.invalidate();
  }

  #schedule(): void {
    if (this.#request === 0) this.#request = requestAnimationFrame((now) => this.#tick(now));
  }

  /**
   * Draws geometry as soon as all that came together is here, not when the page's next frame begins: the card then draws
   * while the page waits for that. What comes until then is drawn in it, as everything else.
   */
  #hasten(): void {
    if (this.#isHastened || this.panes.isFlying()) return;
    this.#isHastened = true;
    queueMicrotask(() => {
      cancelAnimationFrame(this.#request);
      this.#request = 0;
      this.#show();
      this.#renderer.getContext().flush();
      requestAnimationFrame(() => (this.#isHastened = false));
    });
  }

  #tick(now: number): void {
    this.#request = 0;
    if (this.panes.advance(now) || this.#turn(now)) this.#schedule();
    this.#show();
  }

  /** Turns the table as far as it has come since the picture before; whether it turns. */
  #turn(now: number): boolean {
    const { turntable } = this.#settings;
    if (turntable && this.#turned !== undefined) this.panes.turn(((now - this.#turned) / TURNTABLE) * 2 * Math.PI);
    this.#turned = turntable ? now : undefined;
    if (turntable) this.#isFine = false;
    return turntable;
  }

  #show(): void {
    this.#frame(false);
    clearTimeout(this.#rest);
    if (!this.#isFine && this.#isRough) this.#rest = setTimeout(() => this.draw(), REST);
  }

  #isHeavy(): boolean {
    const { triangles, segments, points } = this.model.counts();
    // Software takes its time for the light of a rendered picture, however small the model.
    return this.isSoftware && (this.#settings.mode === "rendered" || triangles + segments + points > HEAVY);
  }

  /** Batches, looks and false colours as they are to be now. */
  #settle(): void {
    this.model.settle();
    if (this.#areLooksStale) dress(this.model, this.#around, this.#settings, this.#theme);
    this.#areLooksStale = false;
    if (this.#areColoursStale) this.#colour();
    this.model.settle();
    const { isOn, normal, at } = this.#settings.section;
    this.model.section = isOn ? { normal, at: placeOf(at, normal, this.documentBounds()) } : undefined;
    this.#frameFreely();
  }

  /** Until a hand takes the camera, what is shown stays in the picture: the first geometry, and what comes later. */
  #frameFreely(): void {
    if (!this.#isFramingStale) return;
    this.#isFramingStale = false;
    const own = this.#boxes();
    const isEmpty = own.length === 0;
    if (this.#state.getState().isEmpty !== isEmpty) this.#state.setState({ isEmpty });
    // A Rhino model is looked at where the document shows nothing itself.
    const boxes = isEmpty ? this.#boxesWhere((id) => !isTool(id)) : own;
    if (boxes.length === 0) return;
    if (this.#isFramed) return this.panes.frame(boxes, true);
    this.#isFramed = true;
    this.panes.fit(boxes, this.panes.all(), true);
  }

  #colour(): void {
    this.#areColoursStale = false;
    this.#state.setState({ legend: this.#falseColours.colour(this.model, this.#settings.analysis) });
  }

  #frame(isWhole: boolean): void {
    if (this.#isLost) return;
    this.#settle();
    const range = this.#settings.range ?? this.#state.getState().legend?.range;
    const isQuick = !this.#isFine && this.#isHeavy();
    const ratio = this.#ratio * (isQuick ? QUICK_SHARE : 1);
    if (this.#renderer.getPixelRatio() !== ratio) this.#renderer.setPixelRatio(ratio);
    this.#painter.prepare(this.#settings, this.#theme, range, isQuick);
    const placed = this.panes.placed();
    const layer = isWhole ? "all" : this.#layer(placed);
    const isGroundMisplaced = layer === "model" && this.#painter.isGroundBetween();
    this.#isRough = isQuick || isGroundMisplaced || (layer === "all" && this.#backdrop !== undefined);
    this.#paint(placed, layer);
    this.frames++;
    this.#overlay(placed);
  }

  #paint(placed: readonly PlacedPane[], layer: Layer): void {
    for (const pane of placed) this.#painter.paint(pane, this.#view(pane).camera, this.panes.height, layer);
  }

  /** What must be drawn of a picture: the model alone where the backdrop has the rest, or can have it from now on. */
  #layer(placed: readonly PlacedPane[]): Layer {
    if (!this.#backdrop || (this.#isFine && this.#painter.isGroundBetween())) return "all";
    const place = [placeOfPanes(placed), this.#painter.groundLook(), this.canvas.width, this.canvas.height].join();
    if (this.#backdrop.serves(place)) return "model";
    if (!this.#backdrop.rests(place)) return "all";
    this.#paint(placed, "ground");
    this.#backdrop.take(this.canvas, place);
    return "model";
  }

  #view({ pane, width, height }: PlacedPane): PickView {
    return { camera: pane.rig.camera(this.model.origin, this.model.bounds, width / height), width, height };
  }

  #overlay(placed: readonly PlacedPane[]): void {
    const views = placed.map((pane) => ({ ...pane, ...this.#view(pane) }));
    const now = { view: this.panes.viewName(), projection: this.panes.projection(), texts: this.#texts.show(this.model, views) };
    const { view, projection, texts } = this.#state.getState();
    // Whoever reads this is not called for pictures that only show other geometry.
    const isSame = now.view === view && now.projection === projection && now.texts.all === texts.all && now.texts.shown === texts.shown;
    if (!isSame) this.#state.setState(now);
    this.afterDraw(placed);
  }
}
