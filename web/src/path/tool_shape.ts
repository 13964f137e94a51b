// What is known of a tool's shape. No browser and no words here, so that plain tests run it.
export interface ToolShape {
  diameter_mm: number | null; // of a mill
  corner_radius_mm: number;
  nose_radius_mm: number; // of a turning tool
  tip: number;
  length_mm: number | null; // to the gauge line
  isLathe: boolean;
}

const kCornerSteps = 8;
export const kDiametersShown = 3; // of a mill whose length is not known

// Whether there is anything to draw.
export const isDrawn = ({ diameter_mm, nose_radius_mm, isLathe }: ToolShape): boolean => (isLathe ? nose_radius_mm > 0 : diameter_mm !== null);

// A mill's side from the middle of its tip upwards: distance from the axis and height.
export function sideOf({ diameter_mm, corner_radius_mm, length_mm }: ToolShape): [radius: number, height: number][] {
  const radius = (diameter_mm ?? 0) / 2;
  const corner = Math.min(corner_radius_mm, radius);
  const top = Math.max(length_mm ?? 2 * kDiametersShown * radius, corner);
  const side: [number, number][] = [[0, 0]];
  for (let i = 0; i <= (corner > 0 ? kCornerSteps : 0); i += 1) {
    const angle = (i / kCornerSteps) * (Math.PI / 2);
    side.push([radius - corner + corner * Math.sin(angle), corner * (1 - Math.cos(angle))]);
  }
  side.push([radius, top], [0, top]);
  return side;
}

// From the imaginary tip, which the program moves, to the centre of the nose: x as radius, and z. The numbers of tips are
// those of the machine's profile.
const kTips: readonly (readonly [x: number, z: number])[] = [[0, 0], [1, 1], [1, -1], [-1, -1], [-1, 1], [0, 1], [1, 0], [0, -1], [-1, 0], [0, 0]];
export function noseCenter({ nose_radius_mm, tip }: ToolShape): [x: number, z: number] {
  const [x, z] = kTips[tip] ?? [0, 0];
  return [0 - x * nose_radius_mm, 0 - z * nose_radius_mm];
}
