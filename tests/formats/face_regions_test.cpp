// Which regions the faces of an OBJ file are in, and what its MTL files say of them.
#include "formats/reading/face_regions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "formats/reading/mtl_reader.h"
#include "formats/reading/obj_reader.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests::face_regions_test {
using namespace std::literals;
namespace {

namespace fs = std::filesystem;

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

// Per face what it is in, as "kind name" lines.
std::vector<std::multiset<std::string>> memberships(const FaceRegions& regions) {
  std::vector<std::multiset<std::string>> result(regions.face_state.size());
  for (std::size_t f = 0; f < result.size(); ++f) {
    regions.for_each(FaceId(f), [&](RegionId id) {
      const Region& region = regions.regions[id.index()];
      result[f].insert(std::string(to_string(region.kind)) + " " + region.name);
    });
  }
  return result;
}

std::vector<std::string> names_of_kind(const FaceRegions& regions, RegionKind kind) {
  std::vector<std::string> names;
  for (const Region& region : regions.regions) {
    if (region.kind == kind) names.push_back(region.name);
  }
  return names;
}

// A folder in memory.
FilesBeside files(std::map<std::string, std::string> texts) {
  return [texts = std::move(texts)](const std::string& name) -> std::optional<std::string> {
    const auto found = texts.find(name);
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  };
}

MeshFile with_library(const std::string& statements, const FilesBeside& beside) {
  return read_obj(statements + corners + "f 1 2 3\n", "mesh.obj", {}, Normals::passed_over, beside);
}

}  // namespace

TEST_CASE("a face is in one object, one material, one smoothing group, and in all of its groups") {
  const MeshFile file =
      read_obj(corners +
                   "f 1 2 3\no body shell\ng left  front left\nusemtl red paint\ns 3\nf 1 2 4\nf 1 3 4\n"
                   "s off\nusemtl\ng\nf 2 3 4\n",
               "mesh.obj");
  using Names = std::multiset<std::string>;
  CHECK(memberships(file.regions) ==
        std::vector<Names>{
            {"mesh ", "object ", "group ", "material ", "smoothing "},
            {"mesh ", "object body shell", "group left", "group front", "material red paint", "smoothing 3"},
            {"mesh ", "object body shell", "group left", "group front", "material red paint", "smoothing 3"},
            {"mesh ", "object body shell", "group ", "material ", "smoothing "}});
  CHECK(file.warnings.empty());
}

TEST_CASE("regions are in the order of their first faces; those without faces are none") {
  const MeshFile file = read_obj(corners + "o empty\no b\nf 1 2 3\no a\nf 1 2 4\no b\nf 1 3 4\no last\n", "mesh.obj");
  CHECK(names_of_kind(file.regions, RegionKind::object) == std::vector<std::string>{"b", "a"});
}

