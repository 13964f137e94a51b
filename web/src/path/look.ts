// How segments are drawn: one program for the graphics card, colours from the page's tokens.
import { GLSL3, ShaderMaterial, Vector2, Vector3 } from 'three';
import type { ColorBy } from './color';

const kVertex = `
in float kind;
in float value;
in float along;
uniform int to;
uniform int scale;
uniform float pixelsOfMm;
uniform vec3 kinds[6];
uniform vec3 ramp[3];
uniform vec3 unknown;
uniform vec3 ground;
uniform vec2 ranges[6];
flat out vec3 shown;
flat out float isRapid;
out float dashed;
void main() {
  int k = int(kind + 0.5);
  shown = kinds[k];
  if (scale == 1 && ranges[k].x <= ranges[k].y) {
    vec2 range = ranges[k];
    float share = range.y > range.x ? clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) : 1.0;
    shown = share < 0.5 ? mix(ramp[0], ramp[1], 2.0 * share) : mix(ramp[1], ramp[2], 2.0 * share - 1.0);
    if (value < -1e29) shown = unknown;
  }
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  if (to >= 0 && gl_VertexID > to) {
    shown = mix(ground, shown, 0.18);
    gl_Position.z += 0.0005;
  }
  isRapid = k == 1 ? 1.0 : 0.0;
  dashed = along * pixelsOfMm;
}`;

const kFragment = `
flat in vec3 shown;
flat in float isRapid;
in float dashed;
out vec4 color;
void main() {
  if (isRapid > 0.5 && fract(dashed / 10.0) > 0.6) discard;
  color = vec4(shown, 1.0);
}`;

export interface Colors {
  ground: string;
  kinds: readonly string[]; // by the kind's number; of `begin` any
  slow: string;
  fast: string;
  under: string; // deviations: too much is taken, none, material is left
  even: string;
  over: string;
  unknown: string;
  tool: string;
  stock: string;
  inside: string; // where the stock is cut open
  measure: string;
  mark: string; // of what is looked at
  axis: string;
}

// "#rgb" or "#rrggbb" as shares of red, green and blue.
export function rgbOf(color: string): Vector3 {
  const digits = color.trim().replace(/^#(.)(.)(.)$/, '#$1$1$2$2$3$3').slice(1);
  const value = Number.parseInt(digits, 16) || 0;
  return new Vector3(((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255);
}

export function segmentMaterial(): ShaderMaterial {
  const vectors = () => Array.from({ length: 6 }, () => new Vector3());
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: kVertex,
    fragmentShader: kFragment,
    uniforms: {
      to: { value: -1 },
      scale: { value: 0 },
      pixelsOfMm: { value: 1 },
      kinds: { value: vectors() },
      ramp: { value: [new Vector3(), new Vector3(), new Vector3()] },
      unknown: { value: new Vector3() },
      ground: { value: new Vector3() },
      ranges: { value: Array.from({ length: 6 }, () => new Vector2()) },
    },
  });
}

// Its ends and its middle.
export const rampOf = (colors: Colors, by: ColorBy): [string, string, string] =>
  by === 'deviation' ? [colors.under, colors.even, colors.over] : [colors.slow, middleOf(colors.slow, colors.fast), colors.fast];

function middleOf(first: string, second: string): string {
  const middle = rgbOf(first).add(rgbOf(second)).multiplyScalar(0.5);
  return `#${middle.toArray().map((share) => Math.round(share * 255).toString(16).padStart(2, '0')).join('')}`;
}

export function colorSegments(material: ShaderMaterial, colors: Colors, by: ColorBy): void {
  const set = (name: string, value: unknown) => {
    const uniform = material.uniforms[name];
    if (uniform) uniform.value = value;
  };
  set('kinds', Array.from({ length: 6 }, (_, kind) => rgbOf(colors.kinds[kind] ?? '#888888')));
  set('ramp', rampOf(colors, by).map(rgbOf));
  set('unknown', rgbOf(colors.unknown));
  set('ground', rgbOf(colors.ground));
}
