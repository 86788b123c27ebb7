// Cameras in the page's units: the surface's centre is the origin, its largest half extent is 1.
//
// As in geometry/camera.h a point p has X = right . (p - origin), Y = up . (p - origin), W = forward . (p - origin), or 1
// where orthographic, and is seen at (X / W, Y / W) of the window [-1, 1]^2.
import { Matrix3, Matrix4, Vector3 } from "three";

const vector = ([x, y, z]) => new Vector3(x, y, z);

// camera: report.json's. Scaling a pinhole's rows changes nothing; an orthographic camera's rows measure lengths.
export function pageCamera(camera, centre, radius) {
  const isPinhole = camera.kind === "perspective";
  const scale = isPinhole ? 1 : radius;
  const origin = vector(camera.origin.map((coordinate, i) => (coordinate - centre[i]) / radius));
  return {
    name: camera.name,
    isPinhole,
    right: vector(camera.rows.right).multiplyScalar(scale),
    up: vector(camera.rows.up).multiplyScalar(scale),
    forward: vector(camera.rows.forward),
    origin,
    towardsViewer: vector(camera.eye),
    near: camera.near === null ? null : camera.near / radius,
    far: camera.far === null ? null : camera.far / radius,
    aspect: camera.aspect,
  };
}

function rowsInverse({ right, up, forward }) {
  const rows = new Matrix3();
  rows.set(right.x, right.y, right.z, up.x, up.y, up.z, forward.x, forward.y, forward.z);
  return rows.invert();
}

// The point at (x, y) of the window whose distance along the view direction is depth.
export function windowPoint(camera, x, y, depth) {
  const scale = camera.isPinhole ? depth : 1;
  return new Vector3(x * scale, y * scale, depth).applyMatrix3(rowsInverse(camera)).add(camera.origin);
}

// reach: how far what is to be drawn lies from the centre.
export function depthRange(camera, reach) {
  const centreDepth = -camera.forward.dot(camera.origin);
  const far = camera.far ?? centreDepth + reach + 1;
  const nearest = camera.isPinhole ? 1e-3 : centreDepth - reach - 1;
  return { near: camera.near ?? Math.max(nearest, camera.isPinhole ? (centreDepth - reach) / 2 : -Infinity), far };
}

// From the page's space to clip space: the window fills the part of the canvas that has its aspect.
export function clipMatrix(camera, reach, canvasAspect) {
  const { right, up, forward, origin } = camera;
  const { near, far } = depthRange(camera, reach);
  const fit = windowFit(camera.aspect, canvasAspect);
  const slope = camera.isPinhole ? (far + near) / (far - near) : 2 / (far - near);
  const offset = camera.isPinhole ? (-2 * far * near) / (far - near) : -(far + near) / (far - near);
  const row = (v, scale, constant) => [v.x * scale, v.y * scale, v.z * scale, constant - scale * v.dot(origin)];
  const matrix = new Matrix4();
  matrix.set(
    ...row(right, fit.x, 0),
    ...row(up, fit.y, 0),
    ...row(forward, slope, offset),
    ...(camera.isPinhole ? row(forward, 1, 0) : [0, 0, 0, 1]),
  );
  return matrix;
}

// The share of the canvas' width and height that the window has.
export function windowFit(aspect, canvasAspect) {
  return aspect > canvasAspect ? { x: 1, y: canvasAspect / aspect } : { x: aspect / canvasAspect, y: 1 };
}

// Where the camera sees p; null where it is behind it.
export function windowPlace(camera, p) {
  const offset = p.clone().sub(camera.origin);
  const w = camera.isPinhole ? camera.forward.dot(offset) : 1;
  return w > 0 ? [camera.right.dot(offset) / w, camera.up.dot(offset) / w] : null;
}

// A pinhole's centre in the mirror of the plane through three points.
export function mirroredAt([a, b, c], point) {
  const normal = new Vector3().subVectors(b, a).cross(new Vector3().subVectors(c, a)).normalize();
  const distance = normal.dot(new Vector3().subVectors(point, a));
  return point.clone().addScaledVector(normal, -2 * distance);
}
