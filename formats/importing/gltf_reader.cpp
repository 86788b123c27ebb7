#include "formats/importing/gltf_reader.h"

#include <array>
#include <optional>
#include <vector>

#include "formats/importing/placement.h"
#include "formats/reading/mesh_collector.h"
#include "formats/reading/mesh_warnings.h"

namespace sightline::inline formats {

namespace {

// The maps of nodes.
Placement placement_of_matrix(const nlohmann::json& matrix) {
  const std::vector<double> m = numbers(matrix, 16);
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) throw GltfError("the matrix of a node is not affine");
  return {{Vector3{m[0], m[1], m[2]}, Vector3{m[4], m[5], m[6]}, Vector3{m[8], m[9], m[10]}},
          Vector3{m[12], m[13], m[14]}};
}

Placement placement_of_rotation(const std::vector<double>& q) {
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  const double w = q[3];
  Placement turned;
  turned.axes = {Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                 Vector3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                 Vector3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
  return turned;
}

Placement placement_of(const nlohmann::json& node) {
  if (node.contains("matrix")) return placement_of_matrix(node.at("matrix"));
  Placement placement;
  if (node.contains("rotation")) placement = placement_of_rotation(numbers(node.at("rotation"), 4));
  if (node.contains("scale")) {
    const std::vector<double> scale = numbers(node.at("scale"), 3);
    for (std::size_t i = 0; i < 3; ++i) placement.axes[i] = scale[i] * placement.axes[i];
  }
  if (node.contains("translation")) {
    const std::vector<double> origin = numbers(node.at("translation"), 3);
    placement.origin = {origin[0], origin[1], origin[2]};
  }
  return placement;
}

class GltfParser {
 public:
  GltfParser(GltfDocument& document, const InputBytes& name, const ReadLimits& limits, Normals normals)
      : document_(document), json_(document.json()), mesh_(name, limits, normals), normals_(normals) {}

  MeshFile parse();

 private:
  struct Placed {
    std::uint64_t node;
    Placement parent;
  };
  [[nodiscard]] std::vector<std::uint64_t> roots() const;
  [[nodiscard]] std::vector<std::uint64_t> nodes_without_parent() const;
  void push(const nlohmann::json& nodes, const Placement& parent);
  void parse_node(const Placed& placed);
  void parse_mesh(const nlohmann::json& mesh, const Placement& placement);
  void parse_primitive(const nlohmann::json& primitive, const Placement& placement);
  void add_vertices(const nlohmann::json& attributes, const Placement& placement);
  void add_triangles(std::uint64_t mode, const std::optional<GltfRows>& indices, bool mirrored);
  void add_triangle(const std::array<std::uint64_t, 3>& corners, const std::optional<GltfRows>& indices, bool mirrored);
  void warn_about_rest();

  GltfDocument& document_;
  const nlohmann::json& json_;
  MeshCollector mesh_;
  const Normals normals_;
  std::vector<Placed> open_;
  std::vector<bool> visited_;
  std::uint64_t first_ = 0;  // vertex of the primitive
  std::uint64_t count_ = 0;  // of its vertices
  std::uint64_t vertices_ = 0;
  std::size_t other_primitives_ = 0;
  std::size_t deformed_ = 0;
};

MeshFile GltfParser::parse() {
  if (json_.contains("nodes")) visited_.resize(list(json_, "nodes").size());
  push(roots(), {});
  while (!open_.empty()) {
    const Placed placed = open_.back();
    open_.pop_back();
    parse_node(placed);
  }
  warn_about_rest();
  return std::move(mesh_).finish();
}

std::vector<std::uint64_t> GltfParser::nodes_without_parent() const {
  std::vector<bool> is_child(visited_.size());
  for (std::size_t n = 0; n < visited_.size(); ++n) {
    const nlohmann::json& node = item(json_, "nodes", n);
    if (!node.contains("children")) continue;
    for (const nlohmann::json& child : list(node, "children")) {
      if (whole_number(child) < is_child.size()) is_child[whole_number(child)] = true;
    }
  }
  std::vector<std::uint64_t> found;
  for (std::size_t n = 0; n < is_child.size(); ++n) {
    if (!is_child[n]) found.push_back(n);
  }
  return found;
}

std::vector<std::uint64_t> GltfParser::roots() const {
  if (!json_.contains("scenes")) return nodes_without_parent();
  const nlohmann::json& scene = item(json_, "scenes", whole_number(json_, "scene", 0));
  std::vector<std::uint64_t> found;
  if (!scene.contains("nodes")) return found;
  for (const nlohmann::json& node : list(scene, "nodes")) found.push_back(whole_number(node));
  return found;
}

// The first of them comes next.
void GltfParser::push(const nlohmann::json& nodes, const Placement& parent) {
  for (std::size_t i = nodes.size(); i-- > 0;) open_.push_back({whole_number(nodes[i]), parent});
}

void GltfParser::parse_node(const Placed& placed) {
  const nlohmann::json& node = item(json_, "nodes", placed.node);
  if (!node.is_object()) throw GltfError("node " + std::to_string(placed.node) + " is none");
  if (visited_[placed.node]) throw GltfError("node " + std::to_string(placed.node) + " is in two places");
  visited_[placed.node] = true;
  const Placement placement = placed.parent * placement_of(node);
  if (node.contains("skin")) ++deformed_;
  if (node.contains("mesh")) parse_mesh(item(json_, "meshes", whole_number(node.at("mesh"))), placement);
  if (node.contains("children")) push(list(node, "children"), placement);
}

void GltfParser::parse_mesh(const nlohmann::json& mesh, const Placement& placement) {
  for (const nlohmann::json& primitive : list(mesh, "primitives")) parse_primitive(primitive, placement);
}

void GltfParser::parse_primitive(const nlohmann::json& primitive, const Placement& placement) {
  const std::uint64_t mode = whole_number(primitive, "mode", 4);
  if (mode < 4) {
    ++other_primitives_;
    return;
  }
  if (mode > 6) throw GltfError("a primitive has the unknown mode " + std::to_string(mode));
  if (primitive.contains("targets")) ++deformed_;
  add_vertices(member(primitive, "attributes"), placement);
  std::optional<GltfRows> indices;
  if (primitive.contains("indices")) indices = document_.indices(whole_number(primitive.at("indices")));
  add_triangles(mode, indices, placement.mirrors());
}

Vector3 row_of(const GltfRows& rows, std::uint64_t row) {
  return {rows.number(row, 0), rows.number(row, 1), rows.number(row, 2)};
}

void GltfParser::add_vertices(const nlohmann::json& attributes, const Placement& placement) {
  const GltfRows positions = document_.vectors(whole_number(member(attributes, "POSITION")));
  std::optional<GltfRows> normals;
  if (normals_ == Normals::read && attributes.contains("NORMAL"))
    normals = document_.vectors(whole_number(attributes.at("NORMAL")));
  first_ = vertices_;
  count_ = positions.count();
  mesh_.expect(first_ + count_, 0);
  if (normals && normals->count() < count_) throw GltfError("there are fewer normals than positions");
  for (std::uint64_t v = 0; v < count_; ++v)
    mesh_.add_vertex(placement.point(row_of(positions, v)),
                     normals ? placement.normal(row_of(*normals, v)) : Vector3::Zero());
  vertices_ += count_;
}

void GltfParser::add_triangle(const std::array<std::uint64_t, 3>& corners, const std::optional<GltfRows>& indices,
                              bool mirrored) {
  for (const std::size_t i : mirrored ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2}) {
    const std::uint64_t index = indices ? indices->index(corners[i]) : corners[i];
    if (index >= count_)
      throw GltfError("a corner names vertex " + std::to_string(index) + " of " + std::to_string(count_) +
                      ", counted from 0");
    mesh_.add_corner(static_cast<std::int64_t>(first_ + index), first_ + count_);
  }
  mesh_.end_face();
}

void GltfParser::add_triangles(std::uint64_t mode, const std::optional<GltfRows>& indices, bool mirrored) {
  const std::uint64_t corners = indices ? indices->count() : count_;
  if (mode == 4) {
    if (corners % 3 != 0) throw GltfError("a list of triangles has " + std::to_string(corners) + " corners");
    for (std::uint64_t i = 0; i < corners; i += 3) add_triangle({i, i + 1, i + 2}, indices, mirrored);
    return;
  }
  for (std::uint64_t i = 0; i + 2 < corners; ++i) {
    if (mode == 5) add_triangle({i, i + 1 + i % 2, i + 2 - i % 2}, indices, mirrored);
    if (mode == 6) add_triangle({i + 1, i + 2, 0}, indices, mirrored);
  }
}

void GltfParser::warn_about_rest() {
  if (other_primitives_ > 0) mesh_.warn(counted(other_primitives_, "primitive") + " of points or lines not read");
  if (deformed_ > 0)
    mesh_.warn(counted(deformed_, "skin or morph target") + " not applied: the mesh is as it is at rest");
}

}  // namespace

MeshFile read_gltf(std::string_view bytes, const std::string& file_name, const FileBeside& file_beside,
                   const ReadLimits& limits, Normals normals) {
  InputBytes name(std::string_view(), file_name);
  name.name_no_place();
  try {
    GltfDocument document(bytes, file_beside);
    return GltfParser(document, name, limits, normals).parse();
  } catch (const GltfError& error) {
    name.fail(std::string(error.what()) + "; export the glTF again, or save it as PLY");
  } catch (const nlohmann::json::exception&) {
    name.fail("the JSON is not as glTF 2.0 says; export the glTF again, or save it as PLY");
  }
}

}  // namespace sightline::inline formats
