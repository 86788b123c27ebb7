#include "bench/scenes/crossing_meshes.h"

#include <cmath>
#include <numbers>

#include "bench/scenes/scene_parts.h"

namespace sightline::bench {
namespace {

// A turn about the vertical axis, and a place.
struct Stand {
  Point3 at = Point3::Zero();
  double angle = 0;

  [[nodiscard]] Point3 operator()(double x, double y, double z) const {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return as_in_a_file(at + Vector3(c * x - s * z, y, s * x + c * z));
  }
};

class Parts {
 public:
  void add_quad(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const std::size_t first = vertices_.size();
    for (const Point3& p : {a, b, c, d}) vertices_.push_back(p);
    add_triangle(faces_, first, first + 1, first + 2);
    add_triangle(faces_, first, first + 2, first + 3);
  }

  // Twelve triangles around a box between two corners, upright on its stand.
  void add_box(const Stand& stand, const Point3& low, const Point3& high) {
    add_prism(stand, {{{low.x(), low.z()}, {high.x(), low.z()}, {high.x(), high.z()}, {low.x(), high.z()}}}, low.y(),
              high.y());
  }

  // A prism with this many sides around an upright axis.
  void add_cylinder(const Stand& stand, double x, double z, double radius, double low, double high, std::size_t sides) {
    std::vector<std::array<double, 2>> outline;
    for (std::size_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
      outline.push_back({x + radius * std::cos(angle), z + radius * std::sin(angle)});
    }
    add_prism(stand, outline, low, high);
  }

  [[nodiscard]] std::size_t triangle_count() const { return faces_.size(); }
  [[nodiscard]] Mesh mesh() { return build_mesh(std::move(vertices_), std::move(faces_)); }

 private:
  void add_prism(const Stand& stand, const std::vector<std::array<double, 2>>& outline, double low, double high) {
    const std::size_t first = vertices_.size();
    const std::size_t n = outline.size();
    for (const double y : {low, high}) {
      for (const auto& [x, z] : outline) vertices_.push_back(stand(x, y, z));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 == n ? 0 : i + 1;
      add_triangle(faces_, first + i, first + n + i, first + next);
      add_triangle(faces_, first + next, first + n + i, first + n + next);
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      add_triangle(faces_, first, first + i, first + i + 1);
      add_triangle(faces_, first + n, first + n + i + 1, first + n + i);
    }
  }

