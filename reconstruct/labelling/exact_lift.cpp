#include "reconstruct/labelling/exact_lift.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline reconstruct {
namespace {

double rounded(const BigInteger& numerator, const BigInteger& denominator) {
  return denominator < 0 ? rounded_quotient(BigInteger(-numerator), BigInteger(-denominator))
                         : rounded_quotient(numerator, denominator);
}

// The sum of the corners, each times its number.
template <std::size_t N>
Point3 combined(const std::array<ExactCorner, N>& corners, const std::array<BigInteger, N>& numbers) {
  BigInteger x, y, z, one;
  for (std::size_t i = 0; i < N; ++i) {
    x += numbers[i] * corners[i].px;
    y += numbers[i] * corners[i].py;
    z += numbers[i] * corners[i].pz;
    one += numbers[i] * corners[i].one;
  }
  return {rounded(x, one), rounded(y, one), rounded(z, one)};
}

BigInteger determinant(const ExactLine& line, const ExactPlace& place) {
  return line.a * place.x + line.b * place.y + line.c * place.w;
}

}  // namespace

// The cross products of the three places are parallel, so one of their components says the numbers.
Point3 EdgeLift::operator()(MeshEdgeId edge, const ExactPlace& place) {
  const auto& [from, to] = mesh_.edges[edge.index()];
  const std::array corners{exact_corners_.of(mesh_, from), exact_corners_.of(mesh_, to)};
  const ExactLine to_second = line_through(place, place_of(corners[1]));
  const ExactLine from_first = line_through(place_of(corners[0]), place);
  for (const auto component : {&ExactLine::a, &ExactLine::b, &ExactLine::c}) {
    if (to_second.*component != 0 || from_first.*component != 0)
      return combined<2>(corners, {to_second.*component, from_first.*component});
  }
  return mesh_.position(from);
}

void PlaneLift::begin(FacetId facet) { facet_ = facet; }

Point3 PlaneLift::operator()(const ExactPlace& place) {
  if (of_corners_ != facet_) {
    std::ranges::transform(plane_corners(mesh_, facet_), corners_.begin(),
                           [this](VertexId v) { return exact_corners_.of(mesh_, v); });
    of_corners_ = facet_;
  }
  const std::array places{place_of(corners_[0]), place_of(corners_[1]), place_of(corners_[2])};
  return combined<3>(corners_, {determinant(line_through(places[1], places[2]), place),
                                determinant(line_through(places[2], places[0]), place),
                                determinant(line_through(places[0], places[1]), place)});
}

}  // namespace sightline::inline reconstruct
