// A polynomial of degree four on a triangle, in Bernstein's basis: its values lie between its least and greatest coefficient,
// and by how much it departs from the linear function of its corners, coefficients say, too.
//
// Method: halving is de Casteljau's; each coefficient is a mean of old ones.
// Source: Farin, Triangular Bernstein-Bezier patches, 1986, sections 2 and 3.
// Complexity: O(1).
#pragma once

#include <algorithm>
#include <array>

#include "reflect/smooth/barycentric_form.h"

namespace sightline::inline reflect {

class Quartic {
 public:
  static constexpr std::size_t degree = 4;

  Quartic() = default;
  explicit Quartic(const BarycentricForm<degree, double>& form);

  [[nodiscard]] double least() const { return *std::ranges::min_element(coefficients_); }
  [[nodiscard]] double greatest() const { return *std::ranges::max_element(coefficients_); }
  [[nodiscard]] std::array<double, 3> corners() const {
    return {coefficients_[0], coefficients_[form_index(degree, 0)], coefficients_[form_index(degree, degree)]};
  }

  // Returns bounds of how far it is below and above the linear function that has the same values at the corners.
  struct Departure {
    double below = 0;
    double above = 0;
  };
  [[nodiscard]] Departure departure() const;

  [[nodiscard]] double at(const std::array<double, 3>& barycentric) const;

  // Returns the polynomial on both halves of the triangle (a, b, c), which are (c, a, m) and (b, c, m) with m between a and b.
  [[nodiscard]] std::array<Quartic, 2> halves() const;

 private:
  std::array<double, form_size(degree)> coefficients_{};
};

}  // namespace sightline::inline reflect
