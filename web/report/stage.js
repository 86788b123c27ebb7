// The canvas in 3D: the viewer's own camera, which orbits, or one of the scene's, looked through.
import { Matrix4, PerspectiveCamera, Quaternion, Scene, Spherical, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { clipMatrix, windowFit } from "./camera_math.js";

const keyTurn = Math.PI / 36;
const keyZoom = 1.12;

export class Stage {
  // around: the places of what stands around the surface. onDraw(eye, w): just before drawing.
  constructor(canvas, frame, around, onDraw) {
    this.canvas = canvas;
    this.frame = frame;
    this.around = around;
    this.reach = Math.max(2, ...around.map((place) => place.length()));
    this.onDraw = onDraw;
    this.scene = new Scene();
    // The drawing is kept: a browser's "save image", and the tests, find it whenever they ask.
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.viewer = new PerspectiveCamera(32, 1, 0.01, 100);
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  // Where reset() goes back to. The controls read the up vector when they are made, and never again.
  setHome(position, up) {
    this.home = position.clone();
    this.viewer.up.copy(up);
    this.toUpright = new Quaternion().setFromUnitVectors(up, new Vector3(0, 1, 0));
    this.controls?.dispose();
    this.controls = new OrbitControls(this.viewer, this.canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.reset();
  }

  reset() {
    this.viewer.position.copy(this.home);
    this.controls.target.set(0, 0, 0);
    this.lookThrough(null);
    this.controls.update();
    this.draw();
  }

  // So far away that the cameras and panels around are in the picture, with some room.
  showAll() {
    const direction = this.home.clone().normalize();
    const halfHeight = Math.tan(this.viewer.fov * (Math.PI / 360));
    const slope = 0.95 * halfHeight * Math.min(1, this.viewer.aspect);
    const distanceFor = (place) => place.dot(direction) + place.clone().projectOnPlane(direction).length() / slope;
    this.reset();
    this.viewer.position.copy(direction.multiplyScalar(Math.max(this.home.length(), ...this.around.map(distanceFor))));
    this.controls.update();
    this.draw();
  }

  // null: the viewer's own camera again. Only that one can be dragged, so that a click on a face stays one.
  lookThrough(camera) {
    if (this.through === camera) return;
    this.through = camera;
    this.controls.enabled = camera === null;
    this.onLookThrough?.(camera);
    this.draw();
  }

  onKey(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in turns) this.turn(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") this.zoom(1 / keyZoom);
    else if (event.key === "-") this.zoom(keyZoom);
    else if (event.key === "0") this.reset();
    else if (event.key === "a") this.showAll();
    else return;
    event.preventDefault();
  }

  // By steps around the up vector, and over the top.
  turn(around, over) {
    this.lookThrough(null);
    const offset = this.viewer.position.clone().sub(this.controls.target).applyQuaternion(this.toUpright);
    const place = new Spherical().setFromVector3(offset);
    place.theta += around * keyTurn;
    place.phi += over * keyTurn;
    place.makeSafe();
    offset.setFromSpherical(place).applyQuaternion(this.toUpright.clone().invert());
    this.viewer.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    this.lookThrough(null);
    this.viewer.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight);
    this.viewer.aspect = clientWidth / clientHeight;
    this.draw();
  }

  // At the next frame, however often it is asked.
  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.drawNow();
    });
  }

  drawNow() {
    const camera = this.through ? this.throughCamera() : this.ownCamera();
    const { through } = this;
    if (!through || through.isPinhole) this.onDraw(through ? through.origin : this.viewer.position, 1);
    else this.onDraw(through.towardsViewer, 0);
    this.placeFrame();
    this.renderer.render(this.scene, camera);
    this.canvas.dataset.drawn = String(Number(this.canvas.dataset.drawn ?? 0) + 1);
  }

  ownCamera() {
    const distance = this.viewer.position.length();
    this.viewer.near = Math.max(0.002, (distance - this.reach) / 2);
    this.viewer.far = distance + 2 * this.reach + 3;
    this.viewer.updateProjectionMatrix();
    this.viewer.updateMatrixWorld();
    return this.viewer;
  }

  throughCamera() {
    const camera = new PerspectiveCamera();
    camera.matrixAutoUpdate = false;
    camera.projectionMatrix.copy(clipMatrix(this.through, this.reach, this.viewer.aspect));
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    return camera;
  }

  // The border of the window that is looked through.
  placeFrame() {
    this.frame.hidden = !this.through;
    if (!this.through) return;
    const fit = windowFit(this.through.aspect, this.viewer.aspect);
    this.frame.style.width = `${100 * fit.x}%`;
    this.frame.style.height = `${100 * fit.y}%`;
  }

  // Of the place in the canvas, in CSS pixels from its corner: {origin, direction}.
  rayAt(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const at = (depth) => new Vector3((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight, depth);
    const camera = this.through ? this.throughCamera() : this.ownCamera();
    const toClip = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const fromClip = toClip.invert();
    const origin = at(-1).applyMatrix4(fromClip);
    return { origin, direction: at(1).applyMatrix4(fromClip).sub(origin) };
  }
}
