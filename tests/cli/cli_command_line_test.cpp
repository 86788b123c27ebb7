#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::cli_command_line_test {
using namespace cli;

namespace {

Request parse(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{"sightline"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

const std::vector<std::string> mesh_call = {"analyze",  "a.obj",   "--eye", "-1,2.5,3e1", "--target",
                                            "-.5,0,+0", "--fov-y", "40",    "-o",         "out"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> replaced(std::vector<std::string> arguments, const std::string& from, const std::string& to) {
  for (std::string& argument : arguments) {
    if (argument == from) argument = to;
  }
  return arguments;
}

}  // namespace

TEST_CASE("a mesh comes with a camera from the options") {
  const auto call = replaced(with(mesh_call, {"--up", "0,0,1", "--aspect", "1.5", "--sides", "front", "--quiet"}),
                             "-.5,0,+0", "-.5,0,0");
  const auto options = std::get<AnalyzeOptions>(parse(call));
  CHECK(options.input == "a.obj");
  CHECK(options.output == "out");
  CHECK(options.sides == SidesPolicy::front);
  CHECK(options.quiet);
  CHECK_FALSE(options.json);
  REQUIRE(options.camera);
  CHECK(options.camera->origin == Point3{-1, 2.5, 30});
  CHECK(options.camera->aspect == 1.5);
  CHECK(options.camera->name == "view");
}

TEST_CASE("a horizontal field of view is one, too") {
  const auto camera_of = [](const std::vector<std::string>& call) {
    return std::get<AnalyzeOptions>(parse(with(replaced(call, "-.5,0,+0", "-.5,0,0"), {"--aspect", "2"})))
        .camera.value();
  };
  const Camera camera = camera_of(replaced(replaced(mesh_call, "--fov-y", "--fov-x"), "40", "90"));
  CHECK(camera.right.norm() == doctest::Approx(1));
  CHECK(camera.up.norm() == doctest::Approx(2));
  CHECK(camera_of(replaced(mesh_call, "40", "90")).up.norm() == doctest::Approx(1));
}

TEST_CASE("help is no wider than a terminal") {
  for (const char* command : {"", "analyze", "compare", "stability", "trace", "completion"}) {
    std::vector<std::string> call{"--help"};
    if (*command != 0) call.insert(call.begin(), command);
    std::istringstream help(std::get<RequestedText>(parse(call)).text);
    for (std::string line; std::getline(help, line);) {
      INFO(doctest::String(line.c_str()));
      CHECK(line.size() <= 80);
    }
  }
}

TEST_CASE("a scene file comes with its own cameras") {
  const auto options = std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json"}));
  CHECK_FALSE(options.camera);
  CHECK_FALSE(options.output);
  CHECK(options.json);
}

TEST_CASE("nothing is rounded unless asked, and what is, exactly and on 40 bits") {
  const Precision by_default = std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json"})).precision;
  CHECK(by_default.arithmetic == Arithmetic::unrounded);
  const Precision on_a_grid =
      std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json", "--grid-bits", "12"})).precision;
  CHECK(on_a_grid.arithmetic == Arithmetic::exact);
  CHECK(on_a_grid.grid_bits == 12);
  const Precision exact =
      std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json", "--arithmetic", "exact"})).precision;
  CHECK(exact.arithmetic == Arithmetic::exact);
  CHECK(exact.grid_bits == 40);
  CHECK_THROWS_AS((void)parse({"analyze", "s.toml", "--json", "--arithmetic", "unrounded", "--grid-bits", "12"}),
                  CommandLineError);
  const Precision asked =
      std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json", "--arithmetic", "float", "--grid-bits", "8"}))
          .precision;
  CHECK(asked.arithmetic == Arithmetic::single_precision);
  CHECK(asked.grid_bits == 8);
}

TEST_CASE("the fast engine and all threads are taken unless asked") {
  const auto by_default = std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json"}));
  CHECK(by_default.engine == Engine::fast);
  CHECK(by_default.threads >= 1);
  const auto asked =
      std::get<AnalyzeOptions>(parse({"analyze", "s.toml", "--json", "--engine", "full", "--threads", "3"}));
  CHECK(asked.engine == Engine::full);
  CHECK(asked.threads == 3);
}

TEST_CASE("help and version are texts") {
  CHECK(std::get<RequestedText>(parse({"analyze", "--help"})).text.find("--fov-y") != std::string::npos);
  CHECK(std::get<RequestedText>(parse({"--help"})).text.find("analyze") != std::string::npos);
  CHECK(std::get<RequestedText>(parse({"--version"})).text.rfind("sightline ", 0) == 0);
}

TEST_CASE("a wrong command line is one line that names the option") {
  const auto mesh = replaced(mesh_call, "-.5,0,+0", "0,0,0");
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls = {
      {{}, "subcommand"},
      {{"look"}, ""},
      {{"analyze"}, "input"},
      {{"analyze", "s.toml"}, "-o DIR"},
      {{"analyze", "s.toml", "t.toml", "-o", "out"}, "t.toml"},
      {{"analyze", "s.toml", "-o", "out", "--frobnicate"}, "--frobnicate"},
      {{"analyze", "s.toml", "-o", "out", "--eye", "1,2,3"}, "--eye"},
      {{"analyze", "s.toml", "-o", "out", "--fov-x", "40"}, "--fov-x"},
      {{"analyze", "s.toml", "-o", "out", "--sides", "back"}, "--sides: 'back'"},
      {{"analyze", "s.toml", "-o", "out", "--arithmetic", "quad"}, "--arithmetic: 'quad'"},
      {{"analyze", "s.toml", "-o", "out", "--grid-bits", "7"}, "--grid-bits: '7'"},
      {{"analyze", "s.toml", "-o", "out", "--grid-bits", "41"}, "--grid-bits: '41'"},
      {{"analyze", "s.toml", "-o", "out", "--grid-bits", "9.5"}, "--grid-bits: '9.5'"},
      {{"analyze", "s.toml", "-o", "out", "--engine", "slow"}, "--engine: 'slow'"},
      {{"analyze", "s.toml", "-o", "out", "--threads", "0"}, "--threads: '0'"},
      {{"analyze", "s.toml", "-o", "out", "--threads", "1.5"}, "--threads: '1.5'"},
      {{"analyze", "s.toml", "-o", "out", "--threads", "1025"}, "--threads: '1025'"},
      {{"analyze", "a.obj", "-o", "out"}, "give --eye"},
      {mesh_call, "--target: '+0' is not a number"},
      {replaced(mesh, "-1,2.5,3e1", "1,2"), "--eye: '1,2' is not of the form X,Y,Z"},
      {replaced(mesh, "-1,2.5,3e1", "1,2,3,4"), "--eye"},
      {replaced(mesh, "-1,2.5,3e1", "1,,3"), "--eye: '' is not a number"},
      {replaced(mesh, "-1,2.5,3e1", "1,2,nan"), "--eye: 'nan'"},
      {replaced(mesh, "40", "forty"), "--fov-y: 'forty'"},
      {replaced(mesh, "40", "180"), "field of view"},
      {replaced(mesh, "-1,2.5,3e1", "0,0,0"), "same point"},
      {with(mesh, {"--aspect", "0"}), "aspect"},
      {with(mesh, {"--fov-x", "50"}), "there are --fov-y and --fov-x"},
      {with(replaced(replaced(mesh, "--fov-y", "--fov-x"), "40", "0"), {"--aspect", "2"}), "--fov-x: '0'"},
      {with(mesh, {"--up", "0x1,0,0"}), "--up"},
  };
  for (const auto& call : calls) {
    INFO(doctest::String(call.second.c_str()));
    try {
      static_cast<void>(parse(call.first));
      FAIL_CHECK("the command line was accepted");
    } catch (const CommandLineError& error) {
      const std::string what = error.what();
      INFO(what);
      CHECK(what.find(call.second) != std::string::npos);
      const bool is_of_parser = what.ends_with(" is required") || what.find("not expected") != std::string::npos;
      CHECK((says_what_to_do(what) || is_of_parser));  // to the parser's the command adds where its help is
      CHECK(what.find('\n') == std::string::npos);
    }
  }
}

}  // namespace sightline::tests::cli_command_line_test
