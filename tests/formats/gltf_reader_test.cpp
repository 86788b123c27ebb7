#include "formats/importing/gltf_reader.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "formats/importing/packed_bytes.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::gltf_reader_test {
namespace {

using Json = nlohmann::json;
using Change = std::function<void(Json&)>;

std::string base64(const std::string& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(c);
    for (count += 8; count >= 6; count -= 6) text += letters[bits >> (count - 6) & 63];
  }
  return count > 0 ? text + letters[bits << (6 - count) & 63] : text;
}

// Four corners of a square, four normals, and two triangles: 48 + 48 + 6 bytes.
std::string square_bytes() {
  std::string bytes;
  for (const int x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) bytes += raw(static_cast<float>(x));
  for (int i = 0; i < 4; ++i) bytes += raw(0.0F) + raw(0.5F) + raw(1.0F);
  for (const char i : {'\0', '\1', '\2', '\0', '\2', '\3'}) bytes += i;
  return bytes;
}

Json square() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 6}],
    "buffers": [{"byteLength": 102, "uri": "data:;base64,)" +
                     base64(square_bytes()) + R"("}]})");
}

std::string changed(const Change& change) {
  Json document = square();
  change(document);
  return document.dump();
}

MeshFile read(const Change& change, Normals normals = Normals::passed_over) {
  return imported(changed(change), normals);
}

void check_refusal(const std::string& part, const Change& change) { check_refused(changed(change), part); }

Json& primitive(Json& d) { return d["meshes"][0]["primitives"][0]; }

}  // namespace

TEST_CASE("base64") {
  CHECK(from_base64("") == "");
  CHECK(from_base64("TQ==") == "M");
  CHECK(from_base64("TWE=") == "Ma");
  CHECK(from_base64("TWFu") == "Man");
  CHECK(from_base64("TWE") == "Ma");
  CHECK_FALSE(from_base64("TWFu!"));
  CHECK_FALSE(from_base64("TWFuT"));
  CHECK(from_base64(base64(square_bytes())) == square_bytes());
}

