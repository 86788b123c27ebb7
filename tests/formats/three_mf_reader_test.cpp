#include "formats/importing/three_mf_reader.h"

#include <doctest/doctest.h>

#include "tests/tools/stored_zip.h"

namespace sightline::tests::three_mf_reader_test {
namespace {

const std::string relations =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Id=\"r\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"/3D/a.model\"/></Relationships>";

std::string package(const std::string& model) {
  return stored_zip({{"_rels/.rels", relations}, {"3D/a.model", model}});
}

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" " + attributes + ">\n<resources>" +
         resources + "</resources>\n<build>" + build + "</build></model>";
}

[[maybe_unused]] std::string vertex(const std::string& x, const std::string& y, const std::string& z) {
  return "<vertex x=\"" + x + "\" y=\"" + y + "\" z=\"" + z + "\"/>";
}

const std::string vertices =
    "<mesh><vertices>" + vertex("0", "0", "0") + vertex("1", "0", "0") + vertex("0", "0.1", "1e-3") + "</vertices>";
std::string object(const std::string& id, const std::string& triangle = R"(v1="0" v2="1" v3="2")") {
  return "<object id=\"" + id + "\">" + vertices + "<triangles><triangle " + triangle +
         "/></triangles></mesh></object>";
}
[[maybe_unused]] std::string assembly(const std::string& id, const std::string& components) {
  return "<object id=\"" + id + "\"><components>" + components + "</components></object>";
}

}  // namespace

#ifdef SIGHTLINE_HAS_EXPAT

TEST_CASE("3MF: decimals are doubles, and an object is there as often as it is built") {
  const Mesh once = imported(package(model(object("1"), "<item objectid=\"1\"/>"))).mesh;
  CHECK(once.vertices == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 1e-3}});
  CHECK(once.facet_count() == 1);
  const Mesh twice =
      imported(package(model(
                   object("1") + assembly("2", R"(<component objectid="1" transform="0 1 0 -1 0 0 0 0 1 5 0 0"/>)"),
                   "<item objectid=\"1\"/><item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 1\"/>")))
          .mesh;
  CHECK(twice.face_count() == 2);
  CHECK(twice.vertices[4] == Point3(10, 2, 1));
  CHECK(twice.vertices[3] == Point3(10, 0, 1));
}

TEST_CASE("3MF: what mirrors turns the triangles round") {
  const Mesh mesh =
      imported(package(model(object("1"), "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"))).mesh;
  CHECK(mesh.faces.corners == std::vector<VertexId>{VertexId(0), VertexId(2), VertexId(1)});
  CHECK(mesh.vertices[1] == Point3(-1, 0, 0));
}

TEST_CASE("3MF: objects that are not built are not there") {
  check_warned(imported(package(model(object("1"), ""))), "the scene is empty");
}

TEST_CASE("3MF: models that are none are refused, with their line") {
  const std::string item = "<item objectid=\"1\"/>";
  check_refused(package(model(object("1", R"(v1="0" v2="1" v3="3")"), item)),
                "line 2 of its model: a corner names vertex 3 of 3, counted from 0");
  check_refused(package(model(object("1", R"(v1="0" v2="1" v3="-1")"), item)), "\"-1\" is no index or id");
  check_refused(package(model(object("1", R"(v1="0" v2="1")"), item)), "the attribute v3 is missing");
  check_refused(package(model("<object id=\"1\"><mesh><vertices>" + vertex("0", "nan", "0"), item)),
                "\"nan\" is not finite");
  check_refused(package(model("<object id=\"1\"><mesh><vertices>" + vertex("0", "", "0"), item)), "is not a number");
  check_refused(package(model(object("1"), "<item objectid=\"2\"/>")),
                "line 3 of its model: there is no object 2 before this");
  check_refused(package(model(object("1") + object("1"), item)), "object 1 is there twice");
  check_refused(package(model(assembly("1", "<component objectid=\"1\"/>"), item)), "there is no object 1 before this");
  check_refused(package(model(vertices, item)), "a part of an object is outside of all objects");
  check_refused(package(model(object("1"), "<item objectid=\"1\" transform=\"1 0 0\"/>")),
                "a transform needs 12 numbers");
  check_refused(package(model(object("1"), item) + "<"), "of its model: ");
  check_refused(package(model(object("1"), item, "requiredextensions=\"b\" xmlns:b=\"http://lattice\"")),
                "the model needs the extension \"b\", which is not read");
  const std::string production = "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";
  CHECK(refusal_of(package(model(object("1"), item, "requiredextensions=\"p\" " + production))) == "read");
  check_refused(package(model(object("1"), "<item objectid=\"1\" p:path=\"/3D/b.model\"/>", production)),
                "an object in another part of the package");
  check_refused(package("<!DOCTYPE model [<!ENTITY a \"b\">]>" + model(object("1"), item)), "a DTD, which is not read");
  check_refused(package(model(std::string(3000000, ' ') + "<object a=\"" + std::string(3000000, 'x'), item)),
                "a tag of more than 1 MiB");
}

TEST_CASE("3MF: objects that double themselves without end are refused") {
  std::string objects = assembly("1", "");
  for (int i = 2; i < 100; ++i) {
    const std::string component = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    objects += assembly(std::to_string(i), component + component);
  }
  check_refused(package(model(objects, "<item objectid=\"99\"/>")), "more than a million placed objects");
  const ReadLimits limits{std::uint64_t{1} << 26};
  std::string many = "<object id=\"1\">" + vertices + "<triangles>";
  for (int i = 0; i < 200000; ++i) many += "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>";
  check_refused(package(model(many + "</triangles></mesh></object>", "<item objectid=\"1\"/>")),
                "bytes of memory, and the limit is 67108864; raise it", limits);
}

TEST_CASE("3MF: packages that are none") {
  check_refused(stored_zip({{"3D/a.model", ""}}), "the archive has no file _rels/.rels; export the 3MF again");
  check_refused(stored_zip({{"_rels/.rels", relations}}), "the archive has no file 3D/a.model");
  check_refused(stored_zip({{"_rels/.rels", "<Relationships/>"}}), "the package names no 3D model");
  check_refused(stored_zip({{"_rels/.rels", ""}}), "no element found");
}

TEST_CASE("3MF: no byte of the archive can be changed and the mesh be another") {
  const std::string good = bytes_in(std::filesystem::path(SIGHTLINE_FIXTURES_DIR) / "formats" / "house.3mf");
  const Mesh house = imported(good).mesh;
  for (std::size_t at = 4; at < good.size(); ++at) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x15);
    INFO("byte " << at);
    try {
      CHECK(import_mesh(bytes, "it", {}, Normals::passed_over).mesh.vertices == house.vertices);
    } catch (const InputError& error) {
      CHECK(is_one_line(error.what()));
    }
  }
}

#else

TEST_CASE("3MF is refused by its name where it is not built in") {
  check_refused(package(model(object("1"), "")),
                "3MF is not read by this sightline, which was built without Expat; build it "
                "where Expat is (Debian: libexpat1-dev)");
}

#endif

}  // namespace sightline::tests::three_mf_reader_test
