// Pages of `sightline trace`, made by the command and opened from disk in Chromium without a network.
//
// SIGHTLINE_COMMAND: the command. SIGHTLINE_WEB_DIR: where the build has its node_modules. SIGHTLINE_CHROMIUM: the browser (chromium in
// PATH).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const { chromium } = createRequire(join(process.env.SIGHTLINE_WEB_DIR, "package.json"))("playwright-core");
const folder = mkdtempSync(join(tmpdir(), "sightline-trace-"));
let browser;
let made = 0;

function pathOfBrowser() {
  return process.env.SIGHTLINE_CHROMIUM ?? execFileSync("/bin/sh", ["-c", "command -v chromium"], { encoding: "utf8" }).trim();
}

export async function openBrowser() {
  browser = await chromium.launch({ executablePath: pathOfBrowser(), args: ["--no-sandbox"] });
}

export async function closeBrowser() {
  await browser.close();
  rmSync(folder, { recursive: true });
}

function sceneFile(name) {
  writeFileSync(join(folder, "one.obj"), "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
  writeFileSync(join(folder, name), '[mesh]\nfile = "one.obj"\n[[camera]]\nname = "view"\neye = [1, 1, 9]\n' +
    "target = [1, 1, 0]\nup = [0, 1, 0]\northographic_height = 9.0\n");
  return [join(folder, name)];
}

// what: arguments of the command, or { file } for a scene in a file of that name.
export function tracePage(what) {
  const page = join(folder, `page-${++made}.html`);
  const scene = Array.isArray(what) ? what : sceneFile(what.file);
  execFileSync(process.env.SIGHTLINE_COMMAND, ["trace", ...scene, "-o", page]);
  return page;
}

function watch(page, complaints) {
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request to ${request.url()}`);
  });
}

// Neither an error nor a request may come from the page, whatever is done with it.
export async function visit(path, { width = 1280, height = 720, hash = "" }, use) {
  const context = await browser.newContext({ viewport: { width, height }, offline: true });
  const page = await context.newPage();
  const complaints = [];
  watch(page, complaints);
  await page.goto(`file://${path}${hash}`);
  await page.waitForFunction(() => document.getElementById("place").textContent !== "");
  await use(page);
  assert.deepEqual(complaints, []);
  await context.close();
}
