// The page's state: the camera and the face that are chosen, and what is switched on; every change goes through here.
import { Vector3 } from "three";
import { unpackedBlock } from "../shared/page_data.js";
import { pageCamera } from "./camera_math.js";
import { ImageView } from "./image_view.js";
import { kindsOf } from "./kinds.js";
import { fillLegend } from "./legend.js";
import { firstTriangleOnRay } from "./pick.js";
import { cameraMarks, chosenMark, disposeMarks, mirrorMark, panelMarks } from "./scene_marks.js";
import { Stage } from "./stage.js";
import { disposeSurface, makeSurface, setEye } from "./surface.js";
import { element, fillTables } from "./tables.js";
import { faceRow, openView } from "./view_data.js";

const byId = (id) => document.getElementById(id);
const clickSlack = 5; // pixels between pressing and releasing: more is dragging

export class Report {
  // content: block 0 (cli/report_page.h).
  constructor(content) {
    this.content = content;
    const { reports, centre, radius, panels } = content;
    this.panelNames = panels.map(({ name }) => name);
    this.kinds = kindsOf(this.panelNames);
    this.cameras = reports.map(({ camera }) => pageCamera(camera, centre, radius));
    const place = (p) => new Vector3(...p.map((coordinate, i) => (coordinate - centre[i]) / radius));
    this.panels = panels.map(({ name, corners }) => ({ name, corners: corners.map(place) }));
    this.marks = {};
    this.face = null;
    this.fillText();
    this.imageView = new ImageView(byId("image"), byId("image-choice"), (face) => this.chooseFace(face));
    this.stage = this.makeStage();
    this.listen();
  }

  fillText() {
    const { reports, most_triangles: most, held } = this.content;
    const { scene } = reports[0];
    byId("title").textContent = scene.mesh.split("/").pop();
    document.title = `${scene.mesh.split("/").pop()}: sightline report`;
    reports.forEach(({ camera }, number) => byId("camera").append(element("option", camera.name, { value: number })));
    byId("panels-label").hidden = this.panels.length === 0;
    byId("face").max = scene.faces - 1;
    fillTables(byId("tables"), this.content);
    const left = held.includes("nothing") || held.includes("seen");
    byId("facts").textContent =
      `${scene.file}: ${scene.vertices.toLocaleString("en")} vertices, ${scene.faces.toLocaleString("en")} faces.` +
      (left ? ` The page holds ${most.toLocaleString("en")} triangles at most, of all cameras together.` : "");
  }

  makeStage() {
    const places = [...this.panels.flatMap(({ corners }) => corners), ...this.cameras.map(({ origin }) => origin)];
    const around = places.filter((place) => Number.isFinite(place.length()));
    try {
      const stage = new Stage(byId("stage"), byId("frame"), around, (eye, w) => this.surface && setEye(this.surface, eye, w));
      stage.onLookThrough = (camera) => this.onLookThrough(camera);
      this.marks.panels = panelMarks(this.panels);
      stage.scene.add(this.marks.panels);
      return stage;
    } catch (error) {
      byId("no-webgl").hidden = false;
      byId("stage").hidden = true;
      return null;
    }
  }

  listen() {
    byId("camera").addEventListener("change", () => this.showCamera(Number(byId("camera").value)));
    byId("look").addEventListener("click", () => this.stage?.lookThrough(this.stage.through ? null : this.camera()));
    byId("all").addEventListener("click", () => this.stage?.showAll());
    byId("reset").addEventListener("click", () => this.stage?.reset());
    byId("face").addEventListener("input", () => this.onFaceNumber());
    for (const id of ["original-edges", "refined-edges", "patterns", "cameras", "panels", "mirror"]) {
      byId(id).addEventListener("change", () => this.applySwitches());
    }
    const canvas = byId("stage");
    canvas.addEventListener("pointerdown", (event) => (this.pressed = [event.offsetX, event.offsetY]));
    canvas.addEventListener("click", (event) => this.onClick(event));
  }

  camera() {
    return this.cameras[this.number];
  }

  async showCamera(number) {
    this.number = number;
    const held = this.content.held[number];
    const view = held === "nothing" ? null : openView(await unpackedBlock(1 + number));
    if (number !== this.number) return;
    this.view = view;
    this.showSurface();
    this.showNotice(held);
    byId("image-camera").textContent = this.camera().name;
    this.imageView.show(view, this.camera(), this.kinds, this.surface?.triangleKinds ?? []);
    this.applySwitches();
    this.chooseFace(this.face);
    document.body.dataset.shown = String(number);
  }

  showNotice(held) {
    const most = this.content.most_triangles.toLocaleString("en");
    const texts = {
      all: "",
      seen: `Left out: the triangles that this camera does not see. The page holds ${most} at most.`,
      nothing: `Left out: this camera's surface, image and faces. The page holds ${most} triangles at most; the tables are complete.`,
    };
    byId("notice").textContent = texts[held];
  }

