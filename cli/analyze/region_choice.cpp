#include "cli/analyze/region_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

constexpr std::size_t listed_regions = 10;

// Smoothing groups are numbers, which nobody means without saying so.
bool is_called(const Region& region, const std::string& name) {
  if (region.name.empty()) return false;
  const auto fits = [&](std::string_view called) {
    return called == region.name || (!region.mesh.empty() && called == region.mesh + "/" + region.name);
  };
  const std::string kind = std::string(to_string(region.kind)) + ":";
  return (region.kind != RegionKind::smoothing && fits(name)) ||
         (name.starts_with(kind) && fits(std::string_view(name).substr(kind.size())));
}

// Returns the texts in quotation marks, ten at most.
std::string list_of(const std::vector<std::string>& texts) {
  std::string list;
  for (std::size_t i = 0; i < std::min(texts.size(), listed_regions); ++i) list += (i == 0 ? "" : ", ") + texts[i];
  return list + (texts.size() > listed_regions ? fmt::format(", and {} more", texts.size() - listed_regions) : "");
}

std::string names_in(const FaceRegions& regions) {
  std::vector<std::string> names;
  for (const RegionKind kind : {RegionKind::mesh, RegionKind::object, RegionKind::group, RegionKind::material}) {
    for (const Region& region : regions.regions) {
      const std::string quoted_name = "\"" + region.name + "\"";
      if (region.kind == kind && !region.name.empty() && std::ranges::find(names, quoted_name) == names.end())
        names.push_back(quoted_name);
      if (names.size() > 1000) return list_of(names);
    }
  }
  return names.empty() ? "the surface has no regions with names" : "there are " + list_of(names);
}

template <class IsMeant>
std::vector<std::uint8_t> meant_regions(const FaceRegions& regions, IsMeant is_meant) {
  std::vector<std::uint8_t> meant;
  for (const Region& region : regions.regions) meant.push_back(is_meant(region) ? 1 : 0);
  return meant;
}

FaceMask faces_in(const FaceRegions& regions, const std::vector<std::uint8_t>& meant) {
  FaceMask mask(regions.face_state.size(), 0);
  for (std::size_t f = 0; f < mask.size(); ++f)
    regions.for_each(FaceId(f), [&](RegionId region) { mask[f] |= meant[region.index()]; });
  return mask;
}

// Ks is read in double, but not rounded correctly; in float it is.
bool is_specular_enough(const Material& material, double least) {
  return material.specular && static_cast<float>(std::ranges::max(*material.specular)) >= static_cast<float>(least);
}

bool fits_material(const Region& region, const MaterialChoice& choice) {
  if (region.kind != RegionKind::material) return false;
  const Material& material = region.material;
  const bool illum_fits = choice.illum.empty() ||
                          (material.illum && std::ranges::find(choice.illum, *material.illum) != choice.illum.end());
  return illum_fits && (!choice.specular_min || is_specular_enough(material, *choice.specular_min));
}

std::string described(const Region& region) {
  const Material& material = region.material;
  const std::string illum = material.illum ? fmt::format("illum {}", *material.illum) : "no illum";
  const std::string specular =
      material.specular ? fmt::format("Ks {:.4g}", fmt::join(*material.specular, " ")) : "no Ks";
  return fmt::format("\"{}\" ({}, {})", region.name, illum, specular);
}

std::string materials_in(const FaceRegions& regions) {
  std::vector<std::string> materials;
  for (const Region& region : regions.regions) {
    if (region.kind == RegionKind::material && !region.name.empty()) materials.push_back(described(region));
  }
  return materials.empty() ? "the surface has no materials" : "there are " + list_of(materials);
}

}  // namespace

FaceMask faces_of(const FaceRegions& regions, const RegionChoice& choice, const std::string& scene_file) {
  for (const std::string& name : choice.names) {
    if (std::ranges::none_of(regions.regions, [&](const Region& region) { return is_called(region, name); }))
      throw InputError(scene_file, choice.line,
                       fmt::format("'{}': no region is called \"{}\"; {}; correct the name, or leave it out",
                                   choice.key, region_name(name), names_in(regions)));
  }
  return faces_in(regions, meant_regions(regions, [&](const Region& region) {
                    return std::ranges::any_of(choice.names,
                                               [&](const std::string& name) { return is_called(region, name); });
                  }));
}

FaceMask faces_of(const FaceRegions& regions, const MaterialChoice& choice, const std::string& scene_file) {
  const auto meant = meant_regions(regions, [&](const Region& region) { return fits_material(region, choice); });
  if (std::ranges::count(meant, 1) == 0)
    throw InputError(
        scene_file, choice.line,
        fmt::format(
            "'mirrors_material': no material is so; {}; change its conditions, or look whether the file that mtllib "
            "names is beside the mesh",
            materials_in(regions)));
  return faces_in(regions, meant);
}

}  // namespace sightline::cli
