// What is known of a tool's shape. No browser and no words here, so that plain tests run it.
export interface ToolShape {
  diameter_mm: number | null; // of a mill
  corner_radius_mm: number;
  nose_radius_mm: number; // of a turning tool
  tip: number;
  length_mm: number | null; // to the gauge line
  insert: { angle_deg: number; entering_angle_deg: number; edge_mm: number } | null; // of a turning tool
  holder: { from_mm: number; diameter_mm: number }[]; // shank and holder of a mill, from below
  isLathe: boolean;
}

const kCornerSteps = 8;
export const kDiametersShown = 3; // of a mill whose length is not known

// Whether there is anything to draw.
export const isDrawn = ({ diameter_mm, nose_radius_mm, isLathe }: ToolShape): boolean => (isLathe ? nose_radius_mm > 0 : diameter_mm !== null);

type Side = [radius: number, height: number][];

// Where the shape ends: at the gauge line, or for want of it a length that shows what is known.
const topOf = ({ diameter_mm, length_mm, holder }: ToolShape): number =>
  length_mm ?? Math.max(kDiametersShown * (diameter_mm ?? 0), ...holder.map(({ from_mm, diameter_mm: wide }) => from_mm + wide / 2));

// A mill's side below its holder, from the middle of the tip upwards: distance from the axis and height.
export function sideOf(shape: ToolShape): Side {
  const radius = (shape.diameter_mm ?? 0) / 2;
  const corner = Math.min(shape.corner_radius_mm, radius);
  const top = Math.max(shape.holder[0]?.from_mm ?? topOf(shape), corner);
  const side: Side = [[0, 0]];
  for (let i = 0; i <= (corner > 0 ? kCornerSteps : 0); i += 1) {
    const angle = (i / kCornerSteps) * (Math.PI / 2);
    side.push([radius - corner + corner * Math.sin(angle), corner * (1 - Math.cos(angle))]);
  }
  side.push([radius, top], [0, top]);
  return side;
}

// The side of shank and holder above it; empty: not known.
export function holderSideOf(shape: ToolShape): Side {
  const { holder } = shape;
  if (holder.length === 0) return [];
  const steps = holder.flatMap(({ from_mm, diameter_mm }, index): Side => {
    const radius = diameter_mm / 2;
    return [
      [radius, from_mm],
      [radius, holder[index + 1]?.from_mm ?? Math.max(topOf(shape), from_mm)],
    ];
  });
  return [[0, holder[0]?.from_mm ?? 0], ...steps, [0, steps.at(-1)?.[1] ?? 0]];
}

// From the imaginary tip, which the program moves, to the centre of the nose: x as radius, and z. The numbers of tips are
// those of the machine's profile.
const kTips: readonly (readonly [x: number, z: number])[] = [[0, 0], [1, 1], [1, -1], [-1, -1], [-1, 1], [0, 1], [1, 0], [0, -1], [-1, 0], [0, 0]];
export function noseCenter({ nose_radius_mm, tip }: Pick<ToolShape, 'nose_radius_mm' | 'tip'>): [x: number, z: number] {
  const [x, z] = kTips[tip] ?? [0, 0];
  return [0 - x * nose_radius_mm, 0 - z * nose_radius_mm];
}

// The outline of a turning tool's insert around its nose, seen from the tip that the program moves: x as radius, and z.
// Empty: it is not known, or the tip does not state on which side of the part it stands.
export function insertSides({ nose_radius_mm: radius, tip, insert }: ToolShape): [x: number, z: number][] {
  const [tipX, tipZ] = kTips[tip] ?? [0, 0];
  if (!insert || (tipX === 0 && tipZ === 0)) return [];
  const [centerX, centerZ] = noseCenter({ nose_radius_mm: radius, tip });
  const [leading, trailing] = edgesOf(tipX, tipZ, insert);
  const endOf = ({ x, z, outX, outZ }: Edge): [number, number] => [centerX + radius * outX + insert.edge_mm * x, centerZ + radius * outZ + insert.edge_mm * z];
  const nose = roundOf(leading, trailing, radius).map(([x, z]): [number, number] => [centerX + x, centerZ + z]);
  const corner: [number, number] = [centerX + insert.edge_mm * (leading.x + trailing.x), centerZ + insert.edge_mm * (leading.z + trailing.z)];
  const isTriangle = insert.angle_deg === 60;
  return [endOf(leading), ...nose, endOf(trailing), ...(isTriangle ? [] : [corner])];
}

interface Edge {
  x: number; // along it, away from the nose
  z: number;
  outX: number; // from the insert outwards
  outZ: number;
}

// At a corner tip the leading edge lies by its entering angle. At tips 5 to 8 both lie even to either side.
function edgesOf(tipX: number, tipZ: number, { angle_deg, entering_angle_deg }: NonNullable<ToolShape['insert']>): [leading: Edge, trailing: Edge] {
  const isCorner = tipX !== 0 && tipZ !== 0;
  const first = ((isCorner ? entering_angle_deg : 90 - angle_deg / 2) * Math.PI) / 180;
  // Axes of the plane: the feed goes along u, and v points away from the part.
  const [uX, uZ] = isCorner ? [0, tipZ] : [tipZ, tipX];
  const [vX, vZ] = isCorner ? [-tipX, 0] : [-tipX, -tipZ];
  const edge = (angle: number, side: number): Edge => {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    return { x: cos * uX + sin * vX, z: cos * uZ + sin * vZ, outX: side * (sin * uX - cos * vX), outZ: side * (sin * uZ - cos * vZ) };
  };
  return [edge(first, 1), edge(first + (angle_deg * Math.PI) / 180, -1)];
}

// The nose around its centre, from one edge to the other.
function roundOf(leading: Edge, trailing: Edge, radius: number): [x: number, z: number][] {
  const from = Math.atan2(leading.outZ, leading.outX);
  const by = Math.atan2(trailing.outZ, trailing.outX) - from;
  const turn = by > Math.PI ? by - 2 * Math.PI : by < -Math.PI ? by + 2 * Math.PI : by;
  return Array.from({ length: kCornerSteps + 1 }, (_, i) => {
    const angle = from + (i / kCornerSteps) * turn;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}
