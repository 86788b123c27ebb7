// Regions are the parts of a surface that its file has names for.
//
// Out: which mesh (of a scene that has several), object, groups, material and smoothing group each face is in.
// Holds: empty where a format has no regions. Else each face is in exactly one mesh, object, material and smoothing group, and in
//      at least one group; the region without a name has the faces that their file puts into none. Regions are in the order in
//      which faces first are in them. A name is one line of UTF-8 without control characters, of at most longest_region_name
//      bytes.
// Memory: 4 bytes per face, and what changes from face to face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/numbers/ids.h"

namespace sightline::inline formats {

enum class RegionKind : std::uint8_t { mesh, object, group, material, smoothing };
inline constexpr std::array region_kinds{RegionKind::mesh, RegionKind::object, RegionKind::group, RegionKind::material,
                                         RegionKind::smoothing};
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(RegionKind kind);

// What an MTL file says of a material, where it says it. Ks is not rounded correctly (mtl_reader.h).
struct Material {
  std::optional<int> illum;                       // the illumination model; 3 and more have reflections
  std::optional<std::array<double, 3>> specular;  // Ks: red, green, blue
};

using RegionId = Id<struct RegionTag>;

struct Region {
  RegionKind kind = RegionKind::object;
  std::string mesh;  // the name of the mesh that it is in; empty where a scene's mesh has none
  std::string name;  // within the mesh
  Material material;
};

struct FaceRegions {
  // Consecutive faces mostly are in the same regions.
  struct State {
    std::array<RegionId, 4> single;  // mesh, object, material, smoothing
    std::uint32_t first_group = 0;   // of `groups`
    std::uint32_t group_count = 0;
  };

  std::vector<Region> regions;
  std::vector<RegionId> groups;
  std::vector<State> states;
  std::vector<std::uint32_t> face_state;  // per face

  [[nodiscard]] bool empty() const { return regions.empty(); }

  // Calls visit(region) for each region of the face, each once.
  template <class Visit>
  void for_each(FaceId face, Visit visit) const {
    if (empty()) return;
    const State& state = states[face_state[face.index()]];
    for (const RegionId region : state.single) visit(region);
    for (std::size_t i = 0; i < state.group_count; ++i) visit(groups[state.first_group + i]);
  }
};

constexpr std::size_t longest_region_name = 200;  // in bytes; longer names are cut
constexpr std::size_t most_regions = 100000;      // of a kind; faces of further ones are in the one without a name
constexpr std::size_t most_groups_of_face = 100;  // further ones are passed over

// Returns the bytes as the name of a region: what is no UTF-8, or a control character, as \xNN; cut between characters.
[[nodiscard]] SIGHTLINE_EXPORT std::string region_name(std::string_view bytes);

// Returns the regions of a mesh of so many faces whose file names none.
[[nodiscard]] SIGHTLINE_EXPORT FaceRegions unnamed_regions(std::size_t face_count);

}  // namespace sightline::inline formats