  showSurface() {
    if (this.surface) {
      this.stage?.scene.remove(this.surface.mesh);
      disposeSurface(this.surface);
    }
    this.surface = this.view ? makeSurface(this.view, this.kinds) : null;
    fillLegend(byId("legend"), this.kinds, this.surface?.triangleKinds ?? [], (kind, isShown) => this.switchKind(kind, isShown));
    if (!this.stage) return;
    if (this.surface) this.stage.scene.add(this.surface.mesh);
    this.replaceMark("cameras", cameraMarks(this.cameras, this.number));
    this.goHome();
  }

  // Beside the camera, so that what it does not see comes into sight, too.
  goHome() {
    const up = nearestAxis(this.camera().up);
    const towards = this.camera().forward.clone().negate().normalize();
    const beside = towards.applyAxisAngle(up, -0.6).addScaledVector(up, 0.12).normalize();
    this.stage.setHome(beside.multiplyScalar(5.2), up);
  }

  switchKind(kind, isShown) {
    this.surface.uniforms.kinds.value[kind].w = isShown ? 1 : 0;
    this.stage?.draw();
  }

  isShown(triangle) {
    return this.surface.uniforms.kinds.value[this.surface.triangleKinds[triangle]].w > 0;
  }

  applySwitches() {
    if (!this.stage) return;
    if (this.surface) {
      this.surface.uniforms.originalEdges.value = byId("original-edges").checked;
      this.surface.uniforms.refinedEdges.value = byId("refined-edges").checked;
      this.surface.uniforms.allPatterns.value = byId("patterns").checked;
      this.surface.uniforms.pixelRatio.value = this.stage.renderer.getPixelRatio();
    }
    this.marks.cameras.visible = byId("cameras").checked && !this.stage.through;
    this.marks.panels.visible = byId("panels").checked;
    this.showMirror();
    this.stage.draw();
  }

  onLookThrough(camera) {
    byId("look").setAttribute("aria-pressed", String(camera !== null));
    this.applySwitches();
  }

  onClick(event) {
    const [x, y] = this.pressed ?? [event.offsetX, event.offsetY];
    if (!this.view || Math.hypot(event.offsetX - x, event.offsetY - y) > clickSlack) return;
    const { origin, direction } = this.stage.rayAt(event.offsetX, event.offsetY);
    const triangle = firstTriangleOnRay(this.view, origin.toArray(), direction.toArray(), (t) => this.isShown(t));
    this.chooseFace(triangle < 0 ? null : this.view.triangle_face[triangle]);
  }

  onFaceNumber() {
    const number = Number(byId("face").value);
    const isFace = byId("face").value !== "" && Number.isInteger(number) && number >= 0 && number <= Number(byId("face").max);
    this.chooseFace(isFace ? number : null, byId("face").value);
  }

  // face: null for none. typed: what stands in the field, if it came from there.
  chooseFace(face, typed = face ?? "") {
    this.face = face;
    byId("face").value = typed;
    const polygons = this.imageView.choose(face);
    this.showRow(face, polygons);
    if (!this.stage) return;
    this.replaceMark("chosen", this.view && face !== null ? chosenMark(this.view, face) : null);
    this.showMirror();
    this.stage.draw();
  }

  showRow(face, polygons) {
    const row = face !== null && this.view ? faceRow(this.view, face, this.panelNames) : [];
    byId("row").replaceChildren(...row.flatMap(([name, value]) => [element("dt", name), element("dd", String(value))]));
    const max = byId("face").max;
    if (row.length > 0) byId("face-state").textContent = `Its row of faces.csv; ${polygons} visible polygon${polygons === 1 ? "" : "s"}.`;
    else if (byId("face").value !== "" && face === null) byId("face-state").textContent = `There are faces 0 to ${max}.`;
    else byId("face-state").textContent = "Click a face, or give its number.";
  }

  showMirror() {
    const isWanted = byId("mirror").checked && this.view && this.face !== null;
    const reach = this.stage.reach;
    this.replaceMark("mirror", isWanted ? mirrorMark(this.view, this.face, this.camera(), reach) : null);
  }

  replaceMark(name, mark) {
    if (this.marks[name]) this.stage.scene.remove(this.marks[name]);
    disposeMarks(this.marks[name]);
    this.marks[name] = mark;
    if (mark) this.stage.scene.add(mark);
  }
}

// The axis of the input that is most nearly the camera's up: the surface then stands as it was made.
function nearestAxis(up) {
  const sizes = up.toArray().map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  return new Vector3().setComponent(axis, Math.sign(up.getComponent(axis)) || 1);
}
