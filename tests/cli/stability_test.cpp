// The families of `sightline stability` are tested by their scenes, what each arithmetic makes of them, and what is
// written.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/stability/stability_report.h"
#include "geometry/cutting/interpenetration.h"
#include "tests/cli/xml_reader.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::stability_test {
using namespace cli;

namespace {

const ExtremeFamily& family(const std::string& name) {
  const auto& all = extreme_families();
  return *std::find_if(all.begin(), all.end(), [&](const ExtremeFamily& f) { return f.name == name; });
}

// Returns some values of the parameter, both ends among them.
std::vector<double> some_values(const ExtremeFamily& f) {
  std::vector<double> values;
  for (std::size_t i = 0; i < f.values.size(); i += 4) values.push_back(f.values[i]);
  values.push_back(f.values.back());
  return values;
}

StabilityRun run_at_extreme(const std::string& name, Arithmetic arithmetic) {
  return run_stability(family(name), family(name).values.back(), arithmetic);
}

FamilyRuns made_up_runs() {
  FamilyRuns runs{&family("scale"), {}};
  for (const double value : {runs.family->values.front(), 1.0, runs.family->values.back()}) {
    for (const Arithmetic a : {Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact}) {
      runs.runs.push_back({value, a, 40, 5, true, "", 1e-12, 1e-12, 1e-11, 0.001});
    }
  }
  runs.runs[0].finished = false;
  runs.runs[0].broken = "two \"edges\", lost";
  runs.runs[1].broken = "segments: out of order";
  runs.runs[1].mislabelled_area = 0.25;
  runs.runs[2].mislabelled_area = 0;
  return runs;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Returns the table without the column of times.
std::vector<std::string> without_times(const std::filesystem::path& csv) {
  std::vector<std::string> lines = lines_of(read_text(csv));
  for (std::string& line : lines) line.resize(line.rfind(','));
  return lines;
}

}  // namespace

TEST_CASE("the families: names, parameters, scenes of few faces of which no two pass through each other") {
  const std::set<std::string> wanted{"crossing_angle", "needle_width", "depth_gap",     "offset",
                                     "scale",          "far_near",     "field_of_view", "grid_bits"};
  std::set<std::string> names;
  for (const ExtremeFamily& f : extreme_families()) {
    CAPTURE(f.name);
    names.insert(f.name);
    CHECK(f.values.size() >= 10);
    CHECK(f.values.size() <= 25);
    for (const double value : f.values) {
      CAPTURE(value);
      const FamilyScene scene = f.make(value);
      CHECK(value > 0);
      CHECK(scene.mesh.face_count() >= 2);
      CHECK(scene.mesh.face_count() <= 12);
      CHECK(find_contacts(scene.mesh).crossing.empty());
    }
  }
  CHECK(names == wanted);
}

TEST_CASE("exact: every run is valid, and wrong by no more than the grid explains") {
  for (const ExtremeFamily& f : extreme_families()) {
    for (const double value : some_values(f)) {
      CAPTURE(f.name);
      CAPTURE(value);
      const StabilityRun run = run_stability(f, value, Arithmetic::exact);
      CHECK(run.finished);
      CHECK(run.broken == "");
      CHECK(run.grid_bound > 0);
      CHECK(run.mislabelled_area <= run.grid_bound);
      CHECK(run.area_error <= 2 * run.grid_bound);
      CHECK(run.area_error <= 2 * run.mislabelled_area);
    }
  }
}

TEST_CASE("exact on the coarsest grid shows an error: the comparison with the oracle can tell") {
  const StabilityRun run = run_stability(family("grid_bits"), 0x1p-8, Arithmetic::exact);
  CHECK(run.grid_bits == 8);
  CHECK(run.mislabelled_area > run.grid_bound / 100);
}

TEST_CASE("float and double are right on the plain scene, and wrong at the extremes") {
  for (const Arithmetic a : {Arithmetic::single_precision, Arithmetic::double_precision}) {
    CAPTURE(to_string(a));
    const StabilityRun plain = run_stability(family("scale"), 1, a);
    CHECK(plain.finished);
    CHECK(plain.mislabelled_area < 1e-6);
    const StabilityRun extreme = run_at_extreme("scale", a);
    CHECK((!extreme.finished || extreme.mislabelled_area > 1e-3));
  }
}

TEST_CASE("stability.csv: a row per run, quoted where needed, no areas where a run did not finish") {
  const std::vector<std::string> lines = lines_of(stability_table({made_up_runs()}));
  REQUIRE(lines.size() == 10);
  CHECK(lines[0] ==
        "family,parameter,arithmetic,grid_bits,faces,finished,valid,broken,area_error,mislabelled_area,grid_bound,"
        "seconds");
  CHECK(lines[1].find(",float,40,5,no,no,\"two \"\"edges\"\", lost\",,,1e-11,") != std::string::npos);
  CHECK(lines[2].find(",double,40,5,yes,no,\"segments: out of order\",1e-12,0.25,1e-11,0.001") != std::string::npos);
  CHECK(lines[4] == "scale,1,float,40,5,yes,yes,,1e-12,1e-12,1e-11,0.001");
}

TEST_CASE("a plot has a curve per arithmetic and one for the bound, a cross where a run did not finish, and a ring") {
  const std::string svg = stability_plot(made_up_runs());
  std::multiset<std::string> series;
  std::size_t rings = 0;
  for (const XmlElement& element : read_xml(svg)) {
    if (element.attributes.contains("data-series")) series.insert(element.attributes.at("data-series"));
    rings += element.attributes.contains("class") && element.attributes.at("class") == "doubtful" ? 1 : 0;
  }
  CHECK(series == std::multiset<std::string>{"float", "double", "exact", "what the grid explains"});
  CHECK(rings == 2);                     // one of them in the legend
  CHECK(count(svg, "m0 -8l-8 8") == 2);  // likewise
}

TEST_CASE("a finding counts what finished, what is valid, and where the grid explains too little") {
  const FamilyRuns runs = made_up_runs();
  CHECK(
      finding(runs, Arithmetic::single_precision) ==
      "float: 2 of 3 runs finished, 2 of them valid; at worst 1e-12 of the window is mislabelled, never more than the "
      "grid explains.");
  CHECK(finding(runs, Arithmetic::double_precision).find("3 of 3 runs finished, 2 of them valid; at worst 0.25") !=
        std::string::npos);
  CHECK(finding(runs, Arithmetic::double_precision).find("in 1 of them, first at 1.22e-150") != std::string::npos);
}

TEST_CASE("the command writes the table, a plot per family and the page, the same in every run but for the times") {
  const TemporaryFolder folder;
  const std::filesystem::path first = folder.path() / "first";
  const std::filesystem::path second = folder.path() / "second";
  for (const auto& path : {first, second}) {
    const RunResult run = run_sightline({"stability", "--family", "depth_gap", "-o", path.string()});
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK(run.out.find("exact: 25 of 25 runs finished, 25 of them valid") != std::string::npos);
  }
  CHECK(without_times(first / "stability.csv") == without_times(second / "stability.csv"));
  CHECK(read_text(first / "depth_gap.svg") == read_text(second / "depth_gap.svg"));
  const std::string page = read_text(first / "stability.html");
  CHECK(count(page, "<svg ") == 1);
  CHECK(page.find("Depth gap") != std::string::npos);
  CHECK(run_sightline({"stability", "--family", "colour", "-o", first.string()}).exit_code == 2);
  CHECK(run_sightline({"stability"}).exit_code == 2);
}

}  // namespace sightline::tests::stability_test
