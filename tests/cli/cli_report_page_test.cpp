// This tests report.html: its data, what it leaves out, and when the command writes it. Browsers look at it in
// tests/browser.
#include <doctest/doctest.h>
#include <zlib.h>

#include <array>
#include <cstring>

#include "cli/pages/page_template.h"
#include "cli/pages/report_page.h"
#include "cli/pages/view_block.h"
#include "formats/writing/window_points.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_report_page_test {
using namespace cli;

namespace {

std::string decoded(const std::string& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  return bytes;
}

std::string gunzipped(std::string bytes) {
  z_stream stream{};
  REQUIRE(inflateInit2(&stream, 15 + 16) == Z_OK);
  std::string result(std::size_t{1} << 22, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  result.resize(stream.total_out);
  inflateEnd(&stream);
  return result;
}

// Returns the page's blocks, unpacked; an empty one stays empty.
std::vector<std::string> blocks_of(const std::string& page) {
  const std::string begin = "id=\"page-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  std::vector<std::string> blocks;
  for (const std::string& line : split(page.substr(at, page.find('<', at) - at), '\n'))
    blocks.push_back(line.empty() ? "" : gunzipped(decoded(line)));
  return blocks;
}

std::size_t count_of(const std::string& block, const std::string& name) {
  std::uint32_t head_bytes = 0;
  std::memcpy(&head_bytes, block.data(), sizeof head_bytes);
  for (const auto& array : nlohmann::json::parse(block.substr(4, head_bytes))) {
    if (array["name"] == name) return array["count"];
  }
  return 0;
}

// A square hides a part of the triangle behind it: there are pieces that are seen, and one that is not.
struct Hidden {
  Mesh mesh;
  View view;
};

Hidden hidden_part() {
  PolygonList faces;
  faces.push_back(std::array{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}});
  faces.push_back(std::array{VertexId{4}, VertexId{5}, VertexId{6}});
  Hidden result;
  result.mesh =
      build_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-3, 0, -1}, {3, 0, -1}, {0, 0.5, -1}}, faces);
  ViewPoint front;
  front.eye = {0, 0, 8};
  result.view = analyzed(result.mesh, perspective_camera("front", front, 60));
  return result;
}

// Returns the page of so many views, with room for so many triangles.
std::vector<std::string> page_blocks(const Hidden& hidden, std::size_t views, std::size_t room) {
  ReportPage page(room);
  for (std::size_t i = 0; i < views; ++i)
    page.add_view(hidden.view, window_points(hidden.view), measure_faces(hidden.view));
  return blocks_of(page.text({}, hidden.view.mesh(), {}, {}));
}

bool has_pages() { return !page_pieces(PageName::report).empty(); }

}  // namespace

TEST_CASE("base64, as RFC 4648 has it") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("\xFF\xFE\xFD") == "//79");
}

