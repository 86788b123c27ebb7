// node scripts/page-times.mjs BUILD report.html: how long a report takes to open, and then to answer: a click on the
// surface until its row is there, a key that turns it until the next picture, a switch, a look through the camera. An idle
// picture is what taking one costs. Seconds on the wall, the best of three. The graphics card is software: with a real one, pictures cost less. Needs chromium.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [build, file] = process.argv.slice(2);
const { chromium } = createRequire(join(resolve(build), "web/package.json"))("playwright-core");

const browser = await chromium.launch({
  executablePath: process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
page.setDefaultTimeout(600000);

// Taken by the browser when all is drawn.
const nextPicture = () => page.locator("#stage").screenshot();

async function seconds(what) {
  const start = performance.now();
  await what();
  return (performance.now() - start) / 1000;
}

async function bestOfThree(what) {
  const all = [];
  for (let i = 0; i < 3; ++i) all.push(await seconds(() => what(i)));
  return Math.min(...all);
}

function say(what, time) {
  console.log(`| ${what} | ${time.toFixed(2)} |`);
}

// The middle of the surface, and a little beside it: each click chooses another face.
async function click(i) {
  const { x, y, width, height } = await page.locator("#stage").boundingBox();
  await page.mouse.click(x + width * (0.5 + 0.02 * i), y + height * (0.5 + 0.02 * i));
  await page.waitForFunction(() => document.querySelector("#row dd") !== null);
}

const opened = await seconds(async () => {
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(() => document.body.dataset.shown !== undefined);
  await nextPicture();
});
console.log(`| ${await page.title()} | s |\n|---|---|`);
say("open", opened);
say("idle picture", await bestOfThree(nextPicture));
say("click on a face", await bestOfThree(click));
await page.focus("#stage");
say("turn by a key", await bestOfThree(async () => {
  await page.keyboard.press("ArrowLeft");
  await nextPicture();
}));
say("switch a label", await bestOfThree(async () => {
  await page.click("#legend input");
  await nextPicture();
}));
say("look through the camera", await bestOfThree(async () => {
  await page.click("#look");
  await nextPicture();
}));
await browser.close();
