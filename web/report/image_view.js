// The image plane: the visible polygons with their holes, as the camera sees them, and above them what mirrors a panel.
import { channels, firstPanelKind } from "./kinds.js";

const polygonsPerSlice = 2000;
const sliceMilliseconds = 40;

export class ImageView {
  // Two canvases on top of each other: the polygons are drawn once, the chosen face as often as it changes.
  constructor(base, overlay, onChoose) {
    this.base = base;
    this.overlay = overlay;
    overlay.addEventListener("click", (event) => {
      const face = this.faceAt(event.offsetX / overlay.clientWidth, event.offsetY / overlay.clientHeight);
      if (face !== null) onChoose(face);
    });
  }

  // view: null where the page does not have it. camera: in page units.
  show(view, camera, kinds, triangleKinds) {
    Object.assign(this, { view, camera, kinds, triangleKinds, chosen: null });
    const width = Math.min(1400, Math.round(1000 * Math.sqrt(camera.aspect)));
    for (const canvas of [this.base, this.overlay]) {
      canvas.width = width;
      canvas.height = Math.round(width / camera.aspect);
    }
    this.base.parentElement.style.setProperty("--aspect", String(camera.aspect));
    this.base.removeAttribute("data-drawn");
    this.drawing = null;
    if (view === null) return;
    this.rings = ringBegins(view);
    this.drawing = drawingFor(this.base);
    this.drawSlice(0, this.drawing);
  }

  // A slice at a time, so that the page answers meanwhile; shown when all is there, since every time costs the whole page's
  // drawing. `drawing` is another one when another camera is shown.
  drawSlice(begin, drawing) {
    if (drawing !== this.drawing) return;
    const count = this.view.polygon_face.length;
    const deadline = performance.now() + sliceMilliseconds;
    let end = begin;
    while (end < count && performance.now() < deadline) {
      const stop = Math.min(end + polygonsPerSlice, count);
      for (; end < stop; ++end) this.drawPolygon(drawing, end);
    }
    if (end < count) setTimeout(() => this.drawSlice(end, drawing));
    else this.finish(drawing);
  }

  finish(drawing) {
    this.drawReflections(drawing);
    this.base.getContext("2d").drawImage(drawing.canvas, 0, 0);
    this.base.dataset.drawn = "true";
    this.drawing = null;
  }

  drawPolygon(context, polygon) {
    const [r, g, b] = this.view.polygon_colour.subarray(3 * polygon, 3 * polygon + 3);
    context.fillStyle = `rgb(${r} ${g} ${b})`;
    context.strokeStyle = `rgb(${0.72 * r} ${0.72 * g} ${0.72 * b})`;
    context.lineWidth = Math.min(1.2, 60 / Math.sqrt(this.view.polygon_face.length + 1));
    this.tracePolygon(context, polygon);
    context.fill("evenodd");
    context.stroke();
  }

