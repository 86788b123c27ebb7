// The numbers below the pictures: areas per camera and panel, what cameras cover together, times, warnings. All names are
// put in as text.

export function element(name, text = "", attributes = {}) {
  const made = document.createElement(name);
  made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const isNumber = (value) => typeof value === "number";
export const short = (value) => (isNumber(value) ? Number(value.toPrecision(6)).toString() : value);
const share = (part, whole) => `${(whole > 0 ? (100 * part) / whole : 0).toFixed(2)} %`;
const seconds = (value) => `${value.toFixed(3)} s`;

// rows: of texts; the first of each is its heading.
function table(caption, heads, rows) {
  const made = element("table");
  made.append(element("caption", caption));
  const head = element("tr");
  for (const text of heads) head.append(element("th", text, { scope: "col" }));
  made.createTHead().append(head);
  const body = made.createTBody();
  for (const [first, ...rest] of rows) {
    const row = element("tr");
    row.append(element("th", first, { scope: "row" }), ...rest.map((text) => element("td", text)));
    body.append(row);
  }
  const scroller = element("div", "", { class: "scroller", tabindex: "0", role: "region", "aria-label": caption });
  scroller.append(made);
  return scroller;
}

function cameraTable(reports) {
  const rows = reports.map(({ camera, counts, areas, times_s: times }) => [
    camera.name,
    String(counts.faces.visible),
    String(counts.faces.reflecting),
    String(counts.faces.hidden),
    String(counts.faces.out_of_view),
    String(counts.faces.back_facing),
    short(areas.visible),
    share(areas.visible, areas.surface),
    `${(100 * (1 - areas.image_uncovered / (camera.lens?.frame_area ?? 4))).toFixed(1)} %`,
    seconds(times.total),
  ]);
  const heads = ["camera", "visible faces", "reflecting", "hidden", "out of view", "back-facing", "visible area",
    "of the surface", "window filled", "time"];
  return table("What each camera sees", heads, rows);
}

function panelTable({ reports, panels, coverage }) {
  const row = (name, areas, numbers) => [name, ...numbers.map((p) => short(areas.panels[p])), short(areas.any_panel),
    share(areas.any_panel, areas.visible)];
  const numbers = panels.map((_, p) => p);
  const rows = reports.map(({ camera }, c) => row(camera.name, coverage.cameras[c], numbers));
  if (reports.length > 1) rows.push(row("all together", coverage.together, numbers));
  const heads = ["camera", ...panels.map(({ name }) => name), "any panel", "of the visible"];
  return table("Area that mirrors a panel", heads, rows);
}

function coverageTable({ reports, panels, coverage }) {
  const row = (name, areas) => [name, short(areas.visible), share(areas.visible, coverage.area),
    ...(panels.length > 0 ? [short(areas.any_panel), share(areas.any_panel, coverage.area)] : [])];
  const rows = reports.map(({ camera }, c) => row(camera.name, coverage.cameras[c]));
  if (reports.length > 1) rows.push(row("all together", coverage.together));
  const heads = ["camera", "visible area", "of the surface",
    ...(panels.length > 0 ? ["mirrors a panel", "of the surface"] : [])];
  return table("Coverage: areas of unions, not sums", heads, rows);
}

function timesTable(reports) {
  const stages = Object.keys(reports[0].times_s);
  const rows = stages.map((stage) => [stage, ...reports.map(({ times_s: times }) => seconds(times[stage]))]);
  return table("Times", ["stage", ...reports.map(({ camera }) => camera.name)], rows);
}

function countsTable(reports) {
  const names = { edges: "edges", sweep_points: "sweep points", crossings: "crossings",
    visible_segments: "visible segments", visible_polygons: "visible polygons", holes: "holes",
    below_resolution: "below resolution", output_triangles: "refined triangles",
    crossing_pairs: "pairs of faces that cross" };
  const rows = Object.entries(names).map(([key, name]) => [name, ...reports.map(({ counts }) => String(counts[key]))]);
  rows.push(["decided by the filter", ...reports.map(({ predicates }) => share(predicates.filter_share, 1))]);
  return table("Counts", ["", ...reports.map(({ camera }) => camera.name)], rows);
}

function warningList(reports) {
  const list = element("ul", "", { class: "warnings" });
  for (const { camera, warnings } of reports) {
    for (const warning of warnings) list.append(element("li", `${camera.name}: ${warning}`));
  }
  if (list.childElementCount === 0) list.append(element("li", "There are none."));
  return list;
}

// In: block 0 of the page's data (cli/report_page.h).
export function fillTables(place, content) {
  const { reports, panels } = content;
  place.append(cameraTable(reports));
  if (panels.length > 0) place.append(panelTable(content));
  place.append(coverageTable(content), timesTable(reports), countsTable(reports));
  const warnings = element("section", "", { "aria-labelledby": "warnings-title", id: "warnings" });
  warnings.append(element("h2", "Warnings", { id: "warnings-title" }), warningList(reports));
  place.append(warnings);
}
