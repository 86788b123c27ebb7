// The tests of report.html share this.
import { join } from "node:path";
import { picture, withPage } from "./page_case.mjs";

const isShown = () => document.body.dataset.shown === "0";

export function withReport(browser, folder, test, options = {}) {
  return withPage(browser, join(folder, "report.html"), { ready: isShown, ...options }, test);
}

// Returns the face's row, {column: value}, as the page shows it.
export async function shownRow(page) {
  const names = await page.locator("#row dt").allTextContents();
  const values = await page.locator("#row dd").allTextContents();
  return Object.fromEntries(names.map((name, i) => [name, values[i]]));
}

// The place lies from the triangle's centre towards a corner: 1 is the corner itself.
export function cornerOf(triangle, corner, share) {
  const centre = [0, 1].map((i) => (triangle[0][i] + triangle[1][i] + triangle[2][i]) / 3);
  return centre.map((c, i) => c + share * (corner[i] - c));
}

// Returns the colours of the canvas in 3D, [r, g, b], at places in shares of the window that is looked through, over
// white.
export async function pixelsAt(page, places) {
  const frame = await page.locator("#frame").boundingBox();
  const stage = await page.locator("#stage").boundingBox();
  const points = places.map(([right, down]) =>
    [(frame.x + right * frame.width - stage.x) / stage.width, (frame.y + down * frame.height - stage.y) / stage.height]);
  return page.evaluate(readPixels, { image: await picture(page, "#stage"), points });
}

// This runs in the page.
async function readPixels({ image, points }) {
  const bitmap = await createImageBitmap(await (await fetch(image)).blob());
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d");
  context.fillStyle = "white";
  context.fillRect(0, 0, width, height);
  context.drawImage(bitmap, 0, 0);
  return points.map(([x, y]) =>
    [...context.getImageData(Math.round(x * width), Math.round(y * height), 1, 1).data.slice(0, 3)]);
}

// Nothing is drawn there.
export function isBackground(pixel) {
  return Math.min(...pixel) > 225;
}
