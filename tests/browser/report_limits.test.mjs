// report.html is tested where input is hostile or too large, and without a mouse.
import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { gunzipSync, gzipSync } from "node:zlib";
import { analysed, fixtures, picture, small, startBrowser, temporaryFolder, withPage } from "./page_case.mjs";
import { shownRow, withReport } from "./report_case.mjs";

let browser;
before(async () => (browser = await startBrowser()));
after(() => browser.close());

const camera = "a&lt;b&gt; & 'c' ${7}";
const panel = "p&amp'${1}";
const mesh = "a</script><script>alert(1)</script><img src=x onerror=alert(2)>.obj";

// "/" in the mesh's name makes folders.
function hostileScene() {
  const folder = temporaryFolder();
  mkdirSync(dirname(join(folder, mesh)), { recursive: true });
  copyFileSync(join(fixtures, "fang/fang.obj"), join(folder, mesh));
  const scene = `[mesh]
file = '''${mesh}'''
[[camera]]
name = "${camera}"
eye = [8, 8, 10]
target = [8, 8, 0]
up = [0, 1, 0]
fov_y_deg = 90
[[panel]]
name = "${panel}"
corners = [[0, 0, 20], [9, 0, 20], [9, 9, 20]]
`;
  writeFileSync(join(folder, "scene.toml"), scene);
  return join(folder, "scene.toml");
}

test("hostile names stay text", () =>
  withReport(browser, analysed(hostileScene()), async (page) => {
    assert.equal(await page.textContent("#title"), mesh.split("/").pop());
    assert.ok((await page.title()).startsWith(mesh.split("/").pop()));
    assert.equal(await page.locator("#camera option").textContent(), camera);
    assert.equal(await page.textContent("#image-camera"), camera);
    assert.ok((await page.locator("#tables th").allTextContents()).includes(panel));
    assert.equal(await page.locator("script").count(), 2);
    assert.equal(await page.locator("img").count(), 0);
    await page.fill("#face", "1");
    assert.ok(`reflecting_area:${panel}` in (await shownRow(page)));
  }));

// Returns what has the focus, and whether that can be seen.
const focused = () => {
  const style = getComputedStyle(document.activeElement);
  const { id, dataset } = document.activeElement;
  return { id: id || dataset.kind || "", isMarked: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2 };
};

const focusOrder = ["camera", "look", "all", "reset", "stage", "visible", "panel-0", "back-facing", "hidden",
  "original-edges", "refined-edges", "patterns", "cameras", "panels", "mirror", "face"];

test("the keyboard alone reaches everything, and one sees where it is", () =>
  withReport(browser, analysed(join(fixtures, "demo/scene.toml")), async (page) => {
    const reached = [];
    for (let i = 0; i < focusOrder.length; ++i) {
      await page.keyboard.press("Tab");
      const { id, isMarked } = await page.evaluate(focused);
      assert.ok(isMarked, `the focus on ${id} cannot be seen`);
      reached.push(id);
    }
    assert.deepEqual(reached, focusOrder);
  }));

test("the keyboard alone turns, zooms, looks through a camera, changes it, and chooses a face", () =>
  withReport(browser, analysed(join(fixtures, "demo/scene.toml")), async (page) => {
    await page.focus("#stage");
    const home = await picture(page, "#stage");
    let last = home;
    for (const key of ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-", "a"]) {
      await page.keyboard.press(key);
      const next = await picture(page, "#stage");
      assert.ok(next !== last, `${key} does nothing`);
      last = next;
    }
    await page.keyboard.press("0");
    assert.ok((await picture(page, "#stage")) === home, "0 does not go back");
    await page.focus("#look");
    await page.keyboard.press("Enter");
    await page.waitForSelector("#frame", { state: "visible" });
    await page.focus("#camera");
    await page.keyboard.press("ArrowDown");
    await page.waitForFunction(() => document.body.dataset.shown === "1");
    await page.focus("#face");
    await page.keyboard.type("806");
    assert.equal((await shownRow(page)).face, "806");
    await page.keyboard.type("99");
    assert.deepEqual(await shownRow(page), {});
    assert.equal(await page.textContent("#face-state"), "There are faces 0 to 8063.");
  }, { viewport: small }));

// The page of a run whose triangles would not all fit: what the command would have said is put into a page that it
// made.
function withHeld(folder, held) {
  const file = join(folder, "report.html");
  const page = readFileSync(file, "utf8");
  const [, data] = page.match(/id="page-data">([^<]*)</);
  const blocks = data.split("\n");
  const content = JSON.parse(gunzipSync(Buffer.from(blocks[0], "base64")));
  content.held = held;
  blocks[0] = gzipSync(JSON.stringify(content)).toString("base64");
  held.forEach((part, i) => part === "nothing" && (blocks[1 + i] = ""));
  writeFileSync(file, page.replace(data, () => blocks.join("\n")));
  return file;
}

async function choose(page, camera) {
  await page.selectOption("#camera", String(camera));
  await page.waitForFunction((shown) => document.body.dataset.shown === shown, String(camera));
}

test("what was left out is said, and the rest is there", () => {
  const file = withHeld(analysed(join(fixtures, "demo/scene.toml")), ["all", "seen", "nothing"]);
  const ready = () => document.body.dataset.shown === "0";
  return withPage(browser, file, { ready }, async (page) => {
    assert.equal(await page.textContent("#notice"), "");
    assert.match(await page.textContent("#facts"), /2,000,000 triangles at most/);
    await choose(page, 1);
    assert.match(await page.textContent("#notice"), /^Left out: the triangles that this camera does not see\. .*2,000,000/);
    await choose(page, 2);
    assert.match(await page.textContent("#notice"), /^Left out: this camera's surface, image and faces\. .*2,000,000/);
    await page.fill("#face", "5");
    assert.deepEqual(await shownRow(page), {});
    assert.equal(await page.locator("#tables table").first().locator("tbody tr").count(), 3);
    await choose(page, 0);
    assert.equal((await shownRow(page)).face, "5");
  });
});
