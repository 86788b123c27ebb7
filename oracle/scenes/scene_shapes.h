// Random scenes are made of these shapes. Each takes points that the scene has, or new ones, and adds itself where that
// breaks no promise of the builder's.
#pragma once

#include <vector>

#include "oracle/scenes/scene_builder.h"

namespace sightline::lattice {

// Returns corners that are there, some before or behind such a one, middles of two, or new ones.
[[nodiscard]] std::vector<LatticePoint> some_points(const SceneBuilder& scene, Dice& dice, int count);

[[nodiscard]] Corners vertices(SceneBuilder& scene, const std::vector<LatticePoint>& points);

void add_triangle(SceneBuilder& scene, Dice& dice);

// Adds a polygon of four to six corners, whatever shape comes, in a plane of three points.
void add_polygon(SceneBuilder& scene, Dice& dice, const std::vector<LatticePoint>& three);

// Adds a face in the plane of one that is there already.
void add_coplanar(SceneBuilder& scene, Dice& dice);

// Adds a face before or behind one that is there, so that their edges coincide in the image; one corner may be another.
void add_shadow(SceneBuilder& scene, Dice& dice);

void add_quadrangle(SceneBuilder& scene, Dice& dice);
void add_fan(SceneBuilder& scene, Dice& dice);
void add_strip(SceneBuilder& scene, Dice& dice);
void add_tetrahedron(SceneBuilder& scene, Dice& dice);

// Adds a box along the axes of the view.
void add_box(SceneBuilder& scene, Dice& dice);

}  // namespace sightline::lattice
