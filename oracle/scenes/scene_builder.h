// The builder grows a random scene face by face; it takes only what keeps the promises of random_scenes.h.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "oracle/lattice/lattice.h"
#include "oracle/lattice/pair_relation.h"
#include "oracle/scenes/random_scenes.h"

namespace sightline::lattice {

using Corners = std::vector<std::uint32_t>;

// This says whether faces may pass through each other.
enum class Crossings { none, allowed };

class SceneBuilder {
 public:
  SceneBuilder(Lattice lattice, Dice& dice, Crossings crossings = Crossings::none)
      : lattice_(std::move(lattice)), dice_(&dice), crossings_(crossings) {}

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] const std::vector<LatticePoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<Corners>& faces() const { return faces_; }
  [[nodiscard]] const SceneNotes& notes() const { return notes_; }

  // Returns a vertex at the point: mostly the one that is there already, sometimes a second one.
  std::uint32_t vertex(const LatticePoint& p);

  // Adds all of the faces or, where one of them breaks a promise, none. A face is planar or has four corners.
  bool add(const std::vector<Corners>& faces);

 private:
  struct Proposal {
    std::vector<LatticePoint> key;   // its corners, sorted
    std::vector<PlacedFace> pieces;  // itself, or both triangulations where it is not planar
    SceneNotes notes;
  };
  [[nodiscard]] std::optional<Proposal> propose(const Corners& corners) const;
  [[nodiscard]] std::optional<PlacedFace> place(const std::vector<LatticePoint>& corners) const;
  [[nodiscard]] bool fits(Proposal& proposal) const;
  [[nodiscard]] bool add_one(const Corners& corners);

  Lattice lattice_;
  Dice* dice_;
  Crossings crossings_;
  std::vector<LatticePoint> points_;
  std::vector<Corners> faces_;
  std::vector<PlacedFace> placed_;
  std::set<std::vector<LatticePoint>> keys_;
  SceneNotes notes_;
};

// Returns the scene as grown, without the faces beyond so many and without vertices that no face uses, but for one.
[[nodiscard]] RandomScene scene_of(const SceneBuilder& builder, std::uint64_t seed, Sides sides,
                                   std::size_t most_faces);

}  // namespace sightline::lattice
