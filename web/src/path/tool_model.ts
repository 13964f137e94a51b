// The tool at its tip, as far as the machine's profile has it: a mill's cutter with shank and holder up to the gauge line, a
// turning tool's nose and insert. Units are millimetres of the program. Shanks of turning tools are in no profile.
import { type BufferGeometry, CylinderGeometry, DoubleSide, Group, LatheGeometry, Mesh, MeshBasicMaterial, Shape, ShapeGeometry, TorusGeometry, Vector2 } from 'three';
import type { Colors } from './look';
import { holderSideOf, insertSides, isDrawn, noseCenter, sideOf, type ToolShape } from './tool_shape';

export type ToolModel = Group & { children: Mesh<BufferGeometry, MeshBasicMaterial>[] };

const kAround = 40;
const solid = (opacity: number) => new MeshBasicMaterial({ transparent: true, opacity, side: DoubleSide, depthWrite: false });

// A body around the program's z with this side.
function turned(side: readonly [radius: number, height: number][], opacity: number): ToolModel['children'][number] {
  const body = new Mesh(new LatheGeometry(side.map(([radius, height]) => new Vector2(radius, height)), kAround), solid(opacity));
  body.rotation.x = Math.PI / 2;
  return body;
}

export function toolModel(shape: ToolShape): ToolModel | null {
  if (!isDrawn(shape)) return null;
  const group = new Group() as ToolModel;
  group.renderOrder = 2;
  if (shape.isLathe) {
    // A disc in the plane of x and z.
    const disc = new Mesh(new CylinderGeometry(shape.nose_radius_mm, shape.nose_radius_mm, shape.nose_radius_mm / 10, kAround), solid(0.9));
    const [x, z] = noseCenter(shape);
    disc.position.set(x, 0, z);
    group.add(disc);
    const sides = insertSides(shape);
    if (sides.length > 0) {
      // A shape lies in x and y: turned so that its y is the program's z.
      const insert = new Mesh(new ShapeGeometry(new Shape(sides.map(([across, along]) => new Vector2(across, along)))), solid(0.55));
      insert.rotation.x = Math.PI / 2;
      group.add(insert);
    }
    return group;
  }
  group.add(turned(sideOf(shape), 0.55));
  if (shape.holder.length > 0) group.add(turned(holderSideOf(shape), 0.3));
  if (shape.length_mm !== null) {
    const widest = Math.max(shape.diameter_mm ?? 0, ...shape.holder.map(({ diameter_mm }) => diameter_mm));
    const ring = new Mesh(new TorusGeometry(0.8 * widest, widest / 20, 8, kAround), solid(0.9));
    ring.position.z = shape.length_mm;
    group.add(ring);
  }
  return group;
}

export function colorTool(model: ToolModel, colors: Colors): void {
  for (const { material } of model.children) material.color.set(colors.tool);
}
