#include "formats/reading/mtl_reader.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "formats/reading/obj_scanner.h"

// A program that uses this library may use tinyobjloader, too, of another version and as its header wants it compiled: so
// ours has a namespace of its own.
#define tinyobj sightline_tinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#undef TINYOBJLOADER_IMPLEMENTATION
#undef TINYOBJLOADER_USE_DOUBLE
#undef tinyobj

namespace sightline::inline formats {

namespace {

constexpr std::size_t longest_number = 40;
constexpr std::size_t longest_integer = 9;

// Returns whether it is a decimal with an exponent of at most three digits.
bool is_plain_number(std::string_view token) {
  if (token.size() > longest_number) return false;
  const std::size_t exponent = std::min(token.find_first_of("eE"), token.size());
  if (token.size() - exponent > 5) return false;
  try {
    (void)parse_coordinate(token);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// The statements of a file that matter. Materials are called by their numbers.
struct MtlStatements {
  std::vector<std::string> names;
  std::vector<Material> said;  // where a statement says something, there is a value, of whatever kind
  std::string text;
};

// Returns the rest of the statement, a blank between tokens.
std::string rest_of(ObjScanner& scanner, bool& plain) {
  std::string rest;
  for (auto token = scanner.next_token(); !token.empty(); token = scanner.next_token()) {
    plain = plain && is_plain_number(token);
    if (rest.size() <= longest_region_name) rest += (rest.empty() ? "" : " ") + std::string(token);
  }
  plain = plain && !rest.empty();
  return rest;
}

void add_material(MtlStatements& statements, const std::string& name) {
  if (statements.names.size() == most_materials)
    throw std::length_error("has more than " + std::to_string(most_materials) + " materials");
  statements.text += "newmtl " + std::to_string(statements.names.size()) + "\n";
  statements.names.push_back(region_name(name));
  statements.said.emplace_back();
}

MtlStatements statements_of(std::string_view text) {
  MtlStatements result;
  ObjScanner scanner(text);
  (void)scanner.skip("\xEF\xBB\xBF");
  for (auto word = scanner.next_statement(); !word.empty(); word = scanner.next_statement()) {
    const std::string keyword(word.substr(0, 10));
    if (keyword != "newmtl" && keyword != "Ks" && keyword != "illum") continue;
    bool plain = true;
    const std::string rest = rest_of(scanner, plain);
    if (keyword == "newmtl") add_material(result, rest);
    if (keyword == "newmtl" || !plain || result.names.empty()) continue;
    if (keyword == "illum" && rest.size() > longest_integer) continue;
    if (keyword == "Ks") result.said.back().specular.emplace();
    if (keyword == "illum") result.said.back().illum.emplace();
    result.text.append(keyword).append(" ").append(rest).append("\n");
  }
  return result;
}

}  // namespace

std::map<std::string, Material> read_mtl(std::string_view text) {
  if (text.size() > longest_mtl_file)
    throw std::length_error("has more than " + std::to_string(longest_mtl_file) + " bytes");
  const MtlStatements statements = statements_of(text);
  std::map<std::string, int> numbers;
  std::vector<sightline_tinyobj::material_t> read;
  std::istringstream in(statements.text);
  std::string unused;
  sightline_tinyobj::LoadMtl(&numbers, &read, &in, &unused, &unused);
  std::map<std::string, Material> materials;
  for (std::size_t i = 0; i < statements.names.size(); ++i) {
    Material material = statements.said[i];
    if (material.illum) material.illum = read[i].illum;
    if (material.specular) std::copy_n(read[i].specular, 3, material.specular->begin());
    materials.emplace(statements.names[i], material);
  }
  return materials;
}

}  // namespace sightline::inline formats
