// The stock in the picture: its surface, lit from the eye, cut open by a plane, coloured against the nominal.
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Group, Mesh, Raycaster, ShaderMaterial, Sphere, Vector3, Vector4, type Vector2, type Camera } from 'three';
import { rgbOf, type Colors } from './look';
import { overNominal, stateOf, type Stock, type StockState } from './stock';
import { meshOf, type StockMesh } from './stock_mesh';

// What lies nearer to who looks from the oblique side is left out: axis 0 to 2, and the place along it.
export interface Section {
  axis: number;
  at_mm: number;
}

const kVertex = `
in float gone;
in float over;
uniform float flatAt;
uniform int isFlat;
out float isGone;
out float above;
out float isKnown;
out vec3 program;
out vec3 seen;
void main() {
  program = vec3(position.xy, isFlat == 1 ? flatAt : position.z);
  isGone = gone;
  isKnown = over > -1e29 ? 1.0 : 0.0;
  above = over > -1e29 ? over : 0.0;
  vec4 inView = modelViewMatrix * vec4(program, 1.0);
  seen = inView.xyz;
  gl_Position = projectionMatrix * inView;
}`;

const kFragment = `
in float isGone;
in float above;
in float isKnown;
in vec3 program;
in vec3 seen;
uniform vec4 section;
uniform int compares;
uniform int turned;
uniform vec3 ground;
uniform vec3 inside;
uniform vec3 under;
uniform vec3 even;
uniform vec3 left;
out vec4 color;
void main() {
  if (isGone > 0.999) discard;
  if (dot(section.xyz, program) > section.w) discard;
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.45 + 0.55 * abs(normal.z);
  vec3 base = ground;
  if (compares == 1 && isKnown > 0.999) base = above < 0.0 ? under : above > 0.0 ? left : even;
  bool isOutside = (turned == 1) != gl_FrontFacing;
  color = vec4(isOutside ? base * light : inside, 1.0);
}`;

const kOpen = new Vector4(0, 0, 0, 1); // nothing is left out

function stockMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: kVertex,
    fragmentShader: kFragment,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      flatAt: { value: 0 },
      isFlat: { value: 0 },
      section: { value: kOpen.clone() },
      compares: { value: 0 },
      turned: { value: 0 },
      ground: { value: new Vector3() },
      inside: { value: new Vector3() },
      under: { value: new Vector3() },
      even: { value: new Vector3() },
      left: { value: new Vector3() },
    },
  });
}

export class StockView {
  readonly group = new Group();
  private readonly mesh: StockMesh;
  private readonly state: StockState;
  private readonly geometry = new BufferGeometry();
  private readonly materials: ShaderMaterial[];
  private readonly surface: Mesh;
  private section: Section | null = null;

  constructor(readonly stock: Stock) {
    this.mesh = meshOf(stock);
    this.state = stateOf(stock);
    const { positions, gone, over, triangles } = this.mesh;
    this.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    this.geometry.setAttribute('gone', new BufferAttribute(gone, 1));
    this.geometry.setAttribute('over', new BufferAttribute(over, 1));
    this.geometry.setIndex(new BufferAttribute(triangles, 1));
    this.materials = stock.kind === 'map' ? [stockMaterial(), stockMaterial()] : [stockMaterial()];
    const meshes = this.materials.map((material) => {
      const one = new Mesh(this.geometry, material);
      one.frustumCulled = false;
      return one;
    });
    this.surface = meshes[0] ?? new Mesh();
    this.group.add(...meshes);
    // The second one is a map's lower side, which is looked at from below.
    this.set(1, 'isFlat', 1);
    this.set(1, 'turned', 1);
    this.set(1, 'flatAt', stock.bottom_mm);
    this.fill();
    this.geometry.computeBoundingSphere();
    this.geometry.boundingSphere ??= new Sphere();
  }

  // As it stands at this moment; whether it changed.
  goTo(moment: number): boolean {
    if (!this.state.goTo(moment)) return false;
    this.fill();
    return true;
  }

  compare(is: boolean): void {
    this.setAll('compares', is ? 1 : 0);
  }

  cut(section: Section | null): void {
    this.section = section;
    const plane = kOpen.clone();
    if (section) plane.set(0, 0, 0, this.sideOf(section.axis) * section.at_mm).setComponent(section.axis, this.sideOf(section.axis));
    this.setAll('section', plane);
  }

  color(colors: Colors): void {
    const { stock, inside, under, even, over } = colors;
    for (const [name, color] of Object.entries({ ground: stock, inside, under, even, left: over })) this.setAll(name, rgbOf(color));
  }

  // The place of the surface under a point of the picture, -1 to 1; in the program's coordinates. null: none.
  under(point: Vector2, camera: Camera): Vector3 | null {
    const raycaster = new Raycaster();
    raycaster.setFromCamera(point, camera);
    for (const { point: hit, face } of raycaster.intersectObject(this.surface)) {
      const isGone = face && [face.a, face.b, face.c].every((corner) => this.mesh.gone[corner] === 1);
      const place = this.surface.worldToLocal(hit.clone());
      if (!isGone && !this.isCut(place)) return place;
    }
    return null;
  }

  // A mill is looked at against its y.
  private sideOf(axis: number): number {
    return this.stock.kind === 'map' && axis === 1 ? -1 : 1;
  }

  private isCut(place: Vector3): boolean {
    const { section } = this;
    return section !== null && this.sideOf(section.axis) * (place.getComponent(section.axis) - section.at_mm) > 0;
  }

  close(): void {
    this.geometry.dispose();
    for (const material of this.materials) material.dispose();
  }

  private fill(): void {
    const { stock } = this;
    const compares = stock.nominal.length > 0;
    this.mesh.set(this.state.heights, (place, height) => (compares ? overNominal(stock, place, height) : NaN));
    for (const name of ['position', 'gone', 'over']) (this.geometry.getAttribute(name) as BufferAttribute).needsUpdate = true;
  }

  private set(material: number, name: string, value: unknown): void {
    const uniform = this.materials[material]?.uniforms[name];
    if (uniform) uniform.value = value;
  }

  private setAll(name: string, value: unknown): void {
    this.materials.forEach((_, material) => this.set(material, name, value));
  }
}
