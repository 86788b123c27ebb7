// What the command says of faces that lie on each other, and does where they are to be snapped.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_coincidence_test {
namespace {

using Json = nlohmann::ordered_json;

// A window in its wall, turned by an angle whose sine and cosine have no end; to six digits.
const std::string turned =
    "v -2.632748 -1.438277 -1.0\nv 2.632748 1.438277 -1.0\nv 2.632748 1.438277 1.0\nv -2.632748 -1.438277 1.0\n"
    "v -0.877583 -0.479426 -0.5\nv 0.877583 0.479426 -0.5\nv 0.877583 0.479426 0.5\nv -0.877583 -0.479426 0.5\n"
    "f 1 2 3 4\nf 5 6 7 8\n";
const std::string upright =
    "v -3 0 -1\nv 3 0 -1\nv 3 0 1\nv -3 0 1\nv -1 0 -0.5\nv 1 0 -0.5\nv 1 0 0.5\nv -1 0 0.5\nf 1 2 3 4\nf 5 6 7 8\n";

Json report_of(const std::string& mesh, const std::string& coincidence, std::vector<std::string> options = {}) {
  const TemporaryFolder folder;
  static_cast<void>(folder.file("mesh.obj", mesh));
  const std::string scene =
      folder.file("scene.toml",
                  "[mesh]\nfile = \"mesh.obj\"\nsides = \"both\"\n"
                  "[[camera]]\nname = \"front\"\neye = [0, -9, 1]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\n"
                  "fov_y_deg = 40\n" +
                      coincidence);
  options.insert(options.begin(), {"analyze", scene, "--json"});
  const RunResult run = run_sightline(options);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return Json::parse(run.out);
}

std::string only_warning(const Json& report) {
  REQUIRE(report["warnings"].size() == 1);
  return report["warnings"][0].get<std::string>();
}

bool is_said(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string snap = "[coincidence]\ndistance = 1e-6\npolicy = \"snap\"\n";

}  // namespace

TEST_CASE("faces that lie on each other but for rounding are said, with the remedy, and snapped where that is wanted") {
  const Json exact = report_of(turned, "[coincidence]\ndistance = 1e-6\n");
  CHECK(is_said(only_warning(exact), "first: 0 and 1"));
  CHECK(is_said(only_warning(exact), "set policy = \"snap\" in [coincidence], or move one"));
  CHECK(exact["coincidences"]["faces"][0]["coplanar"] == false);
  CHECK(exact["counts"]["faces"]["visible"] == 2);

  const Json snapped = report_of(turned, snap);
  CHECK(is_said(only_warning(snapped), "and count as coplanar"));
  CHECK(snapped["coincidences"]["policy"] == "snap");
  CHECK(snapped["coincidences"]["faces"][0]["coplanar"] == true);
  CHECK(snapped["coincidences"]["faces"][0]["overlap"].get<double>() == doctest::Approx(2).epsilon(1e-5));
  CHECK(snapped["counts"]["faces"]["visible"] == 1);
}

TEST_CASE("faces in one plane are said, too, and the policy ends the doubt") {
  const Json exact = report_of(upright, "");
  CHECK(is_said(only_warning(exact), "where a rule says which is seen, until the scene is turned"));
  CHECK(exact["coincidences"]["faces"][0]["coplanar"] == true);
  CHECK(exact["counts"]["faces"]["visible"] == 1);
  CHECK(only_warning(report_of(upright, snap)).ends_with("where a rule says which is seen"));
}

TEST_CASE("on a grid no faces are snapped, and that is said") {
  const Json report = report_of(turned, snap, {"--arithmetic", "exact"});
  CHECK(is_said(only_warning(report), "leave --arithmetic out, since a grid snaps no faces"));
  CHECK(report["coincidences"]["faces"][0]["coplanar"] == false);
}

}  // namespace sightline::tests::cli_coincidence_test
