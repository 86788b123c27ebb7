// A page of sightline's is opened from disk, in a real browser.
//
// Environment: SIGHTLINE_COMMAND, SIGHTLINE_WEB_DIR (where node_modules is), SIGHTLINE_CHROMIUM.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const { SIGHTLINE_COMMAND, SIGHTLINE_WEB_DIR, SIGHTLINE_CHROMIUM } = process.env;
const { chromium } = createRequire(join(SIGHTLINE_WEB_DIR, "package.json"))("playwright-core");

export const fixtures = resolve(dirname(fileURLToPath(import.meta.url)), "../../fixtures");
export const desktop = { width: 1280, height: 720 };
// This is for tests that take many pictures.
export const small = { width: 720, height: 480 };
export const phone = { width: 390, height: 844 };

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), "sightline-browser-"));
  process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

export function runSightline(...options) {
  const { status, stderr } = spawnSync(SIGHTLINE_COMMAND, options, { encoding: "utf8" });
  assert.equal(status, 0, stderr);
}

// Returns a new folder with the results of `analyze --report`.
export function analysed(scene) {
  const folder = temporaryFolder();
  runSightline("analyze", scene, "-o", folder, "--report", "--quiet");
  return folder;
}

// Each line is a row, the first one with the names; nothing is quoted in the files that are read here.
export function csvRows(file) {
  return readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
}

// The graphics card is software, so the picture is the same on every machine.
export function startBrowser() {
  const isRoot = process.getuid() === 0;
  return chromium.launch({
    executablePath: SIGHTLINE_CHROMIUM,
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...(isRoot ? ["--no-sandbox"] : [])],
  });
}

// A page must never ask for anything but itself, or complain. Both fail the test when the page is closed.
function watch(page, file) {
  const complaints = [];
  const self = pathToFileURL(file).href;
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(`console: ${message.text()}`);
  });
  page.on("dialog", (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  return page.context().route("**/*", (route) => {
    const url = route.request().url().split("#")[0];
    if (url === self || url.startsWith("data:") || url.startsWith("blob:")) return route.continue();
    complaints.push(`request: ${url}`);
    return route.abort();
  }).then(() => complaints);
}

// Runs the test on the page when it is `ready` (a function in the page), and then asks whether it behaved.
export async function withPage(browser, file, { viewport = desktop, ready }, test) {
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  page.setDefaultTimeout(120000);
  const complaints = await watch(page, file);
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(ready);
  await test(page);
  await context.close();
  assert.deepEqual(complaints, []);
}

// This runs in the page: what is asked for is drawn at the next frame.
async function drawing(selector) {
  for (let i = 0; i < 2; ++i) await new Promise((done) => requestAnimationFrame(done));
  return document.querySelector(selector).toDataURL();
}

// Returns as a data: URL what a canvas has drawn when nothing moves in it any more. That is not what is on the screen,
// which may be later by any number of frames.
export async function picture(page, selector) {
  let last = null;
  for (;;) {
    const next = await page.evaluate(drawing, selector);
    if (next === last) return next;
    last = next;
  }
}
