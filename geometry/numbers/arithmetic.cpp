#include "geometry/numbers/arithmetic.h"

namespace sightline::inline geometry {

const char* to_string(Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::exact) return "exact";
  return arithmetic == Arithmetic::single_precision ? "float" : "double";
}

std::optional<Arithmetic> arithmetic_named(std::string_view name) {
  for (const auto arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact}) {
    if (name == to_string(arithmetic)) return arithmetic;
  }
  return std::nullopt;
}

}  // namespace sightline::inline geometry
