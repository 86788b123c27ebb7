#include "oracle/judging/ray_depth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline::lattice {
namespace {

// Returns a double as an integer times 2^-shift, for a shift that makes it one.
BigInteger whole(double value, int shift) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int up = exponent - 53 + shift;
  if (up >= 0) return BigInteger(mantissa) << static_cast<unsigned>(up);
  return BigInteger(mantissa) / (BigInteger(1) << static_cast<unsigned>(-up));
}

// Returns a shift that makes all values whole; trailing zeros of mantissas are not worth looking at.
int shift_for(std::initializer_list<Vector3> vectors) {
  int shift = 0;
  for (const Vector3& v : vectors) {
    for (const double value : {v.x(), v.y(), v.z()}) {
      if (value != 0) shift = std::max(shift, 52 - std::ilogb(value));
    }
  }
  return shift;
}

struct WidePoint {
  BigInteger x;
  BigInteger y;
  BigInteger nearness;
  BigInteger w;
};

class Frame {
 public:
  Frame(const Camera& camera, int shift)
      : camera_(camera), shift_(shift), row_shift_(shift_for({camera.right, camera.up, camera.forward})) {}

  [[nodiscard]] WidePoint operator()(const Point3& v) const {
    const BigInteger depth = form(camera_.forward, v);
    const BigInteger one = BigInteger(1) << static_cast<unsigned>(shift_ + row_shift_);
    const bool pinhole = camera_.projection == Projection::perspective;
    return {form(camera_.right, v), form(camera_.up, v), pinhole ? one : BigInteger(-depth), pinhole ? depth : one};
  }

 private:
  [[nodiscard]] BigInteger form(const Vector3& row, const Point3& v) const {
    const auto term = [&](double r, double value, double origin) {
      return BigInteger(whole(r, row_shift_) * BigInteger(whole(value, shift_) - whole(origin, shift_)));
    };
    const Point3& o = camera_.origin;
    return term(row.x(), v.x(), o.x()) + term(row.y(), v.y(), o.y()) + term(row.z(), v.z(), o.z());
  }
  const Camera& camera_;
  int shift_;
  int row_shift_;
};

using WideRow = std::array<const BigInteger*, 3>;

BigInteger determinant(const WideRow& p, const WideRow& q, const WideRow& r) {
  return *p[0] * BigInteger(*q[1] * *r[2] - *q[2] * *r[1]) + *p[1] * BigInteger(*q[2] * *r[0] - *q[0] * *r[2]) +
         *p[2] * BigInteger(*q[0] * *r[1] - *q[1] * *r[0]);
}

}  // namespace

RayDepth depth_along(const PolygonMesh& mesh, const ProjectedScene& scene, FacetId facet, const ImagePoint& ray) {
  const auto corners = mesh.corners(facet);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const Point3& a = mesh.position(corners[0]);
    const Point3& b = mesh.position(corners[k - 1]);
    const Point3& c = mesh.position(corners[k]);
    const Frame frame(scene.camera, shift_for({a, b, c, scene.camera.origin}));
    const WidePoint p = frame(a);
    const WidePoint q = frame(b);
    const WidePoint r = frame(c);
    BigInteger denominator = determinant({&p.x, &p.y, &p.w}, {&q.x, &q.y, &q.w}, {&r.x, &r.y, &r.w});
    if (denominator == 0) continue;  // three corners in a line
    const BigInteger along_x =
        determinant({&p.y, &p.nearness, &p.w}, {&q.y, &q.nearness, &q.w}, {&r.y, &r.nearness, &r.w});
    const BigInteger along_y =
        determinant({&p.x, &p.nearness, &p.w}, {&q.x, &q.nearness, &q.w}, {&r.x, &r.nearness, &r.w});
    const BigInteger offset =
        determinant({&p.x, &p.y, &p.nearness}, {&q.x, &q.y, &q.nearness}, {&r.x, &r.y, &r.nearness});
    const BigInteger unit = BigInteger(1) << static_cast<unsigned>(scene.grid_bits);
    BigInteger numerator = along_y * ray.y - along_x * ray.x + offset * unit;
    denominator *= unit;
    if (denominator < 0) {
      numerator = -numerator;
      denominator = -denominator;
    }
    return {numerator, denominator};
  }
  throw std::logic_error("facet " + std::to_string(facet.value) + " is edge-on and has no depth");
}

Sign nearer(const RayDepth& a, const RayDepth& b) {
  return BigInteger(a.numerator * b.denominator).compare(b.numerator * a.denominator);
}

}  // namespace sightline::lattice
