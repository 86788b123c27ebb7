// report.html is tested in a real browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { assertContrast, assertNoSidewaysScrolling } from "./legible.mjs";
import { analysed, csvRows, fixtures, phone, picture, small, startBrowser } from "./page_case.mjs";
import { cornerOf, isBackground, pixelsAt, shownRow, withReport } from "./report_case.mjs";

let browser;
let demo;
let fang;

before(async () => {
  browser = await startBrowser();
  demo = analysed(join(fixtures, "demo/scene.toml"));
  fang = analysed(join(fixtures, "fang/scene.toml"));
});
after(() => browser.close());

const onDemo = (testIt, options) => withReport(browser, demo, testIt, options);
const onFang = (testIt, options) => withReport(browser, fang, testIt, options);

// The table is as faces.csv has it: texts become the page's if they are the same numbers.
function expectedRow(folder, camera, face) {
  const [heads, ...rows] = csvRows(join(folder, camera, "faces.csv"));
  return Object.fromEntries(heads.map((head, i) => [head, head === "facing" ? rows[face][i] : String(Number(rows[face][i]))]));
}

test("opens from disk and says what report.json says", () =>
  onDemo(async (page) => {
    assert.equal(await page.title(), "vase.obj: sightline report");
    assert.equal(await page.locator("#notice").textContent(), "");
    const rows = await page.locator("#tables table").first().locator("tbody tr").allInnerTexts();
    const names = ["front", "sun", "close-up"];
    assert.equal(rows.length, names.length);
    names.forEach((name, i) => {
      const { counts, areas } = JSON.parse(readFileSync(join(demo, name, "report.json"), "utf8"));
      const { visible, reflecting, hidden, out_of_view: outOfView, back_facing: backFacing } = counts.faces;
      const cells = rows[i].split("\t").map((cell) => cell.trim());
      assert.deepEqual(cells.slice(0, 6), [name, visible, reflecting, hidden, outOfView, backFacing].map(String));
      assert.ok(Math.abs(Number(cells[6]) - areas.visible) <= 1e-5 * areas.visible);
    });
  }));

test("says what the cameras cover together, as coverage.csv does", () =>
  onDemo(async (page) => {
    const together = csvRows(join(demo, "coverage.csv")).find(([face, camera, panel]) => `${face}${camera}${panel}` === "");
    const table = page.locator("#tables table", { hasText: "areas of unions" });
    const cells = (await table.locator("tbody tr").last().innerText()).split("\t");
    for (const [cell, column] of [[1, 3], [3, 4]])
      assert.ok(Math.abs(Number(cells[cell]) - Number(together[column])) <= 1e-5 * Number(together[column]));
  }));

// Fang's window is the square from (0, 0) to (16, 16). The places are the pentagon's middle and one of the triangle
// beside.
const fangPlaces = [{ face: 0, at: [5, 7] }, { face: 1, at: [9, 6] }];
const inShares = ([x, y]) => [x / 16, 1 - y / 16];

test("a click on the surface shows the face's row of faces.csv", () =>
  onFang(async (page) => {
    await page.click("#look");
    await page.waitForSelector("#frame", { state: "visible" });
    for (const { face, at } of fangPlaces) {
      const box = await page.locator("#frame").boundingBox();
      const [right, down] = inShares(at);
      await page.mouse.click(box.x + right * box.width, box.y + down * box.height);
      assert.deepEqual(await shownRow(page), expectedRow(fang, "page", face));
    }
  }));

test("a click in the image shows the face's row, and marks its polygon there and the face in 3D", () =>
  onFang(async (page) => {
    for (const { face, at } of fangPlaces) {
      const before = [await picture(page, "#image-choice"), await picture(page, "#stage")];
      const box = await page.locator("#image-choice").boundingBox();
      const [right, down] = inShares(at);
      await page.locator("#image-choice").click({ position: { x: right * box.width, y: down * box.height } });
      assert.deepEqual(await shownRow(page), expectedRow(fang, "page", face));
      assert.equal(await page.inputValue("#face"), String(face));
      const [image, stage] = [await picture(page, "#image-choice"), await picture(page, "#stage")];
      assert.ok(image !== before[0] && stage !== before[1]);
    }
  }));

