// The picture of a toolpath: three.js, drawn only when something changes. It asks the server for nothing and has no
// words; labels of axes and scale are elements over the canvas that it moves.
import { BufferAttribute, BufferGeometry, Group, LineSegments, Matrix4, OrthographicCamera, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { at, boundsOf, feedRanges, rapidLengths, roundLength, stretchesOf, type Bounds, type PathData } from './data';
import { detailFor, detailsOf, movingDetail, type Detail } from './detail';
import { colorSegments, rgbOf, segmentMaterial, type Colors } from './look';
import { axisLines, colorMarks, markedLines, toolMark, type Marks } from './marks';
import { nearestSegment, type ToPixels } from './pick';

export type ViewName = 'turning' | 'top' | 'front' | 'side' | 'iso';

export interface SceneOptions {
  host: HTMLElement; // gets the canvas
  axisLabels: readonly [HTMLElement, HTMLElement, HTMLElement];
  scaleBar: HTMLElement;
  scaled: (length_mm: number) => void; // the bar's length now
  picked: (point: number) => void;
}

export interface PathScene {
  show: (data: PathData, isLathe: boolean) => void;
  color: (colors: Colors) => void;
  colorByFeed: (is: boolean) => void;
  place: (point: number | null) => void; // the tool is there; null: the whole path is shown
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

const kEyes: Record<ViewName, [number, number, number]> = {
  turning: [0, 0, 1],
  top: [0, 1, 1e-4],
  front: [0, 0, 1],
  side: [1, 0, 0],
  iso: [0.7, 0.6, 0.9],
};

const kPick_px = 12;
const kMargin = 1.15;
const kRest_ms = 180;
const kScale_px = 140;

class Picture implements PathScene {
  private readonly renderer = new WebGLRenderer({ antialias: true });
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
  private readonly scene = new Scene();
  private readonly root = new Group();
  private readonly material = segmentMaterial();
  private readonly segments = new LineSegments(new BufferGeometry(), this.material);
  private readonly marks: Marks = { axes: axisLines(), line: markedLines(), tool: toolMark() };
  private readonly controls: OrbitControls;
  private readonly sizes: ResizeObserver;
  private data: PathData | null = null;
  private bounds: Bounds = { low: [0, 0, 0], high: [0, 0, 0], size: 1 };
  private center = new Vector3(); // of the bounds, in the picture
  private details: Detail[] = [];
  private moving: Detail | null = null;
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
    this.root.add(this.segments, this.marks.axes, this.marks.line, this.marks.tool);
    this.scene.add(this.root);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.changed(true));
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
    geometry.setAttribute('feed', new BufferAttribute(data.feeds, 1));
    geometry.setAttribute('along', new BufferAttribute(rapidLengths(data), 1));
    this.segments.geometry.dispose();
    this.segments.geometry = geometry;
    this.indexes = new Map();
    this.details = detailsOf(data, this.bounds.size);
    this.moving = movingDetail(data, this.details, this.bounds.size);
    const ranges = feedRanges(data);
    (this.material.uniforms['ranges']?.value as Vector2[]).forEach((range, kind) => range.set(...(ranges.get(kind) ?? [0, 0])));
    const { low, high } = this.bounds;
    this.center.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2).applyMatrix4(this.root.matrix);
    this.mark(0);
    this.place(null);
    if (isFirst) this.look(isLathe ? 'turning' : 'iso');
    else this.changed();
  }

  color(colors: Colors): void {
    const ground = rgbOf(colors.ground);
    this.renderer.setClearColor(((ground.x * 255) << 16) + ((ground.y * 255) << 8) + ground.z * 255, 1);
    colorSegments(this.material, colors);
    colorMarks(this.marks, colors);
    this.changed();
  }

  colorByFeed(is: boolean): void {
    this.uniform('byFeed', is ? 1 : 0);
    this.changed();
  }

  place(point: number | null): void {
    const { data } = this;
    this.last = point ?? (data ? data.count - 1 : 0);
    this.uniform('to', point ?? -1);
    this.marks.tool.visible = point !== null && data !== null;
    if (data && point !== null) this.marks.tool.position.set(at(data.points, 3 * point), at(data.points, 3 * point + 1), at(data.points, 3 * point + 2));
    this.changed();
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
    const eye = new Vector3(...kEyes[from]).normalize();
    this.controls.target.copy(this.center);
    this.camera.position.copy(this.center).addScaledVector(eye, 2 * this.bounds.size);
    this.camera.near = 0.01 * this.bounds.size;
    this.camera.far = 4 * this.bounds.size;
    this.camera.zoom = 1;
    this.camera.lookAt(this.center);
    this.camera.updateMatrixWorld();
    this.fit();
    this.controls.update();
    this.changed();
  }

  turn(right: number, up: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const length = offset.length();
    const around = Math.atan2(offset.x, offset.z) + right;
    const above = Math.min(Math.max(Math.acos(Math.min(Math.max(offset.y / length, -1), 1)) - up, 1e-4), Math.PI - 1e-4);
    offset.setFromSphericalCoords(length, above, around);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.changed(true);
  }

  move(right: number, up: number): void {
    const { left, right: edge, top, bottom, zoom } = this.camera;
    const by = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar((right * (edge - left)) / zoom);
    by.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), (up * (top - bottom)) / zoom);
    this.camera.position.add(by);
    this.controls.target.add(by);
    this.controls.update();
    this.changed(true);
  }

  zoom(factor: number): void {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.05), 1e5);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.changed(true);
  }

  close(): void {
    clearTimeout(this.rest);
    cancelAnimationFrame(this.frame);
    this.sizes.disconnect();
    this.controls.dispose();
    this.segments.geometry.dispose();
    this.material.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  private uniform(name: string, value: unknown): void {
    const uniform = this.material.uniforms[name];
    if (uniform) uniform.value = value;
  }

  // All of the path is in the picture as it is looked at now.
  private fit(): void {
    const { low, high } = this.bounds;
    let wide = 0;
    let tall = 0;
    const corner = new Vector3();
    for (let i = 0; i < 8; i += 1) {
      corner.set((i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2]).applyMatrix4(this.root.matrix);
      corner.applyMatrix4(this.camera.matrixWorldInverse);
      wide = Math.max(wide, Math.abs(corner.x));
      tall = Math.max(tall, Math.abs(corner.y));
    }
    const { x, y } = this.renderer.getSize(new Vector2());
    const half = kMargin * Math.max(tall, (wide * y) / Math.max(x, 1), 1e-3 * this.bounds.size);
    this.camera.top = half;
    this.camera.bottom = -half;
    this.keepShape();
  }

  private keepShape(): void {
    const { x, y } = this.renderer.getSize(new Vector2());
    this.camera.right = (this.camera.top * x) / Math.max(y, 1);
    this.camera.left = -this.camera.right;
    this.camera.updateProjectionMatrix();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.options.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, true);
    this.keepShape();
    this.changed();
  }

  // Draws once, soon. While the view moves, coarser; once it rests, all of it.
  private changed(moves = false): void {
    if (moves) {
      this.isMoving = true;
      clearTimeout(this.rest);
      this.rest = setTimeout(() => {
        this.isMoving = false;
        this.changed();
      }, kRest_ms);
    }
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private mmOfPixel(): number {
    const { y } = this.renderer.getSize(new Vector2());
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / Math.max(y, 1);
  }

  private draw(): void {
    const pixel = this.mmOfPixel();
    const detail = (this.isMoving && this.moving) || detailFor(this.details, pixel / this.renderer.getPixelRatio());
    if (detail) this.choose(detail);
    this.uniform('pixelsOfMm', 1 / pixel);
    this.renderer.render(this.scene, this.camera);
    this.label(pixel);
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
      const end = new Vector3().setComponent(axis, 1.15 * length).applyMatrix4(this.root.matrix).project(this.camera);
      const isIn = Math.abs(end.x) < 1 && Math.abs(end.y) < 1;
      const begin = new Vector3().project(this.camera);
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
    const found = nearestSegment(this.data, this.toPixels(), event.clientX - box.left, event.clientY - box.top, kPick_px, this.last);
    if (found !== null) this.options.picked(found);
  }

  private toPixels(): ToPixels {
    const { x, y } = this.renderer.getSize(new Vector2());
    const all = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).multiply(this.root.matrix);
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
