// This is the policy for the public collection of malformed OBJ files, one table row per file.
#include <doctest/doctest.h>

#include "tests/tools/command_case.h"

namespace sightline::tests::bad_obj_test {

namespace {

const std::vector<ObjCase> empty_scenes{
    reads("own/empty.obj", 0),
    reads("own/whitespace_only.obj", 0),
    reads("own/comments_only.obj", 0),
    reads("own/no_faces.obj", 0),
    reads("assimp_point_cloud.obj", 0),
    with_warning(reads("tinyobj_points-prim.obj", 0), "is not beside the mesh"),
    with_warning(reads("tinyobj_line-prim.obj", 0), "is not beside the mesh"),
    reads("trimesh_face_in_group_name.obj", 0),
};

const std::vector<ObjCase> index_cases{
    fails("own/faces_without_vertices.obj", 1, "vertex 1 of 0"),
    fails("own/index_out_of_range.obj", 4, "vertex 4 of 3"),
    fails("own/index_negative_out_of_range.obj", 4, "\"-4\""),
    fails("own/index_zero.obj", 4, "\"0\""),
    reads("own/forward_reference.obj", 1, 0.5),
    reads("own/index_negative_relative_to_line.obj", 2, 1),
    fails("own/index_2p31.obj", 4, "2147483648"),
    fails("own/index_2p32_plus_3.obj", 4, "4294967299"),
    fails("own/index_2p63.obj", 4, "9223372036854775808"),
    fails("own/index_minus_2p63.obj", 4, "-9223372036854775808"),
    fails("own/index_2p64_plus_3.obj", 4, "18446744073709551619"),
    fails("own/index_not_integer.obj", 4, "\"1.0\""),
    fails("own/index_slash_garbage.obj", 4, "\"/\""),
    with_defect(with_warning(reads("own/index_slash_forms.obj", 1, 0.5),
                             "1 face with texture or normal indices that name nothing: 2"),
                Defect::repeated_face, {1, 2}),
    fails("assimp_malformed.obj", 28, "\"0\""),
    fails("tinyobj_invalid-relative-vertex-index.obj", 1, "\"-4\""),
    fails("tinyobj_invalid-relative-texture-index.obj", 2, "vertex 1 of 0"),
    fails("tinyobj_issue-140-zero-face-idx.obj", 16, "\"0/0/0\""),
    fails("tobj_invalid_index.obj", 12, "vertex 7 of 6"),
    reads("trimesh_negative_indices.obj", 6, 24),
};

const std::vector<ObjCase> number_cases{
    fails("own/coord_nan.obj", 2, "\"nan\" is not finite"),
    fails("own/coord_inf.obj", 2, "\"inf\" is not finite"),
    fails("own/coord_1e999.obj", 2, "\"1e999\" is beyond"),
    fails("own/coord_not_number.obj", 2, "\"one\""),
    fails("own/coord_hexfloat.obj", 2, "\"0x1p0\""),
    reads("own/coord_1e-999.obj", 1, 0.5),
    reads("own/coord_denormal.obj", 2),
    reads("own/coord_1e30.obj", 1),
    reads("own/coord_1e300.obj", 1),
    reads("own/coord_mixed_scale.obj", 3),
    reads("own/coord_offset_1e7.obj", 1),
    reads("own/coord_rounding.obj", 1),
    reads("own/coord_10000_digits.obj", 1),
    fails("own/coord_missing.obj", 2, "three coordinates"),
    fails("own/coord_none.obj", 1, "three coordinates"),
    reads("own/coord_extra.obj", 1, 0.5),
    reads("own/coord_w_zero.obj", 1, 0.5),
    fails("own/nul_in_line.obj", 2, "\"0\\x00\""),
    fails("assimp_number_formats.obj", 11, "\"3.1+e2\""),
    reads("assimp_only_a_part_of_vertexcolors.obj", 3),
    reads("trimesh_nancolor.obj", 12, 6),
    fails("tinyobj_clusterfuzz-4877060179886080.obj", 1, "\"3E4570711268\\x00\""),
    with_warning(reads("tinyobj_leading-decimal-dot-issue-201.obj", 1), "is not beside the mesh"),
    with_warning(reads("tinyobj_leading-zero-in-exponent-notation-issue-210.obj", 1), "is not beside the mesh"),
    fails("tinyobj_test-nan.obj", 12, "\"nan\" is not finite"),
    with_warning(reads("tinyobj_cube-vertex-w-component.obj", 6, 24), "is not beside the mesh"),
    fails("draco_inf_nan.obj", 1, "\"inf\" is not finite"),
    fails("pymesh_polygon.obj", 1, "three coordinates"),
};

const std::vector<ObjCase> text_cases{
    with_warning(reads("own/nul_padding_at_end.obj", 1, 0.5), "1 statement not understood, from line 5"),
    with_warning(reads("own/binary_tail.obj", 1, 0.5), "2 statements not understood, from line 5"),
    reads("own/crlf.obj", 1, 0.5),
    reads("own/cr_only.obj", 1, 0.5),
    reads("own/mixed_line_ends.obj", 1, 0.5),
    reads("own/no_final_newline.obj", 1, 0.5),
    reads("own/bom_utf8.obj", 1, 0.5),
    fails("own/bom_utf16le.obj", 1, "UTF-16 (little endian)"),
    reads("own/long_comment_line.obj", 1, 0.5),
    with_defect(reads("own/line_continuation.obj", 1, 0.5), Defect::too_few_corners, {1}),
    reads("own/line_continuation_crlf.obj", 1, 0.5),
    reads("own/line_continuation_at_end.obj", 1, 0.5),
    fails("own/trailing_garbage.obj", 5, "\"x\""),
    with_warning(reads("own/mtllib_missing.obj", 1, 0.5), "is not beside the mesh"),
    with_warning(reads("own/mtllib_outside.obj", 1, 0.5), "is not opened"),
    with_warning(reads("own/keyword_forms.obj", 1, 0.5), "4 statements not understood, from line 1"),
    with_warning(reads("own/unknown_keywords.obj", 1, 0.5), "5 statements not understood, from line 1"),
    fails("own/not_obj_json.obj", 1, "no statement has an OBJ keyword"),
    fails("assimp_box_UTF16BE.obj", 1, "UTF-16 (big endian)"),
    reads("assimp_box_without_lineending.obj", 6, 6),
    reads("assimp_multiple_spaces.obj", 1),
    reads("assimp_testmixed.obj", 6, 6),
    fails("assimp_clusterfuzz-4751812606885888.bin", 11, "\"/2\""),
    with_warning(reads("tinyobj_mtllib-multiple-files-issue-112.obj", 1), "is not beside the mesh"),
    with_warning(reads("trimesh_jacked.obj", 12, 6), "is not beside the mesh"),
    reads("draco_empty_name.obj", 1),
    reads("draco_eof_test.obj", 1),
    reads("tobj_empty_name_triangle.obj", 1, 0.5),
    with_warning(reads("trimesh_face_in_group_name_mid_file.obj", 2),
                 "1 face with texture or normal indices that name nothing: 0"),
    reads("o3dv_two_meshes_with_same_name.obj", 2, 1),
};

// As OBJ they are refused; the command, which does not ask for their names, reads them as what they are.
const std::vector<ObjCase> other_formats{
    fails("own/not_obj_stl.obj", 1, "no statement has an OBJ keyword"),
};
const std::vector<ObjCase> other_formats_in_the_command{
    reads("own/not_obj_stl.obj", 1, 0.5),
};

const std::vector<ObjCase> defect_cases{
    with_defect(reads("own/face_too_few_vertices.obj", 1, 0.5), Defect::too_few_corners, {0, 1, 2}),
    with_defect(with_defect(reads("own/face_repeated_vertex.obj", 2, 1), Defect::too_few_corners, {0, 1, 2}),
                Defect::repeated_corner, {3, 4}),
    with_defect(with_defect(reads("own/face_zero_area.obj", 1), Defect::zero_area, {0, 2}), Defect::too_few_corners,
                {1}),
    reads("own/face_almost_zero_area.obj", 1),
    with_defect(reads("own/duplicate_faces.obj", 4, 2.5), Defect::repeated_face, {1}),
    with_defect(reads("own/duplicate_vertices.obj", 2, 1), Defect::zero_area, {2}),
    with_defect(reads("own/quad_bowtie.obj", 0), Defect::self_crossing, {0}),
    with_defect(reads("assimp_malformed2.obj", 5, 5), Defect::too_few_corners, {0}),
    with_defect(reads("assimp_box_longline.obj", 5, 5), Defect::self_crossing, {0}),
    with_defect(with_warning(reads("tinyobj_invalid-face-definition.obj", 0), "is not beside the mesh"),
                Defect::too_few_corners, {0, 1}),
    with_defect(reads("draco_degenerate_mesh.obj", 0), Defect::too_few_corners, {0}),
    with_defect(reads("draco_deg_faces.obj", 3), Defect::too_few_corners, {3}),
    with_defect(with_warning(reads("trimesh_notenoughindices.obj", 1, 250000), "is not beside the mesh"),
                Defect::too_few_corners, {0}),
    reads("trimesh_joined_tetrahedra.obj", 8),
    reads("libigl_degenerated.obj", 24, 12),
};

const std::vector<ObjCase> polygon_cases{
    reads("own/face_5000_vertices.obj", 1),
    reads("own/quad_nonplanar.obj", 2),
    with_defect(reads("own/quad_concave.obj", 2, 1), Defect::repeated_face, {1}),
    with_defect(reads("own/ngon_concave.obj", 4, 3), Defect::repeated_face, {1}),
    reads("own/ngon_spiral.obj", 10, 15),
    reads("own/ngon_collinear_start.obj", 1, 4),
    reads("own/ngon_vertical.obj", 3, 2.5),
    reads("own/ngon_keyhole.obj", 8, 12),
    with_warning(reads("assimp_concave_polygon.obj", 64), "is not beside the mesh"),
    reads("tinyobj_issue-295-trianguation-failure.obj", 14, 14),
    with_defect(reads("tinyobj_issue-319-002.obj", any_count), Defect::repeated_corner, {2}),
    reads("tinyobj_issue-319-003.obj", 8),
    reads("tinyobj_issue-330.obj", 2 + 1),
    reads("draco_non_manifold_wrap.obj", 12),
    reads("draco_octagon_preserved.obj", 6),
    with_warning(reads("trimesh_polygonfaces.obj", 3), "is not beside the mesh"),
    with_warning(reads("trimesh_wallhole.obj", any_count), "is not beside the mesh"),
};

struct SharedFolder {
  std::filesystem::path path = shared_folder("bad-obj");