// A little inside each of the triangle's corners there is surface, a little outside there is none; this is true of this
// view only.
test("through the camera the surface is where the camera sees it", () =>
  onFang(async (page) => {
    await page.click("#look");
    assert.equal(await page.getAttribute("#look", "aria-pressed"), "true");
    const triangle = [[6, 12], [2, 4], [14, 0.02]];
    const inside = triangle.map((corner) => cornerOf(triangle, corner, 0.9));
    const outside = triangle.slice(0, 2).map((corner) => cornerOf(triangle, corner, 1.1));
    const pixels = await pixelsAt(page, [...inside, ...outside].map(inShares));
    assert.deepEqual(pixels.map(isBackground), [false, false, false, true, true]);
    await page.click("#look");
    await page.waitForSelector("#frame", { state: "hidden" });
  }));

test("to drag while looking through a camera moves nothing, then and afterwards", () =>
  onFang(async (page) => {
    const home = await picture(page, "#stage");
    await page.click("#look");
    const through = await picture(page, "#stage");
    const { x, y } = await page.locator("#stage").boundingBox();
    await page.mouse.move(x + 100, y + 200);
    await page.mouse.down();
    await page.mouse.move(x + 300, y + 250, { steps: 5 });
    await page.mouse.up();
    assert.ok((await picture(page, "#stage")) === through);
    await page.click("#look");
    assert.ok((await picture(page, "#stage")) === home);
  }));

// In the view of each button, what these switches change is in the picture, and large enough.
const switches = {
  "#all": ["#cameras", "#panels", "#mirror"],
  "#reset": ["#original-edges", "#refined-edges", "#patterns", '[data-kind="visible"]', '[data-kind="hidden"]',
    '[data-kind="back-facing"]', '[data-kind="panel-0"]'],
};

test("every switch changes what is drawn, and back", () =>
  onDemo(async (page) => {
    await page.fill("#face", "3000");
    for (const [view, ids] of Object.entries(switches)) {
      await page.click(view);
      for (const id of ids) {
        const before = await picture(page, "#stage");
        await page.click(id);
        assert.ok((await picture(page, "#stage")) !== before, `${id} changes nothing`);
        await page.click(id);
        assert.ok((await picture(page, "#stage")) === before, `${id} does not change back`);
      }
    }
  }, { viewport: small }));

test("each camera has its surface, its image and its rows", () =>
  onDemo(async (page) => {
    await page.fill("#face", "3000");
    const pictures = [];
    for (const [number, name] of ["front", "sun", "close-up"].entries()) {
      await page.selectOption("#camera", String(number));
      await page.waitForFunction((shown) => document.body.dataset.shown === shown, String(number));
      assert.equal(await page.textContent("#image-camera"), name);
      assert.deepEqual(await shownRow(page), expectedRow(demo, name, 3000));
      await page.waitForSelector("#image[data-drawn]");
      pictures.push(await picture(page, "#stage"), await picture(page, "#image"));
    }
    assert.equal(new Set(pictures).size, pictures.length);
  }));

test("no text, image or control is off a phone's screen", () =>
  onDemo(async (page) => {
    await page.fill("#face", "3000");
    await assertNoSidewaysScrolling(page);
    for (const selector of ["header h1", "#camera", "#look", "#all", "#reset", "#stage", "#legend", "#switches", ".plane", "#face", "#row"]) {
      const { x, width } = await page.locator(selector).boundingBox();
      assert.ok(x >= 0 && width > 0 && x + width <= phone.width, selector);
    }
  }, { viewport: phone }));

test("at 1280 x 720 the surface, the labels, the image and a face's row are all on the screen", () =>
  onDemo(async (page) => {
    await page.fill("#face", "3000");
    for (const selector of ["#stage", "#legend", "#switches", ".plane", "#row"]) {
      const { y, height } = await page.locator(selector).boundingBox();
      assert.ok(y >= 0 && height > 0 && y + height <= 720, `${selector} ends at ${y + height}`);
    }
  }));

test("contrast is AA", () =>
  onDemo(async (page) => {
    await page.fill("#face", "3000");
    await page.click("#look");
    await assertContrast(page, 100);
  }));
