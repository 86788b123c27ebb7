#include "geometry/numbers/arithmetic.h"

namespace sightline::inline geometry {

const char* to_string(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::single_precision:
      return "float";
    case Arithmetic::double_precision:
      return "double";
    case Arithmetic::exact:
      return "exact";
    case Arithmetic::unrounded:
      return "unrounded";
  }
  return "";
}

std::optional<Arithmetic> arithmetic_named(std::string_view name) {
  for (const auto arithmetic :
       {Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact, Arithmetic::unrounded}) {
    if (name == to_string(arithmetic)) return arithmetic;
  }
  return std::nullopt;
}

}  // namespace sightline::inline geometry
