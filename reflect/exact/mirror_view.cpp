#include "reflect/exact/mirror_view.h"

#include <algorithm>
#include <iterator>

#include "geometry/projection/camera_forms.h"
#include "geometry/projection/clipping.h"

namespace sightline::inline reflect {
namespace {

ExactPlane sum(const ExactPlane& p, const ExactPlane& q) { return {p.normal + q.normal, p.offset + q.offset}; }

// A camera's X, Y and W are forms with integer coefficients over one common positive factor.
struct CameraPlanes {
  ExactPlane x, y, w;
};

CameraPlanes camera_planes(const Camera& camera) {
  const CameraForms<BigInteger> forms = integer_forms(camera, common_exponent(camera));
  const BigInteger& unit = forms.unit;
  // The form is row . (v - origin), times unit * unit.
  const auto plane = [&](const CameraForms<BigInteger>::Vector& row) {
    return ExactPlane{unit * row, -forms.value(row, forms.origin)};
  };
  return {plane(forms.right), plane(forms.up),
          forms.perspective ? plane(forms.forward) : ExactPlane{ExactVector(0, 0, 0), forms.one}};
}

// Returns the form that gives a point what `form` gives its mirror image, times n . n > 0: a point v has the image v -
// 2 h(v) / (n . n) n, with the mirror's form h and its normal n.
ExactPlane in_mirror(const ExactPlane& form, const ExactPlane& mirror) {
  const BigInteger square = dot(mirror.normal, mirror.normal);
  const BigInteger twice = 2 * dot(form.normal, mirror.normal);
  return {square * form.normal - twice * mirror.normal, square * form.offset - twice * mirror.offset};
}

ExactPosition mirrored(const ExactPosition& p, const ExactPlane& mirror) {
  const BigInteger square = dot(mirror.normal, mirror.normal);
  const BigInteger twice = 2 * mirror.height(p);
  return {square * p.xyz - twice * mirror.normal, square * p.w};
}

}  // namespace

ExactPosition exact_eye(const Camera& camera) {
  ExactPosition eye = exact_position(camera.eye.xyz);
  if (camera.eye.w == 0) eye.w = 0;
  return eye;
}

MirrorView::MirrorView(const Camera& camera, const ExactPlane& mirror, int grid_bits)
    : mirror_(mirror), centre_(mirrored(exact_eye(camera), mirror)), grid_bits_(grid_bits) {
  const CameraPlanes planes = camera_planes(camera);
  x_ = in_mirror(planes.x, mirror);
  y_ = in_mirror(planes.y, mirror);
  // The constant form of an orthographic camera stays itself, times the same factor.
  w_ = in_mirror(planes.w, mirror);
  bounds_ = {sum(w_, x_), sum(w_, x_.turned()), sum(w_, y_), sum(w_, y_.turned())};
}

Sign MirrorView::side_of_centre(const ExactPlane& plane) const { return plane.side(centre_); }

ImagePolygon MirrorView::image(CutPolygon polygon) const {
  polygon = part_in_front(polygon, mirror_);
  for (const ExactPlane& bound : bounds_) {
    if (polygon.empty()) return {};
    polygon = part_in_front(polygon, bound);
  }
  ImagePolygon image;
  for (const CutCorner& corner : polygon) {
    ExactCorner seen;
    seen.x = x_.height(corner.position);
    seen.y = y_.height(corner.position);
    seen.w = w_.height(corner.position);
    image.push_back(round_to_grid(seen, grid_bits_));
  }
  return distinct_corners(image);
}

ImagePolygon distinct_corners(const ImagePolygon& corners) {
  ImagePolygon distinct;
  std::unique_copy(corners.begin(), corners.end(), std::back_inserter(distinct));
  while (distinct.size() > 1 && distinct.back() == distinct.front()) distinct.pop_back();
  return distinct.size() < 3 ? ImagePolygon{} : distinct;
}

}  // namespace sightline::inline reflect
