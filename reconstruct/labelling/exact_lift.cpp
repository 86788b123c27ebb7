#include "reconstruct/labelling/exact_lift.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/errors.h"

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

Point3 EdgeLift::operator()(MeshEdgeId edge, PointId p) {
  const auto certain = certain_.to_edge(edge, p);
  return certain ? *certain : exact(edge, p);
}

// The cross products of the three places are parallel, so one of their components says the numbers.
Point3 EdgeLift::exact(MeshEdgeId edge, PointId p) {
  const ExactPlace place = points_.exact(p);
  const CutMesh& mesh = points_.scene().mesh();
  const auto& [from, to] = mesh.edges[edge.index()];
  const std::array corners{exact_corners_.of(mesh, from), exact_corners_.of(mesh, to)};
  const ExactLine to_second = line_through(place, place_of(corners[1]));
  const ExactLine from_first = line_through(place_of(corners[0]), place);
  for (const auto component : {&ExactLine::a, &ExactLine::b, &ExactLine::c}) {
    if (to_second.*component != 0 || from_first.*component != 0)
      return combined<2>(corners, {to_second.*component, from_first.*component});
  }
  throw InternalError("mesh edge " + std::to_string(edge.value) + " is one point in the image");
}

Point3 PlaneLift::operator()(PointId p) {
  const auto certain = certain_.to_plane(facet_, p);
  return certain ? *certain : exact(p);
}

Point3 PlaneLift::exact(PointId p) {
  if (of_corners_ != facet_) {
    const CutMesh& mesh = points_.scene().mesh();
    std::ranges::transform(plane_corners(mesh, facet_), corners_.begin(),
                           [&](VertexId v) { return exact_corners_.of(mesh, v); });
    of_corners_ = facet_;
  }
  const ExactPlace place = points_.exact(p);
  const std::array places{place_of(corners_[0]), place_of(corners_[1]), place_of(corners_[2])};
  return combined<3>(corners_, {determinant(line_through(places[1], places[2]), place),
                                determinant(line_through(places[2], places[0]), place),
                                determinant(line_through(places[0], places[1]), place)});
}

}  // namespace sightline::inline reconstruct
