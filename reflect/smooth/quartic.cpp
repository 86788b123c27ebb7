#include "reflect/smooth/quartic.h"

#include <cmath>

namespace sightline::inline reflect {
namespace {

constexpr std::size_t n = Quartic::degree;

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

}  // namespace

Quartic::Quartic(const BarycentricForm<degree, double>& form) {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i] = form.coefficients[i] / multinomials[i];
}

Quartic::Departure Quartic::departure() const {
  const std::array<double, 3> corner = corners();
  Departure result;
  for_each_coefficient([&](std::size_t i, std::size_t j, std::size_t k, std::size_t at) {
    const double linear =
        (static_cast<double>(i) * corner[0] + static_cast<double>(j) * corner[1] + static_cast<double>(k) * corner[2]) /
        n;
    result.below = std::max(result.below, linear - coefficients_[at]);
    result.above = std::max(result.above, coefficients_[at] - linear);
  });
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

// For each power of c the coefficients along a and b are those of a polynomial in one variable.
std::array<Quartic, 2> Quartic::halves() const {
  std::array<Quartic, 2> result;
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t along = n - k;
    std::array<double, n + 1> means{};
    for (std::size_t j = 0; j <= along; ++j) means[j] = coefficients_[form_index(j + k, k)];
    for (std::size_t step = 0; step <= along; ++step) {
      // Of the first half: c^k a^(along - step) m^step; of the second: b^(along - step) c^k m^step.
      result[0].coefficients_[form_index(along, step)] = means[0];
      result[1].coefficients_[form_index(k + step, step)] = means[along - step];
      for (std::size_t j = 0; j + step < along; ++j) means[j] = (means[j] + means[j + 1]) / 2;
    }
  }
  return result;
}

}  // namespace sightline::inline reflect
