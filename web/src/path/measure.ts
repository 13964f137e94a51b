// Two places of the picture and the line between them.
import { BufferAttribute, BufferGeometry, Color, Group, Points, PointsMaterial, type Vector3 } from 'three';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import type { Colors } from './look';
import { markedLines } from './marks';

export type Spot = readonly [x: number, y: number, z: number];

const kMark_px = 9;

export class Measure {
  readonly group = new Group();
  private spots: Spot[] = [];
  private readonly ends: Points<BufferGeometry, PointsMaterial>;
  private readonly line: LineSegments2;

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    this.ends = new Points(geometry, new PointsMaterial({ size: kMark_px * Math.min(devicePixelRatio, 2), sizeAttenuation: false, depthTest: false }));
    this.ends.frustumCulled = false;
    this.ends.renderOrder = 4;
    this.line = markedLines();
    this.line.renderOrder = 4;
    this.group.add(this.ends, this.line);
    this.show();
  }

  // A third one begins again.
  add({ x, y, z }: Vector3): readonly Spot[] {
    this.spots = [...(this.spots.length < 2 ? this.spots : []), [x, y, z]];
    this.show();
    return this.spots;
  }

  clear(): void {
    this.spots = [];
    this.show();
  }

  color(colors: Colors): void {
    this.ends.material.color = new Color(colors.measure);
    this.line.material.color = new Color(colors.measure);
  }

  private show(): void {
    const [first, second = first] = this.spots;
    this.group.visible = first !== undefined;
    if (!first || !second) return;
    (this.ends.geometry.getAttribute('position') as BufferAttribute).set([...first, ...second]).needsUpdate = true;
    this.line.geometry.dispose();
    this.line.geometry = markedLines([...first, ...second]).geometry;
  }
}
