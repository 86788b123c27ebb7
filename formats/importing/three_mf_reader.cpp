#include "formats/importing/three_mf_reader.h"

#include "formats/reading/input_bytes.h"
#include "geometry/numbers/errors.h"

#ifdef SIGHTLINE_HAS_EXPAT

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "formats/importing/packed_bytes.h"
#include "formats/importing/placement.h"
#include "formats/importing/xml_events.h"
#include "formats/reading/mesh_collector.h"

namespace sightline::inline formats {

namespace {

// Objects may be placed within objects: a small file can ask for any number of them.
constexpr std::size_t most_placed = 1000000;

constexpr std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
constexpr std::string_view production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view materials = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";

struct PlacedObject {
  std::size_t object;  // its place in the list of them
  Placement placement;
};

struct ThreeMfObject {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<PlacedObject> components;
};

struct ThreeMfModel {
  std::vector<ThreeMfObject> objects;
  std::vector<PlacedObject> items;
};

std::string_view required(const XmlAttributes& attributes, std::string_view name) {
  const auto value = attributes.find(name);
  if (!value) throw std::runtime_error("the attribute " + std::string(name) + " is missing");
  return *value;
}

double number_of(std::string_view text) { return parse_coordinate(text); }

std::uint32_t id_of(std::string_view text) {
  const auto id = parse_integer(text);
  if (!id || *id < 0 || *id > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error(quoted(text) + " is no index or id");
  return static_cast<std::uint32_t>(*id);
}

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks_of_xml = " \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(blanks_of_xml); at < text.size();
       at = text.find_first_not_of(blanks_of_xml, at)) {
    const std::size_t end = std::min(text.find_first_of(blanks_of_xml, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

// Twelve numbers: the images of the axes, and of the origin.
Placement transform_of(const XmlAttributes& attributes) {
  const auto text = attributes.find("transform");
  if (!text) return {};
  std::vector<double> m;
  for (const std::string_view word : words_of(*text)) m.push_back(number_of(word));
  if (m.size() != 12) throw std::runtime_error("a transform needs 12 numbers");
  return {{Vector3{m[0], m[1], m[2]}, Vector3{m[3], m[4], m[5]}, Vector3{m[6], m[7], m[8]}},
          Vector3{m[9], m[10], m[11]}};
}

class ModelParser {
 public:
  explicit ModelParser(const MeshCollector& mesh) : mesh_(mesh) {}

  void start(std::string_view element, const XmlAttributes& attributes);
  void end(std::string_view element);
  void name_space(std::string_view prefix, std::string_view name) { name_spaces_[std::string(prefix)] = name; }
  [[nodiscard]] ThreeMfModel result() && { return std::move(model_); }

 private:
  void check_extensions(const XmlAttributes& attributes) const;
  void start_object(const XmlAttributes& attributes);
  void add_vertex(const XmlAttributes& attributes);
  void add_triangle(const XmlAttributes& attributes);
  [[nodiscard]] PlacedObject placed(const XmlAttributes& attributes);
  ThreeMfObject& object();

  const MeshCollector& mesh_;
  ThreeMfModel model_;
  std::map<std::uint32_t, std::size_t> by_id_;  // those that are complete
  std::map<std::string, std::string> name_spaces_;
  std::uint32_t id_ = 0;
  bool in_object_ = false;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t triangle_count_ = 0;
  std::size_t placed_count_ = 0;
};

void ModelParser::start(std::string_view element, const XmlAttributes& attributes) {
  if (!element.starts_with(core)) return;
  const std::string_view name = element.substr(core.size());
  if (name == "model") check_extensions(attributes);
  if (name == "object") start_object(attributes);
  if (name == "vertex") add_vertex(attributes);
  if (name == "triangle") add_triangle(attributes);
  if (name == "component") object().components.push_back(placed(attributes));
  if (name == "item") model_.items.push_back(placed(attributes));
}

void ModelParser::end(std::string_view element) {
  if (!element.starts_with(core) || element.substr(core.size()) != "object") return;
  by_id_[id_] = model_.objects.size() - 1;
  in_object_ = false;
}

void ModelParser::check_extensions(const XmlAttributes& attributes) const {
  for (const std::string_view prefix : words_of(attributes.find("requiredextensions").value_or(""))) {
    const auto found = name_spaces_.find(std::string(prefix));
    const bool is_known = found != name_spaces_.end() && (found->second == production || found->second == materials);
    if (!is_known) throw std::runtime_error("the model needs the extension " + quoted(prefix) + ", which is not read");
  }
}

void ModelParser::start_object(const XmlAttributes& attributes) {
  id_ = id_of(required(attributes, "id"));
  if (in_object_ || by_id_.contains(id_)) throw std::runtime_error("object " + std::to_string(id_) + " is there twice");
  if (model_.objects.size() == most_placed) throw std::runtime_error("more than a million objects");
  in_object_ = true;
  model_.objects.emplace_back();
}

ThreeMfObject& ModelParser::object() {
  if (!in_object_) throw std::runtime_error("a part of an object is outside of all objects");
  return model_.objects.back();
}

void ModelParser::add_vertex(const XmlAttributes& attributes) {
  mesh_.expect(++vertex_count_, triangle_count_);
  object().vertices.push_back({number_of(required(attributes, "x")), number_of(required(attributes, "y")),
                               number_of(required(attributes, "z"))});
}

void ModelParser::add_triangle(const XmlAttributes& attributes) {
  mesh_.expect(vertex_count_, ++triangle_count_);
  std::array<std::uint32_t, 3> corners{};
  constexpr std::array<std::string_view, 3> names{"v1", "v2", "v3"};
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = id_of(required(attributes, names[i]));
    if (corners[i] >= object().vertices.size())
      throw std::runtime_error("a corner names vertex " + std::to_string(corners[i]) + " of " +
                               std::to_string(object().vertices.size()) + ", counted from 0");
  }
  object().triangles.push_back(corners);
}

PlacedObject ModelParser::placed(const XmlAttributes& attributes) {
  if (++placed_count_ > most_placed) throw std::runtime_error("more than a million placed objects");
  if (attributes.find(std::string(production) + "|path"))
    throw std::runtime_error("an object in another part of the package, which is not read");
  const std::uint32_t id = id_of(required(attributes, "objectid"));
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) throw std::runtime_error("there is no object " + std::to_string(id) + " before this");
  return {found->second, transform_of(attributes)};
}

// Returns the part that is the model.
std::string model_part(std::string_view package) {
  std::string part;
  XmlText text({[&](std::string_view element, const XmlAttributes& attributes) {
                  const bool is_model =
                      element.ends_with("|Relationship") && attributes.find("Type").value_or("").ends_with("/3dmodel");
                  if (is_model && part.empty()) part = std::string(required(attributes, "Target"));
                },
                [](std::string_view) {}, [](std::string_view, std::string_view) {}});
  unpack(package, "_rels/.rels", [&](std::string_view portion) {
    text.take(portion);
    return true;
  });
  text.end();
  if (part.empty()) throw std::runtime_error("the package names no 3D model");
  return part.starts_with('/') ? part.substr(1) : part;
}

ThreeMfModel parse_model(std::string_view package, const MeshCollector& mesh) {
  const std::string part = model_part(package);
  ModelParser parser(mesh);
  XmlText text({[&](std::string_view element, const XmlAttributes& attributes) { parser.start(element, attributes); },
                [&](std::string_view element) { parser.end(element); },
                [&](std::string_view prefix, std::string_view name) { parser.name_space(prefix, name); }});
  try {
    unpack(package, part, [&](std::string_view portion) {
      text.take(portion);
      return true;
    });
    text.end();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error("line " + std::to_string(text.line()) + " of its model: " + error.what());
  }
  return std::move(parser).result();
}

class ModelPlacer {
 public:
  ModelPlacer(const ThreeMfModel& model, MeshCollector& mesh) : model_(model), mesh_(mesh) {}

  void place_all() {
    for (const PlacedObject& item : model_.items) place_item(item);
  }

 private:
  void place_item(const PlacedObject& item);
  void place_mesh(const ThreeMfObject& object, const Placement& placement);

  const ThreeMfModel& model_;
  MeshCollector& mesh_;
  std::size_t placed_count_ = 0;
  std::uint64_t vertices_ = 0;
};

void ModelPlacer::place_item(const PlacedObject& item) {
  std::vector<PlacedObject> open{item};
  while (!open.empty()) {
    const PlacedObject next = open.back();
    open.pop_back();
    if (++placed_count_ > most_placed) throw std::runtime_error("more than a million placed objects");
    const ThreeMfObject& object = model_.objects[next.object];
    place_mesh(object, next.placement);
    for (std::size_t c = object.components.size(); c-- > 0;)
      open.push_back({object.components[c].object, next.placement * object.components[c].placement});
  }
}

void ModelPlacer::place_mesh(const ThreeMfObject& object, const Placement& placement) {
  const std::uint64_t first = vertices_;
  for (const Point3& p : object.vertices) mesh_.add_vertex(placement.point(p));
  vertices_ += object.vertices.size();
  const bool mirrored = placement.mirrors();
  for (const auto& corners : object.triangles) {
    for (const std::size_t i : mirrored ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2})
      mesh_.add_corner(static_cast<std::int64_t>(first + corners[i]), vertices_);
    mesh_.end_face();
  }
}

}  // namespace

MeshFile read_three_mf(std::string_view bytes, const std::string& file_name, const ReadLimits& limits,
                       Normals normals) {
  InputBytes name(std::string_view(), file_name);
  name.name_no_place();
  try {
    MeshCollector mesh(name, limits, normals);
    const ThreeMfModel model = parse_model(bytes, mesh);
    ModelPlacer(model, mesh).place_all();
    return std::move(mesh).finish();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    name.fail(std::string(error.what()) + "; export the 3MF again, or save it as STL");
  }
}

}  // namespace sightline::inline formats

#else

namespace sightline::inline formats {

MeshFile read_three_mf(std::string_view /*bytes*/, const std::string& file_name, const ReadLimits& /*limits*/,
                       Normals /*normals*/) {
  throw InputError(file_name, 0,
                   "3MF is not read by this sightline, which was built without Expat; build it where Expat is (Debian: "
                   "libexpat1-dev), or save the mesh as STL or PLY");
}

}  // namespace sightline::inline formats

#endif
