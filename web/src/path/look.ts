// How segments are drawn: one program for the graphics card, colours from the page's tokens.
import { GLSL3, ShaderMaterial, Vector2, Vector3 } from 'three';

const kVertex = `
in float kind;
in float feed;
in float along;
uniform int to;
uniform int byFeed;
uniform float pixelsOfMm;
uniform vec3 kinds[6];
uniform vec3 slow;
uniform vec3 fast;
uniform vec3 ground;
uniform vec2 ranges[6];
flat out vec3 shown;
flat out float isRapid;
out float dashed;
void main() {
  int k = int(kind + 0.5);
  shown = kinds[k];
  if (byFeed == 1 && k >= 2) {
    vec2 range = ranges[k];
    float share = range.y > range.x ? clamp((feed - range.x) / (range.y - range.x), 0.0, 1.0) : 1.0;
    shown = mix(slow, fast, share);
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
      byFeed: { value: 0 },
      pixelsOfMm: { value: 1 },
      kinds: { value: vectors() },
      slow: { value: new Vector3() },
      fast: { value: new Vector3() },
      ground: { value: new Vector3() },
      ranges: { value: Array.from({ length: 6 }, () => new Vector2()) },
    },
  });
}

export function colorSegments(material: ShaderMaterial, colors: Colors): void {
  const set = (name: string, value: unknown) => {
    const uniform = material.uniforms[name];
    if (uniform) uniform.value = value;
  };
  set('kinds', Array.from({ length: 6 }, (_, kind) => rgbOf(colors.kinds[kind] ?? '#888888')));
  set('slow', rgbOf(colors.slow));
  set('fast', rgbOf(colors.fast));
  set('ground', rgbOf(colors.ground));
}
