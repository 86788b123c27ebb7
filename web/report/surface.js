// The refined surface as three.js draws it: every triangle in the colour of its kind, flat; its edges are drawn by the same
// shader, from the distance to them, so that they cost nothing and hide nothing.
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, ShaderMaterial, Vector4 } from "three";
import { channels, kindOf } from "./kinds.js";

export const mostKinds = 5 + 64;

const vertexShader = `
in vec3 traits;  // kind, corner, border
out vec3 place;
out vec3 fromRefined;
out vec3 fromOriginal;
flat out int kind;
void main() {
  kind = int(traits.x + 0.5);
  int corner = int(traits.y + 0.5);
  int border = int(traits.z + 0.5);
  place = position;
  fromRefined = vec3(corner == 0, corner == 1, corner == 2);
  // The edge that begins at corner i is opposite corner i + 2.
  fromOriginal = max(fromRefined, vec3((border & 2) == 0, (border & 4) == 0, (border & 1) == 0));
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = `
precision highp float;
in vec3 place;
in vec3 fromRefined;
in vec3 fromOriginal;
flat in int kind;
out vec4 colour;
uniform vec4 kinds[${mostKinds}];  // colour, and whether it is shown
uniform int patternOf[${mostKinds}];
uniform bool allPatterns;
uniform bool refinedEdges;
uniform bool originalEdges;
uniform vec4 eye;
uniform float pixelRatio;

float lineOf(vec3 distances, float width) {
  vec3 step = max(fwidth(distances), vec3(1e-7));
  vec3 pixels = distances / step;
  float nearest = min(min(pixels.x, pixels.y), pixels.z);
  float crowded = smoothstep(0.15, 0.5, max(max(step.x, step.y), step.z));
  return (1.0 - smoothstep(width - 0.5, width + 0.5, nearest)) * (1.0 - crowded);
}

float patternAt(int pattern, vec2 at) {
  if (pattern == 1) return step(0.5, fract((at.x + at.y) / 9.0));
  if (pattern == 2) return 1.0 - smoothstep(0.25, 0.35, length(fract(at / 9.0) - 0.5));
  if (pattern == 3) return step(0.75, fract(at.y / 7.0));
  if (pattern == 4) return abs(step(0.5, fract(at.x / 10.0)) - step(0.5, fract(at.y / 10.0)));
  return 0.0;
}

void main() {
  if (kinds[kind].a < 0.5) discard;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  vec3 towardsEye = normalize(eye.xyz - eye.w * place);
  if (dot(normal, towardsEye) < 0.0) normal = -normal;
  float light = 0.48 + 0.34 * dot(normal, towardsEye) + 0.18 * dot(normal, normalize(vec3(-0.4, 0.8, 0.45)));
  vec3 base = kinds[kind].rgb;
  bool isPanel = kind >= 5;
  if (allPatterns || isPanel) {
    float mark = patternAt(patternOf[kind], gl_FragCoord.xy / pixelRatio);
    float isLight = step(0.45, dot(base, vec3(0.3, 0.59, 0.11)));
    base = mix(base, base * (isLight > 0.5 ? 0.72 : 1.0) + (isLight > 0.5 ? 0.0 : 0.16), mark);
  }
  base *= light;
  float line = 0.0;
  if (refinedEdges) line = max(line, 0.4 * lineOf(fromRefined, 0.6 * pixelRatio));
  if (originalEdges) line = max(line, 0.65 * lineOf(fromOriginal, 0.6 * pixelRatio));
  colour = vec4(mix(base, vec3(0.08, 0.09, 0.11), line), 1.0);
}`;

function kindColours(kinds) {
  return Array.from({ length: mostKinds }, (_, kind) => {
    const [r, g, b] = kind < kinds.length ? channels(kinds[kind].colour) : [0, 0, 0];
    return new Vector4(r, g, b, 1);
  });
}

function surfaceMaterial(kinds) {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    uniforms: {
      kinds: { value: kindColours(kinds) },
      patternOf: { value: Array.from({ length: mostKinds }, (_, kind) => kinds[kind]?.pattern ?? 0) },
      allPatterns: { value: false },
      refinedEdges: { value: false },
      originalEdges: { value: true },
      eye: { value: new Vector4(0, 0, 1, 0) },
      pixelRatio: { value: 1 },
    },
  });
}

// Per triangle.
export function triangleKinds(view) {
  const kinds = new Uint8Array(view.triangleCount);
  const panels = view.triangle_panels;
  for (let t = 0; t < kinds.length; ++t) {
    kinds[t] = kindOf(view.triangle_state[t], panels?.[2 * t] ?? 0, panels?.[2 * t + 1] ?? 0);
  }
  return kinds;
}

function surfaceGeometry(view, kinds) {
  const positions = new Float32Array(9 * view.triangleCount);
  const traits = new Uint8Array(9 * view.triangleCount);
  for (let i = 0; i < 3 * view.triangleCount; ++i) {
    const triangle = (i / 3) | 0;
    const from = 3 * view.corners[i];
    for (let k = 0; k < 3; ++k) positions[3 * i + k] = view.positions[from + k];
    traits[3 * i] = kinds[triangle];
    traits[3 * i + 1] = i % 3;
    traits[3 * i + 2] = view.triangle_state[triangle] >> 3;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("traits", new BufferAttribute(traits, 3));
  return geometry;
}

// kinds: kindsOf(...). The view's triangles' kinds are in .triangleKinds.
export function makeSurface(view, kinds) {
  const kindPerTriangle = triangleKinds(view);
  const mesh = new Mesh(surfaceGeometry(view, kindPerTriangle), surfaceMaterial(kinds));
  mesh.frustumCulled = false;
  return { mesh, triangleKinds: kindPerTriangle, uniforms: mesh.material.uniforms };
}

export function disposeSurface(surface) {
  surface.mesh.geometry.dispose();
  surface.mesh.material.dispose();
}

// eye: a place (w = 1) or a direction (w = 0).
export function setEye(surface, eye, w) {
  surface.uniforms.eye.value.set(eye.x, eye.y, eye.z, w);
}