TEST_CASE("glTF: positions as they are, triangles as lists, strips and fans") {
  const Mesh mesh = read([](Json&) {}).mesh;
  CHECK(mesh.vertices == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(mesh.face_count() == 2);
  CHECK(area_of(mesh) == 1);
  CHECK(read([](Json& d) { primitive(d)["mode"] = 5; }).mesh.faces.corners[4] == VertexId(0));
  const Mesh fan = read([](Json& d) {
                     primitive(d)["mode"] = 6;
                     primitive(d).erase("indices");
                   }).mesh;
  CHECK(fan.face_count() == 2);
  CHECK(area_of(fan) == 1);
  const Mesh strip = read([](Json& d) {
                       primitive(d)["mode"] = 5;
                       primitive(d).erase("indices");
                     }).mesh;
  CHECK(strip.faces.corners ==
        std::vector<VertexId>{VertexId(0), VertexId(1), VertexId(2), VertexId(1), VertexId(3), VertexId(2)});
}

TEST_CASE("glTF: nodes place their meshes, in double") {
  const Mesh mesh = read([](Json& d) {
                      d["nodes"] = Json::parse(R"([{"translation": [0.1, 0, 0], "children": [1]},
                        {"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [3, 1, 1], "mesh": 0}])");
                    }).mesh;
  CHECK(mesh.vertices[0] == Point3(0.1, 0, 0));
  CHECK(mesh.vertices[1].x() == doctest::Approx(0.1).epsilon(1e-15));
  CHECK(mesh.vertices[1].y() == doctest::Approx(3).epsilon(1e-15));
  CHECK(mesh.vertices[3].x() == doctest::Approx(-0.9).epsilon(1e-15));
}

TEST_CASE("glTF: what mirrors turns the triangles round, and normals with their surface") {
  const MeshFile file = read([](Json& d) { d["nodes"][0]["scale"] = {1, -2, 1}; }, Normals::read);
  CHECK(file.mesh.faces.corners[1] == VertexId(2));
  CHECK(file.mesh.faces.corners[2] == VertexId(1));
  // The normal (0, 0.5, 1) is across (1, 0, 0) and (0, -2, 1); the map takes them to (1, 0, 0) and (0, 4, 1).
  const Vector3 normal = file.corner_normals[0];
  CHECK(normal.dot(Vector3(1, 0, 0)) == 0);
  CHECK(normal.dot(Vector3(0, 4, 1)) == 0);
  CHECK(normal.z() > 0);
  CHECK(read([](Json& d) { primitive(d)["attributes"].erase("NORMAL"); }, Normals::read).corner_normals ==
        std::vector<Vector3>(6, Vector3::Zero()));
}

TEST_CASE("glTF: scenes") {
  const auto two_nodes = [](Json& d) { d["nodes"] = Json::parse(R"([{"mesh": 0}, {"children": [0]}, {"mesh": 0}])"); };
  const auto faces = [&](const Change& change) {
    return read([&](Json& d) {
             two_nodes(d);
             change(d);
           })
        .mesh.face_count();
  };
  CHECK(faces([](Json& d) { d["scenes"] = Json::parse(R"([{"nodes": [2]}, {"nodes": [1, 2]}])"); }) == 2);
  CHECK(faces([](Json& d) {
          d["scenes"] = Json::parse(R"([{"nodes": [2]}, {"nodes": [1, 2]}])");
          d["scene"] = 1;
        }) == 4);
  CHECK(faces([](Json& d) { d.erase("scenes"); }) == 4);
  check_warned(read([](Json& d) { d["scenes"][0].erase("nodes"); }), "the scene is empty");
}

TEST_CASE("glTF: points, lines, skins and targets are warned about") {
  const MeshFile points = read([](Json& d) { primitive(d)["mode"] = 0; });
  check_warned(points, "1 primitive of points or lines not read");
  check_warned(points, "the scene is empty");
  check_warned(read([](Json& d) { d["nodes"][0]["skin"] = 0; }), "not applied: the mesh is as it is at rest");
}

TEST_CASE("glTF: integers as positions, where they are normalized and where not") {
  const auto as_bytes = [](bool normalized) {
    return read([&](Json& d) {
             d["accessors"][0] = {{"bufferView", 1},
                                  {"componentType", 5121},
                                  {"count", 2},
                                  {"type", "VEC3"},
                                  {"normalized", normalized}};
             d["accessors"][2]["count"] = 3;
             d["accessors"][2]["bufferView"] = 0;  // three zeros
             d["extensionsRequired"] = {"KHR_mesh_quantization"};
           })
        .mesh.vertices;
  };
  CHECK(as_bytes(false) == std::vector<Point3>{{0, 1, 2}, {0, 2, 3}});
  CHECK(as_bytes(true) == std::vector<Point3>{{0, 1 / 255.0, 2 / 255.0}, {0, 2 / 255.0, 3 / 255.0}});
}

TEST_CASE("glTF: nodes that contain themselves, or are in two places") {
  check_refusal("node 0 is in two places", [](Json& d) { d["nodes"][0]["children"] = {0}; });
  check_refusal("node 1 is in two places",
                [](Json& d) { d["nodes"] = Json::parse(R"([{"children": [1, 1]}, {"mesh": 0}])"); });
  check_refusal("number 7 of 1 nodes is asked for", [](Json& d) { d["nodes"][0]["children"] = {7}; });
  std::string chain = R"([{"mesh": 0})";
  for (int i = 1; i < 100000; ++i) chain += ", {\"children\": [" + std::to_string(i - 1) + "]}";
  CHECK(read([&](Json& d) {
          d["nodes"] = Json::parse(chain + "]");
          d["scenes"][0]["nodes"] = {99999};
        }).mesh.face_count() == 2);
}

TEST_CASE("glTF: what leads nowhere") {
  check_refusal("a corner names vertex 2 of 2, counted from 0", [](Json& d) { d["accessors"][0]["count"] = 2; });
  check_refusal("an accessor goes beyond its bufferView", [](Json& d) { d["accessors"][0]["count"] = 9; });
  check_refusal("an accessor goes beyond its bufferView",
                [](Json& d) { d["accessors"][0]["count"] = std::numeric_limits<std::uint64_t>::max(); });
  check_refusal("an accessor goes beyond",
                [](Json& d) { d["accessors"][0]["byteOffset"] = std::numeric_limits<std::uint64_t>::max(); });
  check_refusal("-1 is no count or index", [](Json& d) { d["accessors"][0]["count"] = -1; });
  check_refusal("1.5 is no count or index", [](Json& d) { d["accessors"][0]["count"] = 1.5; });
  check_refusal("a bufferView goes beyond its buffer", [](Json& d) { d["bufferViews"][1]["byteLength"] = 7; });
  check_refusal("a bufferView goes beyond its buffer",
                [](Json& d) { d["bufferViews"][1]["byteOffset"] = std::numeric_limits<std::uint64_t>::max() - 2; });
  check_refusal("number 9 of 3 accessors", [](Json& d) { primitive(d)["indices"] = 9; });
  check_refusal("a byteStride is no stride", [](Json& d) { d["bufferViews"][0]["byteStride"] = 4; });
  check_refusal("the unknown componentType 5124", [](Json& d) { d["accessors"][0]["componentType"] = 5124; });
  check_refusal("is no VEC3", [](Json& d) { d["accessors"][0]["type"] = "VEC2"; });
  check_refusal("an accessor of indices has another type", [](Json& d) {
    d["accessors"][2]["componentType"] = 5126;
    d["accessors"][2]["count"] = 1;
  });
  check_refusal("is sparse, or has no bufferView", [](Json& d) { d["accessors"][0].erase("bufferView"); });
  check_refusal("a list of triangles has 5 corners", [](Json& d) { d["accessors"][2]["count"] = 5; });
  check_refusal("the unknown mode 7", [](Json& d) { primitive(d)["mode"] = 7; });
  check_refusal("the member POSITION is missing", [](Json& d) { primitive(d)["attributes"].erase("POSITION"); });
  check_refusal("primitives is no list", [](Json& d) { d["meshes"][0]["primitives"] = 1; });
  check_refusal("the matrix of a node is not affine",
                [](Json& d) { d["nodes"][0]["matrix"] = std::vector<int>(16, 1); });
  check_refusal("a list of 3 numbers is needed", [](Json& d) { d["nodes"][0]["scale"] = {1, 2}; });
  check_refusal("a coordinate is not finite", [](Json& d) {
    d["nodes"][0]["scale"] = {1e308, 1, 1};
    d["nodes"].push_back({{"scale", {1e308, 1, 1}}, {"children", {0}}});
    d["scenes"][0]["nodes"] = {1};
  });
}

TEST_CASE("glTF: other versions and extensions") {
  check_refusal("glTF is read in version 2.0, not \"1.0\"", [](Json& d) { d["asset"]["version"] = "1.0"; });
  check_refusal("it needs the extension \"KHR_draco_mesh_compression\", which is not read",
                [](Json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; });
  CHECK(refusal_of(changed([](Json& d) { d["extensionsRequired"] = {"KHR_materials_unlit"}; })) == "read");
  check_refused("{\"asset\": {\"version\": \"2.0\"}", "the JSON is none");
  check_refused("glTF" + raw(1) + raw(20) + raw(0), "binary glTF is read in version 2, not 1");
  check_refused("glTF" + raw(2) + raw(0xFFFFFFFFU) + raw(0), "the file ends before its chunks do");
  check_refused("glTF" + raw(2) + raw(20) + raw(0xFFFFFFFFU) + "JSON", "the first chunk is no JSON");
  check_refused("{\"asset\": " + std::string(100000, '['), "the JSON is none");
}

TEST_CASE("glTF: of other files only those beside it are opened, by plain names") {
  const TemporaryFolder folder;
  const auto refused_with = [&](const std::string& uri) {
    const std::string file = folder.file("a.gltf", changed([&](Json& d) { d["buffers"][0]["uri"] = uri; }));
    try {
      (void)import_mesh(std::filesystem::path(file), {}, Normals::passed_over);
      return std::string("read");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  CHECK(refused_with("square.bin").find("the buffer \"square.bin\" is not beside the mesh; ") != std::string::npos);
  (void)folder.file("square.bin", square_bytes());
  CHECK(refused_with("square.bin") == "read");
  CHECK(refused_with("squar%65.bin") == "read");
  std::filesystem::create_directory(folder.path() / "beneath");
  for (const char* uri : {"../square.bin", "./square.bin", "/dev/zero", "file:square.bin", "beneath/../square.bin",
                          "..", "", "..%2fsquare.bin", "C:\\square.bin", "square.bin%00"}) {
    INFO(uri);
    CHECK(refused_with(uri).find("only files beside the mesh are opened, by their plain name") != std::string::npos);
  }
  CHECK(refused_with("beneath").find("is not beside the mesh") != std::string::npos);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "zero.bin");
  CHECK(refused_with("zero.bin").find("is not beside the mesh") != std::string::npos);
  check_refusal("is in another file", [](Json& d) { d["buffers"][0]["uri"] = "square.bin"; });
  check_refusal("a buffer in the JSON is not in base64", [](Json& d) { d["buffers"][0]["uri"] = "data:,abc"; });
}

TEST_CASE("glTF: instances stop at the limit on memory") {
  std::string nodes = "[";
  for (int i = 0; i < 30000; ++i) nodes += std::string(i == 0 ? "" : ", ") + "{\"mesh\": 0}";
  const std::string bytes = changed([&](Json& d) {
    d["nodes"] = Json::parse(nodes + "]");
    d.erase("scenes");
  });
  check_refused(bytes, "bytes of memory, and the limit is 33554432; raise it", {std::uint64_t{1} << 25});
}

}  // namespace sightline::tests::gltf_reader_test
