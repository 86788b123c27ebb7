#include "reflect/smooth/quartic.h"

#include <cmath>

namespace sightline::inline reflect {
namespace {

constexpr std::size_t n = Quartic::degree;
using QuarticCoefficients = std::array<double, form_size(n)>;

constexpr double factorial(std::size_t number) {
  return number < 2 ? 1 : static_cast<double>(number) * factorial(number - 1);
}

// How often a monomial of these three exponents occurs in (a + b + c)^4.
constexpr double multinomial(std::size_t i, std::size_t j, std::size_t k) {
  return factorial(n) / (factorial(i) * factorial(j) * factorial(k));
}

template <class Visit>
constexpr void for_each_coefficient(Visit visit) {
  for (std::size_t row = 0; row <= n; ++row) {
    for (std::size_t k = 0; k <= row; ++k) visit(n - row, row - k, k, form_index(row, k));
  }
}

constexpr auto multinomials = [] {
  std::array<double, form_size(n)> result{};
  for_each_coefficient(
      [&](std::size_t i, std::size_t j, std::size_t k, std::size_t at) { result[at] = multinomial(i, j, k); });
  return result;
}();

// Where in the triangle a coefficient belongs: what of it the corners have there.
constexpr auto shares = [] {
  std::array<std::array<double, 3>, form_size(n)> result{};
  for_each_coefficient([&](std::size_t i, std::size_t j, std::size_t k, std::size_t at) {
    result[at] = {static_cast<double>(i) / n, static_cast<double>(j) / n, static_cast<double>(k) / n};
  });
  return result;
}();

}  // namespace

Quartic::Quartic(const BarycentricForm<degree, double>& form) {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i] = form.coefficients[i] / multinomials[i];
}

Quartic::Departure Quartic::departure() const {
  const std::array<double, 3> corner = corners();
  Departure result;
  for (std::size_t at = 0; at < coefficients_.size(); ++at) {
    const auto& [i, j, k] = shares[at];
    const double above = coefficients_[at] - (i * corner[0] + j * corner[1] + k * corner[2]);
    result.below = std::max(result.below, -above);
    result.above = std::max(result.above, above);
  }
  return result;
}

double Quartic::at(const std::array<double, 3>& barycentric) const {
  std::array<std::array<double, n + 1>, 3> powers;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    powers[corner][0] = 1;
    for (std::size_t e = 1; e <= n; ++e) powers[corner][e] = powers[corner][e - 1] * barycentric[corner];
  }
  double sum = 0;
  for_each_coefficient([&](std::size_t i, std::size_t j, std::size_t k, std::size_t at) {
    sum += multinomials[at] * coefficients_[at] * powers[0][i] * powers[1][j] * powers[2][k];
  });
  return sum;
}

namespace {

// De Casteljau's means along a and b, for one power of c: those coefficients are those of a polynomial in one variable.
template <std::size_t k>
void halve_along(const QuarticCoefficients& whole, QuarticCoefficients& first, QuarticCoefficients& second) {
  constexpr std::size_t along = n - k;
  std::array<double, along + 1> means;
  for (std::size_t j = 0; j <= along; ++j) means[j] = whole[form_index(j + k, k)];
  for (std::size_t step = 0; step <= along; ++step) {
    // Of the first half: c^k a^(along - step) m^step; of the second: b^(along - step) c^k m^step.
    first[form_index(along, step)] = means[0];
    second[form_index(k + step, step)] = means[along - step];
    for (std::size_t j = 0; j + step < along; ++j) means[j] = (means[j] + means[j + 1]) / 2;
  }
}

}  // namespace

std::array<Quartic, 2> Quartic::halves() const {
  std::array<Quartic, 2> result;
  auto& [first, second] = result;
  halve_along<0>(coefficients_, first.coefficients_, second.coefficients_);
  halve_along<1>(coefficients_, first.coefficients_, second.coefficients_);
  halve_along<2>(coefficients_, first.coefficients_, second.coefficients_);
  halve_along<3>(coefficients_, first.coefficients_, second.coefficients_);
  halve_along<4>(coefficients_, first.coefficients_, second.coefficients_);
  return result;
}

}  // namespace sightline::inline reflect
