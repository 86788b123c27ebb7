#include "geometry/projection/clipping.h"

#include <algorithm>

#include "geometry/projection/camera_forms.h"

namespace sightline::inline geometry {
// This has the camera and the facet's vertices as integers over one power of two.
class CommonScale {
 public:
  CommonScale(const Camera& camera, std::span<const Point3> vertices)
      : CommonScale(camera, common_exponent(camera, vertices)) {}
  CommonScale(const Camera& camera, int exponent) : exponent_(exponent), forms_(integer_forms(camera, exponent_)) {}

  [[nodiscard]] int exponent() const { return exponent_; }

  // Every coordinate of v / weight is of degree two in the scaled numbers and of degree one in v and weight, so that all
  // share the factor `one`.
  [[nodiscard]] ExactCorner corner(const CameraForms<BigInteger>::Vector& v, const BigInteger& weight) const {
    const CameraPlace<BigInteger> place = forms_.at(v, weight);
    ExactCorner corner;
    corner.x = place.x;
    corner.y = place.y;
    corner.w = place.w;
    corner.depth = place.depth;
    corner.px = v.x() * forms_.unit;
    corner.py = v.y() * forms_.unit;
    corner.pz = v.z() * forms_.unit;
    corner.one = forms_.one * weight;
    return corner;
  }

  [[nodiscard]] ExactCorner corner(const Point3& v) const {
    return corner(v.unaryExpr([this](double value) { return scaled<BigInteger>(value, exponent_); }), 1);
  }

  // A vertex of the input, or one that cutting made.
  [[nodiscard]] ExactCorner corner(const CutMesh& mesh, VertexId v) const {
    if (v.index() < mesh.input_vertex_count()) return corner(mesh.position(v));
    const ExactPosition p = exact_position(mesh, v);
    return corner(forms_.unit * p.xyz, p.w);
  }

 private:
  int exponent_;
  CameraForms<BigInteger> forms_;
};

namespace {

using Polygon = std::vector<ExactCorner>;

// Where the segment from `inside` (WEC > 0) to `outside` (WEC < 0) meets the bound: Fang's equation 5.7 without the
// division.
ExactCorner intersection(const ExactCorner& inside, const BigInteger& wec_inside, const ExactCorner& outside,
                         const BigInteger& wec_outside) {
  const auto blend = [&](BigInteger ExactCorner::*coordinate) {
    return BigInteger(outside.*coordinate * wec_inside - inside.*coordinate * wec_outside);
  };
  ExactCorner corner;
  for (const auto coordinate : {&ExactCorner::x, &ExactCorner::y, &ExactCorner::w, &ExactCorner::depth,
                                &ExactCorner::px, &ExactCorner::py, &ExactCorner::pz, &ExactCorner::one}) {
    corner.*coordinate = blend(coordinate);
  }
  return corner;
}

Polygon clip_at(const Polygon& polygon, const Camera& camera, std::size_t bound) {
  std::vector<BigInteger> wecs;
  for (const ExactCorner& corner : polygon) wecs.push_back(window_edge_coordinates(camera, corner)[bound]);
  if (std::none_of(wecs.begin(), wecs.end(), [](const BigInteger& w) { return w > 0; })) return {};
  Polygon result;
  for (std::size_t u = 0; u < polygon.size(); ++u) {
    const std::size_t v = u + 1 == polygon.size() ? 0 : u + 1;
    const Sign sign_u = sign_of(wecs[u]);
    const Sign sign_v = sign_of(wecs[v]);
    if (sign_u >= 0) {
      result.push_back(polygon[u]);
      if (sign_u == 0 && sign_v < 0) result.back().edge_after = MeshEdgeId{};
    }
    if (sign_u * sign_v >= 0) continue;
    result.push_back(sign_u > 0 ? intersection(polygon[u], wecs[u], polygon[v], wecs[v])
                                : intersection(polygon[v], wecs[v], polygon[u], wecs[u]));
    result.back().edge_after = sign_u > 0 ? MeshEdgeId{} : polygon[u].edge_after;
    result.back().on_edge = polygon[u].edge_after;
  }
  return result;
}

// Returns depth - distance, over a common positive factor: the distances are doubles, hence fractions with a power of
// two below.
BigInteger beyond(const ExactCorner& corner, double distance) {
  const Dyadic d = dyadic(distance);
  const BigInteger bound = corner.one * d.mantissa;
  if (d.exponent >= 0) return corner.depth - (bound << static_cast<unsigned>(d.exponent));
  return (corner.depth << static_cast<unsigned>(-d.exponent)) - bound;
}

}  // namespace

std::vector<BigInteger> window_edge_coordinates(const Camera& camera, const ExactCorner& corner) {
  std::vector<BigInteger> wecs{corner.w + corner.x, corner.w - corner.x, corner.w + corner.y, corner.w - corner.y};
  wecs.push_back(camera.near_distance ? beyond(corner, *camera.near_distance) : BigInteger(1));
  wecs.push_back(camera.far_distance ? BigInteger(-beyond(corner, *camera.far_distance)) : BigInteger(1));
  return wecs;
}

Point3 ExactCorner::position() const {
  return {rounded_quotient(px, one), rounded_quotient(py, one), rounded_quotient(pz, one)};
}

double ExactCorner::weight() const { return rounded_quotient(w, one); }

ExactCorner exact_corner(const Point3& vertex, const Camera& camera) {
  return CommonScale(camera, std::span(&vertex, 1)).corner(vertex);
}

ExactCorner exact_corner(const CutMesh& mesh, VertexId vertex, const Camera& camera) {
  return CommonScale(camera, std::span(&mesh.position(vertex), 1)).corner(mesh, vertex);
}

ExactCorners::ExactCorners(const Camera& camera) : camera_(camera) {}
ExactCorners::~ExactCorners() = default;

ExactCorner ExactCorners::of(const CutMesh& mesh, VertexId vertex) {
  const Point3& position = mesh.position(vertex);
  int finest = scale_ ? scale_->exponent() : common_exponent(camera_);
  for (const double c : position) finest = c == 0 ? finest : std::min(finest, dyadic(c).exponent);
  if (!scale_ || finest < scale_->exponent()) scale_ = std::make_unique<CommonScale>(camera_, finest);
  return scale_->corner(mesh, vertex);
}

ImagePoint round_to_grid(const ExactCorner& corner, int grid_bits) {
  const auto coordinate = [&](const BigInteger& numerator) {
    const BigInteger doubled = (abs(numerator) << static_cast<unsigned>(grid_bits + 1)) + corner.w;
    const auto rounded = static_cast<std::int64_t>(BigInteger(doubled / (2 * corner.w)));
    return numerator < 0 ? -rounded : rounded;
  };
  return {coordinate(corner.x), coordinate(corner.y)};
}

Polygon clip(const CutMesh& mesh, const Camera& camera, FacetId facet) {
  const auto corners = mesh.corners(facet);
  std::vector<Point3> positions;
  for (const VertexId v : corners) positions.push_back(mesh.position(v));
  const CommonScale scale(camera, positions);
  Polygon polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    polygon.push_back(scale.corner(mesh, corners[i]));
    polygon.back().vertex = corners[i];
    polygon.back().edge_after = mesh.edges_of(facet)[i];
  }
  for (std::size_t bound = 0; bound < bound_count; ++bound) polygon = clip_at(polygon, camera, bound);
  return polygon;
}

}  // namespace sightline::inline geometry
