// node scripts/page-picture.mjs BUILD PAGE.html OUT.png [CSS-SELECTOR...]: a picture of a page, 1280 x 720, with what
// the selectors name clicked first. BUILD: a build folder with the pages in it. Needs chromium.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [build, file, out, ...clicks] = process.argv.slice(2);
const { chromium } = createRequire(join(resolve(build), "web/package.json"))("playwright-core");

const browser = await chromium.launch({
  executablePath: process.env.SIGHTLINE_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
page.setDefaultTimeout(120000);
await page.goto(pathToFileURL(resolve(file)).href);
await page.waitForFunction(() => document.body.dataset.shown !== undefined);
for (const selector of clicks) await page.click(selector);
await page.waitForTimeout(3000); // the image is drawn in slices
await page.screenshot({ path: out });
await browser.close();