TEST_CASE("packed data is what it was, beyond one chunk, too") {
  std::string bytes;
  for (unsigned i = 0; i < 300'000; ++i) bytes += static_cast<char>(i * i / 7 % 251);
  for (const std::string& text : {std::string(), std::string("</script>"), bytes}) {
    CHECK(gunzipped(decoded(packed(text))) == text);
    CHECK(packed(text).find('<') == std::string::npos);
  }
}

TEST_CASE("arrays begin at multiples of 8, in little endian") {
  ArrayBlock block;
  block.add("bytes", std::vector<std::uint8_t>{1, 2, 3});
  block.add("numbers", std::vector<std::uint32_t>{0x01020304});
  const std::string bytes = block.bytes();
  const auto head = static_cast<std::size_t>(static_cast<unsigned char>(bytes[0]));
  CHECK((head + 4) % 8 == 0);
  const auto parsed = nlohmann::json::parse(bytes.substr(4, head));
  CHECK(parsed[0] == nlohmann::json({{"name", "bytes"}, {"type", "u8"}, {"count", 3}}));
  CHECK(parsed[1] == nlohmann::json({{"name", "numbers"}, {"type", "u32"}, {"count", 1}}));
  using namespace std::string_literals;
  CHECK(bytes.substr(4 + head) == "\1\2\3\0\0\0\0\0\4\3\2\1\0\0\0\0"s);
}

TEST_CASE("the diagonal between two triangles of a face is not on its border; what another face has is") {
  const auto triangle = [](std::size_t a, std::size_t b, std::size_t c, std::size_t face) {
    LabelledTriangle result;
    result.corners = {VertexId{a}, VertexId{b}, VertexId{c}};
    result.face = FaceId{face};
    return result;
  };
  LabelledMesh labelled;
  labelled.triangles = {triangle(0, 1, 2, 0), triangle(2, 3, 0, 0), triangle(3, 2, 4, 1)};
  CHECK(face_borders(labelled) == std::vector<std::uint8_t>{0b011, 0b011, 0b111});
}

TEST_CASE("a page has at most the triangles that it has room for, and says what it left out") {
  if (!has_pages()) {
    CHECK_THROWS_AS(ReportPage(), PageError);
    return;
  }
  const Hidden hidden = hidden_part();
  const std::size_t all = hidden.view.labelled.triangles.size();
  std::size_t seen = 0;
  for (const LabelledTriangle& triangle : hidden.view.labelled.triangles) seen += triangle.seen ? 1U : 0U;
  REQUIRE(seen < all);
  const auto blocks = page_blocks(hidden, 3, all + seen);
  REQUIRE(blocks.size() == 4);
  CHECK(nlohmann::json::parse(blocks[0])["held"] == nlohmann::json({"all", "seen", "nothing"}));
  CHECK(nlohmann::json::parse(blocks[0])["most_triangles"] == all + seen);
  CHECK(count_of(blocks[1], "triangle_face") == all);
  CHECK(count_of(blocks[1], "face_area") == 2);
  CHECK(count_of(blocks[2], "triangle_face") == seen);
  CHECK(blocks[3] == "");
  CHECK(nlohmann::json::parse(page_blocks(hidden, 1, all)[0])["held"] == nlohmann::json({"all"}));
  CHECK(nlohmann::json::parse(page_blocks(hidden, 1, seen - 1)[0])["held"] == nlohmann::json({"nothing"}));
}

TEST_CASE("--report writes report.html beside the folders, or says in one line why not") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string scene = SIGHTLINE_FIXTURES_DIR "/fang/scene.toml";
  const RunResult without = run_sightline({"analyze", scene, "-o", out});
  CHECK(without.out.find("report.html") == std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "out/report.html"));
  const RunResult with = run_sightline({"analyze", scene, "-o", out, "--report"});
  CHECK(with.exit_code == (has_pages() ? 0 : 1));
  if (has_pages()) {
    CHECK(with.out.find("Start with " + out + "/report.html\n") != std::string::npos);
    const auto blocks = blocks_of(read_text(folder.path() / "out/report.html"));
    REQUIRE(blocks.size() == 2);
    CHECK(nlohmann::json::parse(blocks[0])["reports"][0]["camera"]["name"] == "page");
  } else {
    CHECK(lines_of(with.err).size() == 1);
    CHECK(with.err.find("install nodejs and npm") != std::string::npos);
  }
}

TEST_CASE("--report without a folder is a wrong command line") {
  const RunResult result = run_sightline({"analyze", SIGHTLINE_FIXTURES_DIR "/fang/scene.toml", "--json", "--report"});
  CHECK(result.exit_code == 2);
  CHECK(result.err.find("--report needs -o DIR") != std::string::npos);
}

TEST_CASE("--report refuses a folder in the place of report.html, before it computes") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "out/report.html");
  const RunResult result = run_sightline(
      {"analyze", SIGHTLINE_FIXTURES_DIR "/fang/scene.toml", "-o", (folder.path() / "out").string(), "--report"});
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("report.html") != std::string::npos);
}

}  // namespace sightline::tests::cli_report_page_test
