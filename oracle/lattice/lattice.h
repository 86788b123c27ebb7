// Random scenes are made of this lattice: camera-space points with small integer coordinates, and cameras that map them
// exactly.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "geometry/projection/camera.h"

namespace sightline::lattice {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  // The number is in [low, high]. It does not come from std::uniform_int_distribution, which differs between standard
  // libraries.
  int between(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return between(1, n) == 1; }
  template <class Container>
  const auto& any_of(const Container& items) {
    return items[static_cast<std::size_t>(between(0, static_cast<int>(items.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

// A point is (X, Y) across the view, and `depth` along it.
struct LatticePoint {
  int x = 0;
  int y = 0;
  int depth = 0;
  friend constexpr auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

struct Lattice {
  Projection projection = Projection::perspective;
  int half = 4;             // the window is [-half, half]^2 at depth 1 (at any depth where orthographic)
  int reach = 4;            // points have image coordinates in [-reach, reach]
  std::vector<int> depths;  // powers of two for a pinhole, so that images are exact; 0 and below: behind the eye
  Camera camera;
  Vector3 right = Vector3::Zero();  // unit axes of the input space
  Vector3 up = Vector3::Zero();
  Vector3 forward = Vector3::Zero();
};

[[nodiscard]] Lattice random_lattice(Dice& dice);
[[nodiscard]] LatticePoint random_point(const Lattice& lattice, Dice& dice);

// Returns the point at a depth that has this image.
[[nodiscard]] LatticePoint at_image(const Lattice& lattice, int x, int y, int depth);

// Returns the point at a depth with the image that p has; p where that is no whole number.
[[nodiscard]] LatticePoint at_depth(const Lattice& lattice, const LatticePoint& p, int depth);

// Returns a point with the same image at another depth.
[[nodiscard]] LatticePoint in_line(const Lattice& lattice, const LatticePoint& p, Dice& dice);

// Returns the middle of p and q where that is a point of the lattice, else p.
[[nodiscard]] LatticePoint between(const Lattice& lattice, const LatticePoint& p, const LatticePoint& q);

[[nodiscard]] Point3 position(const Lattice& lattice, const LatticePoint& p);

// Returns all points of the lattice whose image is a whole number.
[[nodiscard]] std::vector<LatticePoint> all_points(const Lattice& lattice);

}  // namespace sightline::lattice
