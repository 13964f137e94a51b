// The picture of a toolpath: three.js, drawn only when something changes. It asks the server for nothing and has no
// words; labels of axes and scale are elements over the canvas that it moves.
import { BufferAttribute, BufferGeometry, Group, LineSegments, Matrix4, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { spotOf, type PathPlace } from './clock';
import { rangesOf, valuesOf, type ColorBy } from './color';
import { at, boundsOf, rapidLengths, roundLength, stretchesOf, unionOf, type Bounds, type PathData } from './data';
import { detailFor, detailsOf, kMovingLimits, movingDetail, MovingPace, type Detail } from './detail';
import { Eye, type ViewName } from './eye';
import { colorSegments, rgbOf, segmentMaterial, type Colors } from './look';
import { axisLines, colorMarks, markedLines, toolMark, type Marks } from './marks';
import { Measure, type Spot } from './measure';
import { nearestSegment, type ToPixels } from './pick';
import { stockBounds, type Stock } from './stock';
import { StockView, type Section } from './stock_view';
import { colorTool, toolModel, type ToolModel } from './tool_model';
import type { ToolShape } from './tool_shape';

export interface SceneOptions {
  host: HTMLElement; // gets the canvas
  axisLabels: readonly [HTMLElement, HTMLElement, HTMLElement];
  scaleBar: HTMLElement;
  scaled: (length_mm: number) => void; // the bar's length now
  drew: (segments: number, all: number) => void; // so many of all, just now
  picked: (point: number) => void;
  measured: (spots: readonly Spot[]) => void;
}

export interface PathScene {
  show: (data: PathData, isLathe: boolean) => void;
  color: (colors: Colors) => void;
  colorBy: (by: ColorBy) => void;
  place: (place: PathPlace | null) => void; // the tool is there; null: the whole path is shown
  tool: (shape: ToolShape | null) => void; // null: it is not known, and a mark stands for it
  stock: (stock: Stock | null) => void;
  compare: (is: boolean) => void; // the stock is coloured against its nominal
  section: (section: Section | null) => void;
  measuring: (is: boolean) => void; // clicks measure, and pick nothing
  measureTool: () => void; // as a click on the tool's place
  mark: (line: number) => void; // its segments stand out; 0: none
  look: (from: ViewName) => void;
  turn: (right: number, up: number) => void; // radians
  move: (right: number, up: number) => void; // shares of the picture
  zoom: (factor: number) => void;
  close: () => void;
}

// From a program's x y z to the picture's: right, up, towards the eye. A mill's z is up; a lathe's x is up and its z to
// the right, as in a turning drawing.
const kMill = new Matrix4().set(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
const kLathe = new Matrix4().set(0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1);

const kNoRange = [1, 0] as const;
const kPick_px = 12;
const kRest_ms = 180;
const kScale_px = 140;

class Picture implements PathScene {
  private readonly renderer = new WebGLRenderer({ antialias: true });
  private readonly scene = new Scene();
  private readonly root = new Group();
  private readonly material = segmentMaterial();
  private readonly segments = new LineSegments(new BufferGeometry(), this.material);
  private readonly marks: Marks = { axes: axisLines(), line: markedLines(), tool: toolMark() };
  private readonly eye: Eye;
  private readonly sizes: ResizeObserver;
  private readonly measure = new Measure();
  private from: ViewName = 'iso'; // was looked at last
  private isMeasuring = false;
  private stock_: StockView | null = null;
  private isCompared = false;
  private cut: Section | null = null;
  private moment = Infinity;
  private tool_: ToolModel | null = null;
  private colors: Colors | null = null;
  private by: ColorBy = 'kind';
  private data: PathData | null = null;
  private bounds: Bounds = { low: [0, 0, 0], high: [0, 0, 0], size: 1 };
  private details: Detail[] = [];
  private moving: (Detail | undefined)[] = []; // by the pace's level
  private readonly pace = new MovingPace();
  private drawnAt_ms = 0;
  private indexes = new Map<Detail, BufferAttribute>();
  private rest: ReturnType<typeof setTimeout> | undefined;
  private isMoving = false;
  private frame = 0;
  private last = 0; // point up to which the path is shown
  private pressed = new Vector2();

  constructor(private readonly options: SceneOptions) {
    const canvas = this.renderer.domElement;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    options.host.append(canvas);
    canvas.setAttribute('aria-hidden', 'true'); // its host has the words
    this.segments.frustumCulled = false;
    this.root.matrixAutoUpdate = false;
    this.root.add(this.segments, this.marks.axes, this.marks.line, this.marks.tool, this.measure.group);
    this.scene.add(this.root);
    this.eye = new Eye(canvas, () => this.changed(true));
    canvas.addEventListener('pointerdown', (event) => this.pressed.set(event.clientX, event.clientY));
    canvas.addEventListener('click', (event) => this.pick(event));
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(options.host);
    this.resize();
  }

  show(data: PathData, isLathe: boolean): void {
    const isFirst = this.data === null;
    this.data = data;
    this.last = data.count - 1;
    this.bounds = boundsOf(data);
    this.root.matrix.copy(isLathe ? kLathe : kMill);
    this.root.matrixWorldNeedsUpdate = true;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(data.points, 3));
    geometry.setAttribute('kind', new BufferAttribute(data.kinds, 1));
    geometry.setAttribute('along', new BufferAttribute(rapidLengths(data), 1));
    this.segments.geometry.dispose();
    this.segments.geometry = geometry;
    this.indexes = new Map();
    this.details = detailsOf(data, this.bounds.size);
    this.moving = [];
    this.colorBy(this.by);
    this.mark(0);
    this.place(null);
    if (isFirst) this.look(isLathe ? 'turning' : 'iso');
    else this.changed();
  }

  color(colors: Colors): void {
    const ground = rgbOf(colors.ground);
    this.renderer.setClearColor(((ground.x * 255) << 16) + ((ground.y * 255) << 8) + ground.z * 255, 1);
    this.colors = colors;
    colorSegments(this.material, colors, this.by);
    colorMarks(this.marks, colors);
    this.measure.color(colors);
    this.stock_?.color(colors);
    if (this.tool_) colorTool(this.tool_, colors);
    this.changed();
  }

  colorBy(by: ColorBy): void {
    const { data } = this;
    this.by = by;
    if (this.colors) colorSegments(this.material, this.colors, by);
    this.uniform('scale', by === 'kind' ? 0 : 1);
    if (data) {
      this.segments.geometry.setAttribute('value', new BufferAttribute(valuesOf(data, by), 1));
      const ranges = rangesOf(data, by);
      (this.material.uniforms['ranges']?.value as Vector2[]).forEach((range, kind) => range.set(...(ranges.get(kind) ?? kNoRange)));
    }
    this.changed();
  }

  place(place: PathPlace | null): void {
    const { data } = this;
    this.last = place?.point ?? (data ? data.count - 1 : 0);
    // What the tool has not done yet is drawn fainter, the segment that it is on as well.
    this.uniform('to', place ? place.point - (place.share < 1 ? 1 : 0) : -1);
    this.moment = place ? place.point - 1 + place.share : Infinity;
    this.stock_?.goTo(this.moment);
    const isThere = place !== null && data !== null;
    this.marks.tool.visible = isThere;
    if (this.tool_) this.tool_.visible = isThere;
    if (isThere) {
      const spot = spotOf(data, place);
      this.marks.tool.position.set(...spot);
      this.tool_?.position.set(...spot);
    }
    this.changed();
  }

  tool(shape: ToolShape | null): void {
    if (this.tool_) this.root.remove(this.tool_);
    this.tool_ = shape && toolModel(shape);
    if (this.tool_) {
      if (this.colors) colorTool(this.tool_, this.colors);
      this.tool_.visible = this.marks.tool.visible;
      this.tool_.position.copy(this.marks.tool.position);
      this.root.add(this.tool_);
    }
    this.changed();
  }

  stock(stock: Stock | null): void {
    if (this.stock_) this.root.remove(this.stock_.group);
    this.stock_?.close();
    this.stock_ = stock && new StockView(stock);
    const path = this.data ? boundsOf(this.data) : this.bounds;
    this.bounds = stock ? unionOf(path, stockBounds(stock)) : path;
    if (this.stock_) {
      this.stock_.compare(this.isCompared);
      this.stock_.cut(this.cut);
      this.stock_.goTo(this.moment);
      if (this.colors) this.stock_.color(this.colors);
      this.root.add(this.stock_.group);
    }
    this.look(this.from);
  }

  compare(is: boolean): void {
    this.isCompared = is;
    this.stock_?.compare(is);
    this.changed();
  }

  section(section: Section | null): void {
    this.cut = section;
    this.stock_?.cut(section);
    this.changed();
  }

  measuring(is: boolean): void {
    this.isMeasuring = is;
    this.measure.clear();
    this.options.measured([]);
    this.changed();
  }

  measureTool(): void {
    this.addMeasured(this.marks.tool.visible ? this.marks.tool.position : this.spotOf(this.last));
  }

  mark(line: number): void {
    const { data } = this;
    const ends: number[] = [];
    for (const { first, last } of data ? stretchesOf(data, line) : [])
      for (let i = first; i <= last; i += 1) ends.push(...Array.from({ length: 6 }, (_, k) => at(data?.points ?? new Float32Array(), 3 * (i - 1) + k)));
    this.marks.line.visible = ends.length > 0;
    if (ends.length > 0) {
      this.marks.line.geometry.dispose();
      this.marks.line.geometry = markedLines(ends).geometry;
    }
    this.changed();
  }

  look(from: ViewName): void {
    this.from = from;
    this.eye.look(from, this.bounds, this.root.matrix);
    this.changed();
  }

  turn(right: number, up: number): void {
    this.eye.turn(right, up);
    this.changed(true);
  }

  move(right: number, up: number): void {
    this.eye.move(right, up);
    this.changed(true);
  }

  zoom(factor: number): void {
    this.eye.zoom(factor);
    this.changed(true);
  }

  close(): void {
    clearTimeout(this.rest);
    cancelAnimationFrame(this.frame);
    this.sizes.disconnect();
    this.eye.close();
    this.segments.geometry.dispose();
    this.material.dispose();
    this.stock_?.close();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  private uniform(name: string, value: unknown): void {
    const uniform = this.material.uniforms[name];
    if (uniform) uniform.value = value;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.options.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, true);
    this.eye.resize(clientWidth, clientHeight);
    this.changed();
  }

  // Draws once, soon. While the view moves, coarser; once it rests, all of it.
  private changed(moves = false): void {
    if (moves) {
      this.isMoving = true;
      clearTimeout(this.rest);
      this.rest = setTimeout(() => {
        this.isMoving = false;
        this.pace.rest();
        this.changed();
      }, kRest_ms);
    }
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(): void {
    const now_ms = performance.now();
    if (this.isMoving) this.pace.note(now_ms - this.drawnAt_ms);
    this.drawnAt_ms = now_ms;
    const pixel = this.eye.mmOfPixel();
    const detail = this.isMoving ? this.movingDetail() : detailFor(this.details, pixel / this.renderer.getPixelRatio());
    if (detail) this.choose(detail);
    this.uniform('pixelsOfMm', 1 / pixel);
    this.renderer.render(this.scene, this.eye.camera);
    this.label(pixel);
    const all = this.details[0]?.pairs.length ?? 0;
    this.options.drew((detail?.pairs.length ?? 0) / 2, all / 2);
  }

  private movingDetail(): Detail | undefined {
    const { level } = this.pace;
    if (this.data) this.moving[level] ??= movingDetail(this.data, this.details, this.bounds.size, kMovingLimits[level]);
    return this.moving[level];
  }

  private choose(detail: Detail): void {
    let index = this.indexes.get(detail);
    if (!index) this.indexes.set(detail, (index = new BufferAttribute(detail.pairs, 1)));
    if (this.segments.geometry.getIndex() !== index) this.segments.geometry.setIndex(index);
  }

  private label(pixel: number): void {
    const { x: width, y: height } = this.renderer.getSize(new Vector2());
    const length = 0.16 * this.bounds.size;
    this.marks.axes.scale.setScalar(length);
    this.options.axisLabels.forEach((label, axis) => {
      const end = new Vector3().setComponent(axis, 1.15 * length).applyMatrix4(this.root.matrix).project(this.eye.camera);
      const isIn = Math.abs(end.x) < 1 && Math.abs(end.y) < 1;
      const begin = new Vector3().project(this.eye.camera);
      const isSeen = Math.hypot((end.x - begin.x) * width, (end.y - begin.y) * height) > 24;
      label.hidden = !isIn || !isSeen;
      label.style.transform = `translate(${((end.x + 1) / 2) * width}px, ${((1 - end.y) / 2) * height}px) translate(-50%, -50%)`;
    });
    const bar = roundLength(kScale_px * pixel);
    this.options.scaleBar.style.width = `${bar / pixel}px`;
    this.options.scaled(bar);
  }

  // A click, no drag: of the path that is shown.
  private pick(event: MouseEvent): void {
    if (!this.data || Math.hypot(event.clientX - this.pressed.x, event.clientY - this.pressed.y) > 5) return;
    const box = this.renderer.domElement.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const found = nearestSegment(this.data, this.toPixels(), x, y, kPick_px, this.last);
    if (!this.isMeasuring) {
      if (found !== null) this.options.picked(found);
      return;
    }
    const onStock = this.stock_?.under(new Vector2((2 * x) / box.width - 1, 1 - (2 * y) / box.height), this.eye.camera);
    const spot = onStock ?? (found === null ? null : this.spotOf(found));
    if (spot) this.addMeasured(spot);
  }

  private spotOf(point: number): Vector3 {
    return new Vector3(...[0, 1, 2].map((axis) => at(this.data?.points ?? new Float32Array(), 3 * point + axis)));
  }

  private addMeasured(spot: Vector3): void {
    this.options.measured(this.measure.add(spot));
    this.changed();
  }

  private toPixels(): ToPixels {
    const { x, y } = this.renderer.getSize(new Vector2());
    const all = new Matrix4().multiplyMatrices(this.eye.camera.projectionMatrix, this.eye.camera.matrixWorldInverse).multiply(this.root.matrix);
    const e = all.elements; // by columns
    const of = (row: number, column: number): number => e[4 * column + row] ?? 0;
    const half = [x / 2, -y / 2] as const;
    return [
      half[0] * of(0, 0), half[0] * of(0, 1), half[0] * of(0, 2), half[0] * (of(0, 3) + 1),
      half[1] * of(1, 0), half[1] * of(1, 1), half[1] * of(1, 2), half[1] * (of(1, 3) - 1),
    ];
  }
}

export const openScene = (options: SceneOptions): PathScene => new Picture(options);