  tracePolygon(context, polygon) {
    const { image_points: points, ring_points: ringPoints, ring_sizes: sizes } = this.view;
    context.beginPath();
    for (let r = this.rings.first[polygon]; r < this.rings.first[polygon + 1]; ++r) {
      for (let i = 0; i < sizes[r]; ++i) {
        const point = ringPoints[this.rings.begin[r] + i];
        const [x, y] = this.pixel(points[2 * point], points[2 * point + 1]);
        if (i === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      context.closePath();
    }
  }

  pixel(x, y) {
    return [(0.5 + 0.5 * x) * this.base.width, (0.5 - 0.5 * y) * this.base.height];
  }

  // The refined triangles that mirror a panel, projected: they are these polygons, whatever the mode. The borders of the
  // visible polygons around them come back on top.
  drawReflections(context) {
    const faces = new Set();
    for (let t = 0; t < this.view.triangleCount; ++t) {
      const kind = this.triangleKinds[t];
      if (kind < firstPanelKind) continue;
      faces.add(this.view.triangle_face[t]);
      const [r, g, b] = channels(this.kinds[kind].colour).map((c) => 255 * c);
      context.fillStyle = context.strokeStyle = `rgb(${r} ${g} ${b})`;
      context.lineWidth = 0.6;
      this.traceTriangle(context, t);
      context.fill();
      context.stroke();
    }
    context.strokeStyle = "rgb(60 45 0 / 60%)";
    this.view.polygon_face.forEach((face, polygon) => {
      if (!faces.has(face)) return;
      this.tracePolygon(context, polygon);
      context.stroke();
    });
  }

  traceTriangle(context, triangle) {
    context.beginPath();
    for (let i = 0; i < 3; ++i) {
      const place = this.placeOfVertex(this.view.corners[3 * triangle + i]);
      if (i === 0) context.moveTo(...place);
      else context.lineTo(...place);
    }
    context.closePath();
  }

  placeOfVertex(vertex) {
    const { right, up, forward, origin, isPinhole } = this.camera;
    const { positions } = this.view;
    const x = positions[3 * vertex] - origin.x;
    const y = positions[3 * vertex + 1] - origin.y;
    const z = positions[3 * vertex + 2] - origin.z;
    const w = isPinhole ? forward.x * x + forward.y * y + forward.z * z : 1;
    return this.pixel((right.x * x + right.y * y + right.z * z) / w, (up.x * x + up.y * y + up.z * z) / w);
  }

  // Returns how many visible polygons the face has.
  choose(face) {
    const context = this.overlay.getContext("2d");
    context.clearRect(0, 0, this.overlay.width, this.overlay.height);
    if (this.view === null || face === null) return 0;
    const polygons = this.polygonsOf(face);
    context.fillStyle = "rgba(255, 45, 85, 0.65)";
    for (const [width, colour] of [[7, "#ffffff"], [3, "#c4002f"]]) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      for (const polygon of polygons) {
        this.tracePolygon(context, polygon);
        if (width === 3) context.fill("evenodd");
        context.stroke();
      }
    }
    return polygons.length;
  }

  polygonsOf(face) {
    const found = [];
    this.view.polygon_face.forEach((other, polygon) => other === face && found.push(polygon));
    return found;
  }

  // right, down: from the corner, in shares of the image.
  faceAt(right, down) {
    if (this.view === null) return null;
    const x = 2 * right - 1;
    const y = 1 - 2 * down;
    for (let p = 0; p < this.view.polygon_face.length; ++p) if (this.isInside(p, x, y)) return this.view.polygon_face[p];
    return null;
  }

  // Whether a ray to the right crosses the rings an odd number of times.
  isInside(polygon, x, y) {
    const { image_points: points, ring_points: ringPoints, ring_sizes: sizes } = this.view;
    let inside = false;
    for (let r = this.rings.first[polygon]; r < this.rings.first[polygon + 1]; ++r) {
      const begin = this.rings.begin[r];
      for (let i = 0, before = sizes[r] - 1; i < sizes[r]; before = i++) {
        const a = 2 * ringPoints[begin + i];
        const b = 2 * ringPoints[begin + before];
        const isAcross = points[a + 1] > y !== points[b + 1] > y;
        if (!isAcross) continue;
        const share = (y - points[a + 1]) / (points[b + 1] - points[a + 1]);
        if (x < points[a] + share * (points[b] - points[a])) inside = !inside;
      }
    }
    return inside;
  }
}

// A context of the same size that is not on the page. Not by the graphics card, which is slow at many small paths.
function drawingFor({ width, height }) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width, height });
  return canvas.getContext("2d", { willReadFrequently: true });
}

// first: per polygon, and one past the end, its first ring; begin: per ring its first point in ring_points.
function ringBegins({ polygon_rings: counts, ring_sizes: sizes }) {
  const sums = (values) => {
    const result = new Uint32Array(values.length + 1);
    for (let i = 0; i < values.length; ++i) result[i + 1] = result[i] + values[i];
    return result;
  };
  return { first: sums(counts), begin: sums(sizes) };
}
