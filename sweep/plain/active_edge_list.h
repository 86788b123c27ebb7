// The active edge list (AEL): the bundles of edges that cross the sweep line, left to right (Fang 5.3.1).
//
// A bundle is all edges that lie on each other at the sweep line. It is one entry of the list; it owns the node list
// of the span to its right, and the visible segments that are open along it.
// Holds: the list is in the order in which the sweep line crosses the bundles; an edge is in at most one bundle.
// Complexity: next and previous O(1); insert, erase, find and nearest_visible O(log n) expected. A treap (Aragon and
// Seidel 1989) with parent links over a linked list; its priorities are a hash of the entry's number, so that every
// run builds the same tree.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "geometry/numbers/ids.h"
#include "sweep/plain/node_list.h"

namespace sightline::inline sweep {

using BundleId = Id<struct BundleTag>;

// An open segment is visible and has not reached its lower end yet.
struct OpenSegment {
  SegmentId segment;  // invalid: none
  EdgeId edge;        // the edge it runs along
  FacetId facet;      // the visible facet on its side of the bundle
  FacetId other;      // the topmost facet on the bundle's other side
};

struct Bundle {
  boost::container::small_vector<EdgeId, 2> edges;
  NodeList right;
  OpenSegment left_segment;   // of the topmost facet to the left
  OpenSegment right_segment;  // of the topmost facet to the right
  std::uint64_t mark = 0;     // the number of the last sweep point that found edges of the bundle to end or cross there

  [[nodiscard]] std::span<const EdgeId> edge_span() const { return {edges.data(), edges.size()}; }
  [[nodiscard]] bool visible() const { return left_segment.segment.valid() || right_segment.segment.valid(); }
};

class ActiveEdgeList {
 public:
  explicit ActiveEdgeList(std::size_t edge_count) : bundle_of_edge_(edge_count) {}

  // Returns the bundle an active edge is in; invalid for an edge that is not active any more, or not yet.
  [[nodiscard]] BundleId bundle_of(EdgeId e) const { return bundle_of_edge_[e.index()]; }
  // The same question of an edge that may never have been heard of.
  [[nodiscard]] bool is_active(EdgeId e) const { return e.index() < bundle_of_edge_.size() && bundle_of(e).valid(); }
  void set_edges(BundleId b, std::span<const EdgeId> edges);
  void add_edge(BundleId b, EdgeId e);
  void deactivate(EdgeId e) { bundle_of_edge_[e.index()] = BundleId{}; }

  [[nodiscard]] Bundle& operator[](BundleId b) { return entries_[b.index()].bundle; }
  [[nodiscard]] const Bundle& operator[](BundleId b) const { return entries_[b.index()].bundle; }

  [[nodiscard]] bool empty() const { return !root_.valid(); }
  [[nodiscard]] BundleId first() const { return first_; }
  [[nodiscard]] BundleId next(BundleId b) const { return entries_[b.index()].next; }
  [[nodiscard]] BundleId previous(BundleId b) const { return entries_[b.index()].previous; }

  // Inserts an empty bundle right of `left` (invalid: at the very left).
  BundleId insert_after(BundleId left);
  void erase(BundleId b);

  // This is called when bundle b has become visible or invisible.
  void visibility_changed(BundleId b);

  // Returns the nearest visible bundle left of b, or invalid.
  [[nodiscard]] BundleId nearest_visible_before(BundleId b) const;

  // Returns the first bundle for which `left_of_point(bundle)` is false, or invalid; the predicate is true for a prefix
  // of the list.
  template <class Predicate>
  [[nodiscard]] BundleId find(Predicate left_of_point) const {
    BundleId found;
    for (BundleId b = root_; b.valid();) {
      const bool go_right = left_of_point(entries_[b.index()].bundle);
      if (!go_right) found = b;
      b = go_right ? entries_[b.index()].right : entries_[b.index()].left;
    }
    return found;
  }
  [[nodiscard]] BundleId last() const { return last_; }

 private:
  struct Entry {
    Bundle bundle;
    BundleId previous, next;       // in the list
    BundleId parent, left, right;  // in the tree
    std::uint64_t priority = 0;    // larger above smaller
    bool visible = false;          // of the bundle, as last announced
    bool subtree_visible = false;  // of any bundle in the subtree
  };

  [[nodiscard]] Entry& entry(BundleId b) { return entries_[b.index()]; }
  [[nodiscard]] const Entry& entry(BundleId b) const { return entries_[b.index()]; }
  BundleId allocate();
  void link(BundleId b, BundleId left);
  void attach(BundleId b, BundleId left);
  void rotate_up(BundleId b);
  void replace_child(BundleId parent, BundleId child, BundleId by);
  [[nodiscard]] bool computed_visibility(BundleId b) const;
  void update_visibility(BundleId b);
  [[nodiscard]] bool subtree_visible(BundleId b) const { return b.valid() && entry(b).subtree_visible; }

  std::vector<Entry> entries_;
  std::vector<BundleId> free_;
  std::vector<BundleId> bundle_of_edge_;
  BundleId root_, first_, last_;
};

}  // namespace sightline::inline sweep