TEST_CASE("names become one line of UTF-8 without controls, of at most 200 bytes") {
  CHECK(region_name("K\xC3\xB6rper") == "K\xC3\xB6rper");
  CHECK(region_name(std::string_view("a\0b", 3)) == "a\\x00b");
  CHECK(region_name("\x1b[31m") == "\\x1b[31m");
  CHECK(region_name("\xC2\x9B") == "\\xc2\\x9b");
  CHECK(region_name("\xE2\x80\xAE") == "\\xe2\\x80\\xae");  // turns the direction of writing
  CHECK(region_name("\xC0\xAF") == "\\xc0\\xaf");
  CHECK(region_name("\xED\xA0\x80") == "\\xed\\xa0\\x80");
  CHECK(region_name("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(region_name("\xF0\x9F\x9A\x97") == "\xF0\x9F\x9A\x97");
  CHECK(region_name("\xE2\x82") == "\\xe2\\x82");
  CHECK(region_name(std::string(1000, 'x')).size() == 200);
  CHECK(region_name(std::string(199, 'x') + "\xC3\xB6").size() == 199);
  CHECK(region_name("") == "");
}

TEST_CASE("a megabyte for a name, a hundred thousand groups, and faces in a thousand of them: limits that are said") {
  std::string text = corners + "o " + std::string(1000000, 'n') + "\n";
  for (int i = 0; i < 100010; ++i) text += "g g" + std::to_string(i) + "\nf 1 2 3\n";
  text += "g";
  for (int i = 0; i < 1000; ++i) text += " h" + std::to_string(i);
  text += "\nf 1 2 4\n";
  const MeshFile file = read_obj(text, "mesh.obj");
  const auto has_warning = [&](const std::string& part) {
    return std::ranges::any_of(file.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
  };
  CHECK(has_warning("more than 100000 names of kind group"));
  CHECK(has_warning("names of regions of more than 200 bytes"));
  CHECK(has_warning("faces in more than 100 groups"));
  CHECK(std::ranges::all_of(file.warnings, is_one_line));
  CHECK(names_of_kind(file.regions, RegionKind::group).size() == 100001);
  CHECK(memberships(file.regions)[100009].contains("group "));
  CHECK(file.regions.face_state.size() == file.mesh.face_count());
}

TEST_CASE("many names need memory, and count against its limit") {
  std::string text = corners;
  for (int i = 0; i < 20000; ++i) text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
  const std::uint64_t without = memory_for_mesh(4, 60000, 20000);
  CHECK_THROWS_AS((void)read_obj(text, "mesh.obj", {without + 1000000}), InputError);
  CHECK_NOTHROW((void)read_obj(text, "mesh.obj", {without + 20000000}));
}

TEST_CASE("a material has what its library says: illum and Ks, and of two that are called alike the first") {
  const MeshFile file = with_library("mtllib a.mtl b.mtl\nusemtl chrome\n",
                                     files({{"a.mtl", "newmtl chrome\nKd 1 0 0\nKs 0.5 .25 1e-1\nillum 3\n"},
                                            {"b.mtl", "newmtl chrome\nillum 5\nKs 1 1 1\n"}}));
  CHECK(file.warnings.empty());
  const auto material = std::ranges::find(file.regions.regions, "chrome", &Region::name)->material;
  CHECK(material.illum == 3);
  REQUIRE(material.specular.has_value());
  CHECK(static_cast<float>((*material.specular)[0]) == 0.5F);
  CHECK(static_cast<float>((*material.specular)[1]) == 0.25F);
  CHECK(static_cast<float>((*material.specular)[2]) == 0.1F);
}

TEST_CASE("what a material does not say, or says in another way, is not known") {
  const auto read = read_mtl(
      "Ks 1 1 1\nnewmtl a\nKs spectral x.rfl\nillum two\nnewmtl b c\nKs xyz 1 1 1\nillum 2\n"
      "newmtl d\nKs 1e2147483649 0 0\nillum 99999999999\nnewmtl\n");
  REQUIRE(read.size() == 4);
  CHECK_FALSE(read.at("a").specular);
  CHECK_FALSE(read.at("a").illum);
  CHECK_FALSE(read.at("b c").specular);
  CHECK(read.at("b c").illum == 2);
  CHECK_FALSE(read.at("d").specular);
  CHECK_FALSE(read.at("d").illum);
  CHECK(read.contains(""));
}

TEST_CASE("hostile libraries: too long, too many materials, words without end, bytes that are no text") {
  CHECK_THROWS_AS((void)read_mtl(std::string(longest_mtl_file + 1, ' ')), std::length_error);
  std::string many;
  for (std::size_t i = 0; i <= most_materials; ++i) many += "newmtl x\n";
  CHECK_THROWS_AS((void)read_mtl(many), std::length_error);
  CHECK_THROWS_AS((void)read_mtl("newmtl " + std::string(std::size_t{2} << 20, 'x')), std::length_error);
  const auto read = read_mtl("newmtl a\0b\nKs\nKs \nillum\n\xff\xfe\nillum \0\nKs 1"sv);
  CHECK(read.contains("a\\x00b"));
  const MeshFile file = with_library("mtllib a.mtl\nusemtl x\n", files({{"a.mtl", many}}));
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] ==
        "mesh.obj:1: material library \"a.mtl\" has more than 20000 materials; its materials are not known");
}

TEST_CASE("a library is looked for by its plain name only; a missing one is a warning with the line") {
  const auto warnings = [](const std::string& name) {
    return with_library("# first\nmtllib " + name + "\nusemtl x\n", files({{"x.mtl", "newmtl x\n"}})).warnings;
  };
  CHECK(warnings("x.mtl").empty());
  CHECK(warnings("y.mtl") == std::vector<std::string>{"mesh.obj:2: material library \"y.mtl\" is not beside the mesh; "
                                                      "put it there, or remove the statement"});
  for (const char* name : {"../x.mtl", "/x.mtl", "a/x.mtl", "a\\x.mtl", "..", ".", "C:x.mtl"}) {
    INFO(name);
    REQUIRE(warnings(name).size() == 1);
    CHECK(warnings(name)[0].find("is not opened: only files beside the mesh are") != std::string::npos);
  }
}

TEST_CASE("a library's name may have blanks; materials that no library has are named") {
  const FilesBeside beside = files({{"my paint.mtl", "newmtl x\n"}});
  CHECK(with_library("mtllib my paint.mtl\nusemtl x\n", beside).warnings.empty());
  CHECK(with_library("mtllib my paint.mtl\nusemtl z\n", beside).warnings ==
        std::vector<std::string>{"mesh.obj: materials that no library defines: z"});
  CHECK(with_library("usemtl z\n", beside).warnings.empty());
}

TEST_CASE("in folders: a file beside the mesh is read, a folder and a file elsewhere are not") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "sub" / "dir");
  static_cast<void>(folder.file(
      "sub/mesh.obj", "mtllib beside.mtl\nmtllib dir\nmtllib ../outside.mtl\nusemtl a\n" + corners + "f 1 2 3\n"));
  static_cast<void>(folder.file("sub/beside.mtl", "newmtl a\nillum 7\n"));
  static_cast<void>(folder.file("outside.mtl", "newmtl a\nillum 1\n"));
  const MeshFile file = read_obj(folder.path() / "sub" / "mesh.obj");
  CHECK(std::ranges::find(file.regions.regions, "a", &Region::name)->material.illum == 7);
  REQUIRE(file.warnings.size() == 2);
  CHECK(file.warnings[0].find(":2: material library \"dir\" is not beside") != std::string::npos);
  CHECK(file.warnings[1].find(":3: material library \"../outside.mtl\" is not opened") != std::string::npos);
}

TEST_CASE("public files: objects, groups and a material") {
  const fs::path folder = shared_folder("formats");
  if (folder.empty()) return;
  CHECK(names_of_kind(read_obj(folder / "two_objects.obj").regions, RegionKind::object) ==
        std::vector<std::string>{"cube", "tetra"});
  const FaceRegions groups = read_obj(folder / "groups.obj").regions;
  CHECK(names_of_kind(groups, RegionKind::group).size() == 14);
  const MeshFile ico = read_obj(folder / "ico4.obj");
  CHECK(ico.warnings.empty());
  const auto material = std::ranges::find(ico.regions.regions, "None", &Region::name);
  REQUIRE(material != ico.regions.regions.end());
  CHECK(material->material.illum == 2);
  REQUIRE(material->material.specular.has_value());
  CHECK(static_cast<float>((*material->material.specular)[0]) == 0.8F);
}

}  // namespace sightline::tests::face_regions_test
