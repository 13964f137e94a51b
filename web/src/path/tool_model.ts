// The tool at its tip, as far as the machine's profile has it: a mill's cutter up to the gauge line, a turning tool's nose.
// Units are millimetres of the program; holder and insert are in no profile, and are not drawn.
import { CylinderGeometry, DoubleSide, Group, LatheGeometry, Mesh, MeshBasicMaterial, TorusGeometry, Vector2 } from 'three';
import type { Colors } from './look';
import { isDrawn, noseCenter, sideOf, type ToolShape } from './tool_shape';

export type ToolModel = Group & { children: Mesh<LatheGeometry | CylinderGeometry | TorusGeometry, MeshBasicMaterial>[] };

const kAround = 40;
const solid = (opacity: number) => new MeshBasicMaterial({ transparent: true, opacity, side: DoubleSide, depthWrite: false });

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
    return group;
  }
  const body = new Mesh(new LatheGeometry(sideOf(shape).map(([radius, height]) => new Vector2(radius, height)), kAround), solid(0.55));
  body.rotation.x = Math.PI / 2; // its axis is the program's z
  group.add(body);
  if (shape.length_mm !== null) {
    const radius = (shape.diameter_mm ?? 0) / 2;
    const ring = new Mesh(new TorusGeometry(1.6 * radius, radius / 10, 8, kAround), solid(0.9));
    ring.position.z = shape.length_mm;
    group.add(ring);
  }
  return group;
}

export function colorTool(model: ToolModel, colors: Colors): void {
  for (const { material } of model.children) material.color.set(colors.tool);
}
