// node web/build.mjs OUTDIR: bundles each page into one self-contained template, OUTDIR/NAME.html, and all of them into
// OUTDIR/pages.cpp, which the command is linked with.
//
// In: a folder per page (page.html, main.js, page.css); OUTDIR/node_modules, as package-lock.json has it. page.html has
// three places to fill: @STYLE@ and @SCRIPT@ are filled here, @DATA@ by the command.
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { pageSource } from "./embed.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2]);
const esbuild = createRequire(join(out, "package.json"))("esbuild");

function bundled(file) {
  const result = esbuild.buildSync({
    entryPoints: [file],
    bundle: true,
    minify: true,
    write: false,
    format: file.endsWith(".js") ? "iife" : undefined,
    target: "es2022",
    legalComments: "inline",
    nodePaths: [join(out, "node_modules")],
  });
  return result.outputFiles[0].text;
}

// A function's result is inserted as it is; in a text, "$&" would mean something.
function filled(template, place, text) {
  if (template.split(place).length !== 2) throw new Error(`${place} must be in the page once`);
  return template.replace(place, () => text);
}

function pageTemplate(name) {
  const folder = join(here, name);
  let page = readFileSync(join(folder, "page.html"), "utf8");
  page = filled(page, "@STYLE@", bundled(join(folder, "page.css")));
  page = filled(page, "@SCRIPT@", bundled(join(folder, "main.js")));
  if (page.split("@DATA@").length !== 2) throw new Error(`${name}: @DATA@ must be in the page once`);
  return page;
}

const names = readdirSync(here).filter((name) => existsSync(join(here, name, "page.html"))).sort();
const templates = names.map((name) => ({ name, text: pageTemplate(name) }));
for (const { name, text } of templates) writeFileSync(join(out, `${name}.html`), text);
writeFileSync(join(out, "pages.cpp"), pageSource(templates));