  std::vector<Point3> vertices_;
  PolygonList faces_;
};

void add_bush(Parts& parts, Random& random, const Point3& at) {
  constexpr std::size_t leaves = 8;
  for (std::size_t i = 0; i < leaves; ++i) {
    const Stand stand{at, std::numbers::pi * (static_cast<double>(i) + random.between(-0.3, 0.3)) / leaves};
    const double low = random.between(0, 0.2);
    const double high = random.between(0.8, 1.2);
    const double width = random.between(0.3, 0.7);
    parts.add_quad(stand(-width, low, -0.01), stand(width, low, 0.02), stand(width, high, -0.02),
                   stand(-width, high, 0.01));
  }
}

void add_chair(Parts& parts, const Stand& stand) {
  for (const double x : {-0.2, 0.2}) {
    for (const double z : {-0.2, 0.2}) parts.add_cylinder(stand, x, z, 0.03, -0.02, z > 0 ? 0.95 : 0.46, 8);
  }
  parts.add_box(stand, {-0.24, 0.42, -0.24}, {0.24, 0.45, 0.24});
  for (const double y : {0.55, 0.7, 0.85}) parts.add_box(stand, {-0.22, y, 0.185}, {0.22, y + 0.06, 0.215});
}

void add_table(Parts& parts, const Stand& stand) {
  for (const double x : {-0.7, 0.7}) {
    for (const double z : {-0.35, 0.35}) parts.add_cylinder(stand, x, z, 0.05, -0.02, 0.74, 12);
  }
  parts.add_box(stand, {-0.8, 0.72, -0.45}, {0.8, 0.75, 0.45});
  parts.add_box(stand, {-0.72, 0.6, -0.37}, {0.72, 0.73, 0.37});
}

void add_room(Parts& parts, Random& random, const Point3& at) {
  const Stand room{at, 0};
  parts.add_box(room, {-2, -0.1, -2}, {2, 0, 2});
  parts.add_box(room, {-2, -0.05, -2.05}, {2, 2.5, -1.95});
  parts.add_box(room, {-2.05, -0.05, -2}, {-1.95, 2.5, 2});
  add_table(parts, {at, random.between(0, 6)});
  for (int chair = 0; chair < 6; ++chair) {
    const double angle = chair + random.between(-0.4, 0.4);
    const double far = random.between(0.6, 1.1);
    add_chair(parts, {at + far * Vector3(std::cos(angle), 0, std::sin(angle)), random.between(0, 6)});
  }
}

// Calls add(place) for places of a square of places, until there are enough triangles.
template <class Add>
Mesh filled(std::size_t triangles, double distance, Add add) {
  Parts parts;
  add(parts, Point3(0, 0, 0));
  const std::size_t count = std::max<std::size_t>(1, triangles / parts.triangle_count());
  const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (std::size_t i = 1; i < count; ++i)
    add(parts, distance * Point3(static_cast<double>(i % across), 0, static_cast<double>(i / across)));
  return parts.mesh();
}

}  // namespace

Mesh block_of_cubes(std::size_t triangles) {
  const auto across = static_cast<std::size_t>(std::cbrt(static_cast<double>(triangles) / 12) + 0.5);
  Parts parts;
  const auto corner = [](std::size_t x, std::size_t y, std::size_t z) {
    return Point3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  };
  for (std::size_t x = 0; x < across; ++x) {
    for (std::size_t y = 0; y < across; ++y) {
      for (std::size_t z = 0; z < across; ++z) parts.add_box({}, corner(x, y, z), corner(x + 1, y + 1, z + 1));
    }
  }
  return parts.mesh();
}

Mesh crossing_leaves(std::size_t triangles) {
  Random random(15);
  return filled(triangles, 0.9, [&](Parts& parts, const Point3& at) {
    add_bush(parts, random, at + Vector3(random.between(-0.3, 0.3), 0, random.between(-0.3, 0.3)));
  });
}

Mesh bolted_plates(std::size_t triangles) {
  Random random(16);
  return filled(triangles, 2.4, [&](Parts& parts, const Point3& at) {
    const Stand stand{at, random.between(0, 0.2)};
    const double play = random.below(2) == 0 ? 0 : 0.001;
    for (int plate = 0; plate < 4; ++plate)
      parts.add_box(stand, {-1, 0.2 * plate, -1}, {1, 0.2 * (plate + 1) - play, 1});
    for (const double x : {-0.7, 0.0, 0.7}) {
      for (const double z : {-0.7, 0.0, 0.7}) {
        parts.add_cylinder(stand, x, z, 0.1, -0.1, 0.9, 12);
        parts.add_cylinder(stand, x, z, 0.18, 0.8, 0.95, 6);
      }
    }
  });
}

Mesh thin_sphere(std::size_t triangles) {
  constexpr std::size_t rows = 16;
  const std::size_t columns = triangles / (2 * rows);
  std::vector<Point3> vertices;
  PolygonList faces;
  for (std::size_t r = 0; r <= rows; ++r) {
    const double latitude = std::numbers::pi * (0.01 + 0.98 * static_cast<double>(r) / rows);
    for (std::size_t c = 0; c < columns; ++c) {
      const double longitude = 2 * std::numbers::pi * static_cast<double>(c) / static_cast<double>(columns);
      vertices.push_back(as_in_a_file(
          {std::sin(latitude) * std::cos(longitude), std::cos(latitude), std::sin(latitude) * std::sin(longitude)}));
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t next = c + 1 == columns ? 0 : c + 1;
      add_triangle(faces, r * columns + c, r * columns + next, (r + 1) * columns + c);
      add_triangle(faces, r * columns + next, (r + 1) * columns + next, (r + 1) * columns + c);
    }
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Mesh furnished_hall(std::size_t triangles) {
  Random random(17);
  return filled(triangles, 4, [&](Parts& parts, const Point3& at) { add_room(parts, random, at); });
}

}  // namespace sightline::bench
