// The page of `sightline analyze --report`: opens the data, and ties the parts of the page to each other.
import { jsonBlock } from "../shared/page_data.js";
import { Report } from "./report.js";

const notice = document.getElementById("notice");

async function start() {
  if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old: it cannot decompress data");
  notice.textContent = "Opening …";
  const report = new Report(await jsonBlock(0));
  await report.showCamera(0);
}

start().catch((error) => {
  notice.textContent = `The page cannot be shown: ${error.message}`;
  throw error;
});