  [[nodiscard]] bool is_there() const {
    if (path.empty()) MESSAGE("skipped: no folder of malformed OBJ files");
    return !path.empty();
  }
};

TEST_CASE_FIXTURE(SharedFolder, "collection: every file has a case") {
  if (!is_there()) return;
  std::vector<std::string> files = files_in(path);
  for (const std::string& file : files_in(path / "own")) files.push_back("own/" + file);
  std::ranges::sort(files);
  CHECK(files ==
        files_of({empty_scenes, index_cases, number_cases, text_cases, other_formats, defect_cases, polygon_cases}));
}

TEST_CASE_FIXTURE(SharedFolder, "collection: empty scenes") {
  if (is_there()) check_cases(path, empty_scenes);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: indices") {
  if (is_there()) check_cases(path, index_cases);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: numbers") {
  if (is_there()) check_cases(path, number_cases);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: lines, encodings and keywords") {
  if (is_there()) check_cases(path, text_cases);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: files of other formats") {
  if (!is_there()) return;
  check_cases(path, other_formats);
  for (const ObjCase& c : other_formats_in_the_command) check_command(path, c);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: faces with a defect") {
  if (is_there()) check_cases(path, defect_cases);
}
TEST_CASE_FIXTURE(SharedFolder, "collection: polygons") {
  if (is_there()) check_cases(path, polygon_cases);
}

TEST_CASE_FIXTURE(SharedFolder, "collection: mutated files are refused, or read to a valid mesh") {
  if (!is_there()) return;
  std::size_t refused = 0;
  const std::vector<std::string> files = files_in(path / "afl");
  for (const std::string& file : files) {
    INFO("file: " << file);
    try {
      CHECK(validate(read_obj(path / "afl" / file).mesh) == std::vector<std::string>{});
    } catch (const InputError& error) {
      CHECK(is_one_line(error.what()));
      ++refused;
    }
  }
  CHECK(refused > files.size() / 2);
}

TEST_CASE_FIXTURE(SharedFolder, "collection: the command does with every file what its row says") {
  if (!is_there()) return;
  for (const auto& table : {empty_scenes, index_cases, number_cases, text_cases, defect_cases, polygon_cases}) {
    for (const ObjCase& c : table) check_command(path, c);
  }
  for (const std::string& file : files_in(path / "afl")) check_command_does_as_reader(path / "afl" / file);
}

// Each edge of a closed surface has an even number of faces.
TEST_CASE_FIXTURE(SharedFolder, "collection: a closed box of concave walls stays closed, and uses every corner") {
  if (!is_there()) return;
  const Mesh mesh = read_obj(path / "trimesh_wallhole.obj").mesh;
  std::vector<int> uses(mesh.edges.size());
  for (const MeshEdgeId e : mesh.facet_edges) ++uses[e.index()];
  CHECK(std::ranges::all_of(uses, [](int n) { return n % 2 == 0; }));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<VertexId> used;
    for (std::size_t i = mesh.first_facet(FaceId(f)); i < mesh.end_facet(FaceId(f)); ++i) {
      used.insert(used.end(), mesh.facets[i].begin(), mesh.facets[i].end());
    }
    CHECK(std::ranges::all_of(mesh.faces[f], [&](VertexId v) { return std::ranges::find(used, v) != used.end(); }));
  }
}

}  // namespace

}  // namespace sightline::tests::bad_obj_test
