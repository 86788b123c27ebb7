// `node run.mjs FILE` runs the tests of one file. The exit code is 77, skipped, where the build could not fetch what
// the pages are made of; it said so then.
import { existsSync } from "node:fs";
import { join } from "node:path";

if (!existsSync(join(process.env.SIGHTLINE_WEB_DIR, "pages.stamp"))) {
  console.error("The build has no pages: npm did not reach its registry. Build again with the network at hand.");
  process.exit(77);
}
await import(`./${process.argv[2]}`);
