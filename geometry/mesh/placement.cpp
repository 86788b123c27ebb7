#include "geometry/mesh/placement.h"

#include <algorithm>
#include <optional>

#include "geometry/numbers/double_word.h"
#include "geometry/numbers/exact_rounding.h"

namespace sightline::inline geometry {

namespace {

using Row = Eigen::Matrix<double, 1, 4>;

// Turns the axis that points up to y. Only places and signs change.
Vector3 with_y_up(UpAxis up, const Vector3& p) {
  if (up == UpAxis::z) return {p.x(), p.z(), -p.y()};
  if (up == UpAxis::x) return {-p.y(), p.x(), p.z()};
  return p;
}

// Returns the axis that the row hands on as it is; nothing where it computes.
std::optional<int> passed_axis(const Row& row) {
  for (int axis = 0; axis < 3; ++axis) {
    if (row == Row::Unit(axis)) return axis;
  }
  return std::nullopt;
}

std::optional<double> certain_coordinate(const Row& row, const LengthRatio& length, const Point3& p) {
  const DoubleWordVector linear{DoubleWord(row(0)), DoubleWord(row(1)), DoubleWord(row(2))};
  const DoubleWord ratio = DoubleWord(length.numerator) / DoubleWord(length.denominator);
  return certain_rounding(dot(linear, in_words(p)) * ratio + DoubleWord(row(3)));
}

// A product of finite doubles, and what of a sum is over a common power of two.
struct Term {
  BigInteger mantissa;
  int exponent = 0;
};

Term times(const Term& t, double factor) {
  const Dyadic d = dyadic(factor);
  return {t.mantissa * d.mantissa, t.exponent + d.exponent};
}

double exact_coordinate(const Row& row, const LengthRatio& length, const Point3& p) {
  std::array<Term, 4> terms;
  for (int axis = 0; axis < 3; ++axis)
    terms[static_cast<std::size_t>(axis)] = times(times(times({1, 0}, row(axis)), p(axis)), length.numerator);
  terms[3] = times(times({1, 0}, row(3)), length.denominator);
  std::optional<int> lowest;
  for (const Term& t : terms) {
    if (t.mantissa != 0) lowest = std::min(lowest.value_or(t.exponent), t.exponent);
  }
  if (!lowest) return 0;
  BigInteger sum = 0;
  for (const Term& t : terms) {
    if (t.mantissa != 0) sum += t.mantissa << static_cast<unsigned>(t.exponent - *lowest);
  }
  const Dyadic denominator = dyadic(length.denominator);
  return rounded_ratio(sum, denominator.mantissa, *lowest - denominator.exponent);
}

double coordinate(const Row& row, const LengthRatio& length, const Point3& p) {
  const auto axis = passed_axis(row);
  if (axis && length.numerator == length.denominator) return p(*axis);
  if (const auto certain = certain_coordinate(row, length, p)) return *certain;
  return exact_coordinate(row, length, p);
}

// Returns the map of normals: the inverse's transpose but for a positive factor, which is the matrix of cofactors with the
// determinant's sign. Scaling by a power of two keeps it in the range of double.
Eigen::Matrix3d normal_map(const Placement& placement, Sign orientation) {
  const Eigen::Matrix3d linear = placement.matrix.leftCols<3>();
  const Eigen::Matrix3d scaled = linear * std::ldexp(1.0, -std::ilogb(linear.cwiseAbs().maxCoeff()));
  const Vector3 x = scaled.row(0);
  const Vector3 y = scaled.row(1);
  const Vector3 z = scaled.row(2);
  Eigen::Matrix3d cofactors;
  cofactors << y.cross(z).transpose(), z.cross(x).transpose(), x.cross(y).transpose();
  return orientation * cofactors;
}

// Of the corners, or of what is parallel to them.
template <class Item>
void reverse_each(const PolygonList& faces, std::vector<Item>& items) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    std::reverse(items.begin() + faces.begin[f], items.begin() + faces.begin[f + 1]);
}

}  // namespace

bool Placement::changes_nothing() const {
  return matrix == decltype(matrix)::Identity() && length.numerator == length.denominator && up_axis == UpAxis::y;
}

// The entries are integers times one power of two, whose determinant has their sign.
Sign Placement::orientation() const {
  std::array<double, 9> entries{};
  for (int i = 0; i < 9; ++i) entries[static_cast<std::size_t>(i)] = matrix(i / 3, i % 3);
  const auto determinant = [](const auto& m) -> BigInteger {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  };
  return sign_of(determinant(scaled<BigInteger>(entries, exponent_range(entries).lowest)));
}

Point3 placed(const Placement& placement, const Point3& p) {
  const Point3 turned = with_y_up(placement.up_axis, p);
  Point3 result = Point3::Zero();
  for (int i = 0; i < 3; ++i) result(i) = coordinate(placement.matrix.row(i), placement.length, turned);
  if (!result.allFinite())
    throw PlacementError("a placed coordinate is beyond the range of double; give smaller numbers");
  return result;
}

void place(const Placement& placement, std::vector<Point3>& vertices, PolygonList& faces,
           std::vector<Vector3>& corner_normals) {
  if (placement.changes_nothing()) return;
  const Sign orientation = placement.orientation();
  if (orientation == 0)
    throw PlacementError("the placement is singular: it flattens the mesh; give its first three columns rank 3");
  for (Point3& p : vertices) p = placed(placement, p);
  const Eigen::Matrix3d map = normal_map(placement, orientation);
  for (Vector3& normal : corner_normals) normal = map * with_moderate_exponent(with_y_up(placement.up_axis, normal));
  if (orientation > 0) return;
  reverse_each(faces, faces.corners);
  if (!corner_normals.empty()) reverse_each(faces, corner_normals);
}

}  // namespace sightline::inline geometry
