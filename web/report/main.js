import { jsonBlock } from "../shared/page_data.js";

jsonBlock(0).then((report) => (document.getElementById("report").textContent = JSON.stringify(report)));
