// Polynomials on a triangle, as homogeneous forms of its barycentric coordinates: sums of c a^i b^j c^k with i + j + k = degree.
//
// Values are numbers or vectors. The value at a corner is the coefficient of that corner's power.
// Complexity: O(degree^2) per sum, O(m^2 n^2) per product.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace sightline::inline reflect {

// Row r has the coefficients with i = degree - r, beginning with k = 0.
[[nodiscard]] constexpr std::size_t form_index(std::size_t row, std::size_t k) { return row * (row + 1) / 2 + k; }
[[nodiscard]] constexpr std::size_t form_size(std::size_t degree) { return form_index(degree + 1, 0); }

template <std::size_t degree, class Value>
struct BarycentricForm {
  std::array<Value, form_size(degree)> coefficients;

  [[nodiscard]] const Value& at(std::size_t row, std::size_t k) const { return coefficients[form_index(row, k)]; }

  template <class Map>
  [[nodiscard]] auto mapped(Map map) const {
    BarycentricForm<degree, std::decay_t<decltype(map(coefficients[0]))>> result;
    for (std::size_t i = 0; i < coefficients.size(); ++i) result.coefficients[i] = map(coefficients[i]);
    return result;
  }
};

template <class Value>
using LinearForm = BarycentricForm<1, Value>;

// `multiply` takes two values: a product of numbers, an inner or a vector product.
template <std::size_t m, std::size_t n, class A, class B, class Multiply>
[[nodiscard]] auto product(const BarycentricForm<m, A>& a, const BarycentricForm<n, B>& b, Multiply multiply) {
  using Value = std::decay_t<decltype(multiply(a.coefficients[0], b.coefficients[0]))>;
  BarycentricForm<m + n, Value> result;
  for (Value& value : result.coefficients) value = multiply(A(0 * a.coefficients[0]), b.coefficients[0]);
  for (std::size_t r = 0; r <= m; ++r) {
    for (std::size_t k = 0; k <= r; ++k) {
      for (std::size_t s = 0; s <= n; ++s) {
        for (std::size_t l = 0; l <= s; ++l)
          result.coefficients[form_index(r + s, k + l)] += multiply(a.at(r, k), b.at(s, l));
      }
    }
  }
  return result;
}

template <std::size_t degree, class Value>
[[nodiscard]] BarycentricForm<degree, Value> operator-(BarycentricForm<degree, Value> a,
                                                       const BarycentricForm<degree, Value>& b) {
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) a.coefficients[i] -= b.coefficients[i];
  return a;
}

}  // namespace sightline::inline reflect
