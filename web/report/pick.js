// Which triangle a ray meets first. Every triangle is asked: a million take a blink, and no tree has to be built.

// origin, direction: [x, y, z]. isShown(triangle): what is switched off is passed through. Returns -1 for none.
export function firstTriangleOnRay(view, origin, direction, isShown) {
  let nearest = Infinity;
  let found = -1;
  for (let t = 0; t < view.triangleCount; ++t) {
    const distance = distanceTo(view, t, origin, direction);
    if (distance > 0 && distance < nearest && isShown(t)) {
      nearest = distance;
      found = t;
    }
  }
  return found;
}

// Along the ray; -1 where it misses. Moeller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
function distanceTo({ positions, corners }, triangle, [ox, oy, oz], [dx, dy, dz]) {
  const a = 3 * corners[3 * triangle];
  const b = 3 * corners[3 * triangle + 1];
  const c = 3 * corners[3 * triangle + 2];
  const ax = positions[a], ay = positions[a + 1], az = positions[a + 2];
  const ux = positions[b] - ax, uy = positions[b + 1] - ay, uz = positions[b + 2] - az;
  const vx = positions[c] - ax, vy = positions[c + 1] - ay, vz = positions[c + 2] - az;
  const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return -1;
  const sx = ox - ax, sy = oy - ay, sz = oz - az;
  const first = (sx * px + sy * py + sz * pz) / determinant;
  if (!(first >= 0 && first <= 1)) return -1;
  const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
  const second = (dx * qx + dy * qy + dz * qz) / determinant;
  if (!(second >= 0 && first + second <= 1)) return -1;
  return (vx * qx + vy * qy + vz * qz) / determinant;
}
