#include "formats/reading/mesh_format.h"

#include <doctest/doctest.h>

#include <utility>

#include "tests/tools/command_runner.h"
#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::mesh_format_test {
namespace {

using namespace std::string_literals;

const std::vector<std::pair<std::string, std::string>> foreign{
    {"\x1F\x8B\x08\x00"s, "a gzip archive is not read here; unpack it"},
    {"BZh91AY", "a bzip2 archive"},
    {"\xFD"s + "7zXZ\0"s, "an xz archive"},
    {"\x28\xB5\x2F\xFD", "a zstd archive"},
    {"7z\xBC\xAF\x27\x1C", "a 7z archive"},
    {"Rar!\x1A\x07\x00"s, "a RAR archive"},
    {std::string(257, 'x') + "ustar", "a tar archive"},
    {"PK\x03\x04"s + std::string(26, '\0') + "mesh.obj", "a ZIP archive is not read here; unpack it"},
    {"%PDF-1.7", "a PDF document"},
    {"\x89PNG\r\n\x1A\n", "a PNG image"},
    {"\xFF\xD8\xFF\xE0", "a JPEG image"},
    {"GIF89a", "a GIF image"},
    {"II*\0"s, "a TIFF image"},
    {"ISO-10303-21;\nHEADER;",
     "a STEP file (curved surfaces) is not read here; save it as STL or OBJ from a CAD program"},
    {std::string(72, ' ') + "S      1\n", "an IGES file"},
    {"Kaydara FBX Binary  \x00"s, "an FBX file is not read here; save the mesh as PLY, STL or OBJ"},
    {"; FBX 7.4.0 project file", "an FBX file"},
    {"BLENDER-v293", "a Blender file"},
    {"#VRML V2.0 utf8\n", "a VRML file"},
    {"# vtk DataFile Version 3.0\n", "a VTK file"},
    {"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"\">", "a COLLADA file (DAE)"},
    {"<X3D>", "an X3D file"},
    {"<?xml version=\"1.0\"?><amf unit=\"inch\">", "an AMF file"},
    {"<?xml version=\"1.0\"?><note/>", "XML of a kind that is not known"},
    {"#usda 1.0\n", "a USD file"},
    {"PXR-USDC", "a USD file"},
    {"DRACO\x02\x02", "a Draco file"},
    {"  0\nSECTION\n  2\nHEADER\n", "a DXF file"},
    {"\x89HDF\r\n\x1A\n", "an HDF5 file"},
    {"3D Geometry File Format ", "a Rhino file"},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "a compound document"},
    {"# a scene\n[mesh]\nfile = \"a.obj\"\n", "a scene file is not read here; give a mesh"},
};

}  // namespace

TEST_CASE("files of other kinds are named, with what to do") {
  for (const auto& [bytes, message] : foreign) {
    CHECK(format_of(bytes, bytes.size()).format == MeshFormat::other);
    CHECK(format_of(bytes, std::nullopt).format == MeshFormat::other);
    check_refused(bytes, message);
  }
}

TEST_CASE("the name of a file does not say what it is") {
  const TemporaryFolder folder;
  const std::filesystem::path formats = std::filesystem::path(SIGHTLINE_FIXTURES_DIR) / "formats";
  for (const char* file : {"house.glb", "binary.stl", "text.stl", "big_endian.ply", "house.off", "house.obj"}) {
    const std::string mesh = folder.file("any.obj", bytes_in(formats / file));
    CHECK(import_mesh(std::filesystem::path(mesh), {}, Normals::passed_over).mesh.vertices.size() == 9);
  }
}

TEST_CASE("text that is of no other format is OBJ") {
  for (const std::string text :
       {"", "v 0 0 0\n", "# OFF\nv 0 0 0\n", "plywood", "solids", "s off\n", "{\"positions\": []}", "# a text\nsolid x",
        "g glTF\n", "v 0 0 0\nOFF\n", "OFFICE 1", "\xFF\xFEv"}) {
    INFO(text);
    CHECK(format_of(text, text.size()).format == MeshFormat::obj);
  }
  CHECK(format_of(std::string(4096, '\0'), std::nullopt).format == MeshFormat::obj);
}

TEST_CASE("binary STL and text that begins with solid, with and without a size") {
  const std::string header = "solid name" + std::string(70, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  CHECK(format_of(header, header.size()).format == MeshFormat::stl_binary);
  CHECK(format_of(header, std::nullopt).format == MeshFormat::stl_binary);
  CHECK(format_of(header, header.size() + 1).format == MeshFormat::other);
  const std::string text = "solid name\nfacet normal 0 0 1\n" + std::string(100, ' ');
  CHECK(format_of(text, text.size()).format == MeshFormat::stl_text);
  CHECK(format_of(text, std::nullopt).format == MeshFormat::stl_text);
}

TEST_CASE("the command refuses a file of another kind with one line") {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("part.obj", "ISO-10303-21;\nHEADER;\n");
  const RunResult run = run_sightline({"analyze", mesh, "--eye=0,0,5", "--target=0,0,0", "--fov-y=40", "--json"});
  CHECK(run.exit_code == 1);
  CHECK(run.err == "sightline: " + mesh +
                       ": a STEP file (curved surfaces) is not read here; save it as STL or OBJ from a CAD program\n");
}

}  // namespace sightline::tests::mesh_format_test
