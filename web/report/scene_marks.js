// What stands around the surface: cameras with their frusta, panels, the chosen face, its mirror camera.
import {
  BufferGeometry, CanvasTexture, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, ShapeUtils, Sprite, SpriteMaterial, SRGBColorSpace, Vector2, Vector3,
} from "three";
import { depthRange, mirroredAt, windowPoint } from "./camera_math.js";
import { panelColours } from "./kinds.js";
import { triangleCorners, trianglesOfFace } from "./view_data.js";

const inkColour = 0x22262c;
const chosenCameraColour = 0x3f7fc0;
const mirrorColour = 0x8a1c7c;
const chosenColour = 0xff2d55;

function lines(points, colour) {
  const geometry = new BufferGeometry().setFromPoints(points);
  return new LineSegments(geometry, new LineBasicMaterial({ color: colour }));
}

function triangles(points, colour, opacity) {
  const geometry = new BufferGeometry().setFromPoints(points);
  const material = new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: opacity < 1, opacity });
  return new Mesh(geometry, material);
}

// A text that always faces the viewer, of the same size from everywhere.
function tag(text, position, colour = "#22262c") {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  const font = "600 30px system-ui, sans-serif";
  const shown = text.length > 40 ? `${text.slice(0, 39)}…` : text;
  context.font = font;
  canvas.width = Math.ceil(context.measureText(shown).width) + 20;
  canvas.height = 44;
  context.font = font;
  context.fillStyle = "rgba(255, 255, 255, 0.85)";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = colour;
  context.fillText(shown, 10, 32);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const material = new SpriteMaterial({ map, sizeAttenuation: false, depthTest: false });
  const sprite = new Sprite(material);
  sprite.position.copy(position);
  sprite.scale.set((0.022 * canvas.width) / canvas.height, 0.022, 1);
  sprite.renderOrder = 1;
  return sprite;
}

function frustum(camera, depths) {
  const corners = depths.map((depth) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => windowPoint(camera, x, y, depth)));
  const points = [];
  for (let i = 0; i < 4; ++i) {
    points.push(corners[0][i], corners[1][i], corners[1][i], corners[1][(i + 1) % 4]);
    points.push(corners[0][i], corners[0][(i + 1) % 4]);
  }
  return points;
}

// A small pyramid, or box; the chosen one's reaches to the end of the scene.
function cameraMark(camera, isChosen) {
  const group = new Group();
  const centreDepth = -camera.forward.dot(camera.origin);
  const { near, far } = depthRange(camera, 1.2);
  const first = camera.isPinhole ? 0 : Math.max(near, centreDepth - 2.6);
  group.add(lines(frustum(camera, [first, first + (camera.isPinhole ? 0.35 : 0.25)]), inkColour));
  if (isChosen) group.add(lines(frustum(camera, [camera.near ?? first, far]), chosenCameraColour));
  group.add(tag(camera.name, windowPoint(camera, 0, 1.25, camera.isPinhole ? 0.35 : first)));
  return group;
}

export function cameraMarks(cameras, chosen) {
  const group = new Group();
  cameras.forEach((camera, number) => group.add(cameraMark(camera, number === chosen)));
  return group;
}

// The largest of the three projections along an axis: it is not degenerate.
function flattened(corners) {
  const normal = new Vector3();
  for (let i = 2; i < corners.length; ++i) {
    const u = corners[i - 1].clone().sub(corners[0]);
    normal.add(u.cross(corners[i].clone().sub(corners[0])));
  }
  const [x, y, z] = normal.toArray().map(Math.abs);
  if (x >= y && x >= z) return corners.map((c) => new Vector2(c.y, c.z));
  return y >= z ? corners.map((c) => new Vector2(c.z, c.x)) : corners.map((c) => new Vector2(c.x, c.y));
}

function panelMark(panel, number) {
  const group = new Group();
  const faces = ShapeUtils.triangulateShape(flattened(panel.corners), []);
  group.add(triangles(faces.flat().map((i) => panel.corners[i]), panelColours[number % panelColours.length], 0.8));
  group.add(lines(panel.corners.flatMap((c, i) => [c, panel.corners[(i + 1) % panel.corners.length]]), inkColour));
  const centre = panel.corners.reduce((sum, c) => sum.add(c), new Vector3()).divideScalar(panel.corners.length);
  group.add(tag(panel.name, centre));
  return group;
}

// panels: [{name, corners}], in page units.
export function panelMarks(panels) {
  const group = new Group();
  panels.forEach((panel, number) => group.add(panelMark(panel, number)));
  return group;
}

function cornersOfFace(view, face) {
  const [begin, end] = trianglesOfFace(view, face);
  const corners = [];
  for (let t = begin; t < end; ++t) corners.push(triangleCorners(view, t).map(([x, y, z]) => new Vector3(x, y, z)));
  return corners;
}

// In front of everything, so that a hidden face is found, too. null where the page has no triangle of it.
export function chosenMark(view, face) {
  const corners = cornersOfFace(view, face);
  if (corners.length === 0) return null;
  const group = new Group();
  group.add(triangles(corners.flat(), chosenColour, 0.45));
  group.add(lines(corners.flatMap(([a, b, c]) => [a, b, b, c, c, a]), chosenColour));
  for (const mark of group.children) {
    mark.material.depthTest = false;
    mark.renderOrder = 2;
  }
  return group;
}

// The camera behind the plane of a face, and the pyramid through its corners, as long as the scene. null for a camera that
// is no point, and for a face of which the page has no triangle.
export function mirrorMark(view, face, camera, length) {
  const corners = cornersOfFace(view, face);
  if (corners.length === 0 || !camera.isPinhole) return null;
  const centre = mirroredAt(corners[0], camera.origin);
  const group = new Group();
  const ends = corners.flat().map((c) => c.clone().sub(centre).setLength(c.distanceTo(centre) + length).add(centre));
  group.add(lines(ends.flatMap((end) => [centre, end]), mirrorColour));
  group.add(tag(`${camera.name}, mirrored at face ${face}`, centre, "#8a1c7c"));
  return group;
}

export function disposeMarks(group) {
  group?.traverse((mark) => {
    mark.geometry?.dispose();
    mark.material?.map?.dispose();
    mark.material?.dispose();
  });
}
