// From where the picture is looked at: a camera without perspective, turned and moved by mouse, touch and keys.
import { OrthographicCamera, Vector3, type Matrix4 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Bounds } from './data';

export type ViewName = 'turning' | 'top' | 'front' | 'side' | 'iso';

const kEyes: Record<ViewName, [number, number, number]> = {
  turning: [0, 0, 1],
  top: [0, 1, 1e-4],
  front: [0, 0, 1],
  side: [1, 0, 0],
  iso: [0.7, 0.6, 0.9],
};

const kMargin = 1.15;

export class Eye {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
  private readonly controls: OrbitControls;
  private width = 1;
  private height = 1;

  constructor(canvas: HTMLElement, moved: () => void) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', moved);
  }

  resize(width: number, height: number): void {
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
    this.keepShape();
  }

  // `root` leads from the program's coordinates to the picture's.
  look(from: ViewName, { low, high, size }: Bounds, root: Matrix4): void {
    const center = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5).applyMatrix4(root);
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(new Vector3(...kEyes[from]).normalize(), 2 * size);
    this.camera.near = 0.01 * size;
    this.camera.far = 4 * size;
    this.camera.zoom = 1;
    this.camera.lookAt(center);
    this.camera.updateMatrixWorld();
    this.fit({ low, high, size }, root);
    this.controls.update();
  }

  // Radians.
  turn(right: number, up: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const length = offset.length();
    const around = Math.atan2(offset.x, offset.z) + right;
    const above = Math.min(Math.max(Math.acos(Math.min(Math.max(offset.y / length, -1), 1)) - up, 1e-4), Math.PI - 1e-4);
    offset.setFromSphericalCoords(length, above, around);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  // Shares of the picture.
  move(right: number, up: number): void {
    const { left, right: edge, top, bottom, zoom } = this.camera;
    const by = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar((right * (edge - left)) / zoom);
    by.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), (up * (top - bottom)) / zoom);
    this.camera.position.add(by);
    this.controls.target.add(by);
    this.controls.update();
  }

  zoom(factor: number): void {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.05), 1e5);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  mmOfPixel(): number {
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / this.height;
  }

  close(): void {
    this.controls.dispose();
  }

  // All of it is in the picture as it is looked at now.
  private fit({ low, high, size }: Bounds, root: Matrix4): void {
    let wide = 0;
    let tall = 0;
    const corner = new Vector3();
    for (let i = 0; i < 8; i += 1) {
      corner.set((i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2]).applyMatrix4(root);
      corner.applyMatrix4(this.camera.matrixWorldInverse);
      wide = Math.max(wide, Math.abs(corner.x));
      tall = Math.max(tall, Math.abs(corner.y));
    }
    const half = kMargin * Math.max(tall, (wide * this.height) / this.width, 1e-3 * size);
    this.camera.top = half;
    this.camera.bottom = -half;
    this.keepShape();
  }

  private keepShape(): void {
    this.camera.right = (this.camera.top * this.width) / this.height;
    this.camera.left = -this.camera.right;
    this.camera.updateProjectionMatrix();
  }
}
