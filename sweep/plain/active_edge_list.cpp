#include "sweep/plain/active_edge_list.h"

#include "geometry/numbers/mix.h"

namespace sightline::inline sweep {

void ActiveEdgeList::set_edges(BundleId b, std::span<const EdgeId> edges) {
  entry(b).bundle.edges.assign(edges.begin(), edges.end());
  for (const EdgeId e : edges) bundle_of_edge_[e.index()] = b;
}

// An edge may come up that nobody knew of before.
void ActiveEdgeList::add_edge(BundleId b, EdgeId e) {
  entry(b).bundle.edges.push_back(e);
  if (e.index() >= bundle_of_edge_.size()) bundle_of_edge_.resize(e.index() + 1);
  bundle_of_edge_[e.index()] = b;
}

BundleId ActiveEdgeList::allocate() {
  if (!free_.empty()) {
    const BundleId b = free_.back();
    free_.pop_back();
    return b;
  }
  entries_.emplace_back();
  entries_.back().priority = mix(entries_.size());
  return BundleId(entries_.size() - 1);
}

BundleId ActiveEdgeList::insert_after(BundleId left) {
  const BundleId b = allocate();
  link(b, left);
  attach(b, left);
  while (entry(b).parent.valid() && entry(entry(b).parent).priority < entry(b).priority) rotate_up(b);
  return b;
}

void ActiveEdgeList::link(BundleId b, BundleId left) {
  const BundleId right = left.valid() ? entry(left).next : first_;
  entry(b).previous = left;
  entry(b).next = right;
  (left.valid() ? entry(left).next : first_) = b;
  (right.valid() ? entry(right).previous : last_) = b;
}

// The entry becomes a leaf: the right child of its list predecessor, or, where that has one, the left child of its list
// successor.
void ActiveEdgeList::attach(BundleId b, BundleId left) {
  Entry& self = entry(b);
  if (!root_.valid()) {
    root_ = b;
  } else if (left.valid() && !entry(left).right.valid()) {
    entry(left).right = b;
    self.parent = left;
  } else {
    entry(self.next).left = b;
    self.parent = self.next;
  }
}

void ActiveEdgeList::erase(BundleId b) {
  while (entry(b).left.valid() || entry(b).right.valid()) {
    const BundleId left = entry(b).left;
    const BundleId right = entry(b).right;
    const bool left_rises = left.valid() && (!right.valid() || entry(left).priority > entry(right).priority);
    rotate_up(left_rises ? left : right);
  }
  const BundleId parent = entry(b).parent;
  replace_child(parent, b, BundleId{});
  const BundleId previous = entry(b).previous;
  const BundleId next = entry(b).next;
  (previous.valid() ? entry(previous).next : first_) = next;
  (next.valid() ? entry(next).previous : last_) = previous;
  const std::uint64_t priority = entry(b).priority;
  entry(b) = Entry{};
  entry(b).priority = priority;
  free_.push_back(b);
  update_visibility(parent);
}

void ActiveEdgeList::replace_child(BundleId parent, BundleId child, BundleId by) {
  if (!parent.valid()) {
    root_ = by;
  } else if (entry(parent).left == child) {
    entry(parent).left = by;
  } else {
    entry(parent).right = by;
  }
}

void ActiveEdgeList::rotate_up(BundleId b) {
  const BundleId parent = entry(b).parent;
  const BundleId grandparent = entry(parent).parent;
  const bool is_left = entry(parent).left == b;
  const BundleId inner = is_left ? entry(b).right : entry(b).left;
  (is_left ? entry(parent).left : entry(parent).right) = inner;
  if (inner.valid()) entry(inner).parent = parent;
  (is_left ? entry(b).right : entry(b).left) = parent;
  replace_child(grandparent, parent, b);
  entry(parent).parent = b;
  entry(b).parent = grandparent;
  entry(parent).subtree_visible = computed_visibility(parent);
  entry(b).subtree_visible = computed_visibility(b);
}

bool ActiveEdgeList::computed_visibility(BundleId b) const {
  return entry(b).visible || subtree_visible(entry(b).left) || subtree_visible(entry(b).right);
}

// Updates upwards from b as far as anything changes.
void ActiveEdgeList::update_visibility(BundleId b) {
  for (; b.valid(); b = entry(b).parent) {
    const bool visible = computed_visibility(b);
    if (visible == entry(b).subtree_visible) return;
    entry(b).subtree_visible = visible;
  }
}

void ActiveEdgeList::visibility_changed(BundleId b) {
  if (entry(b).visible == entry(b).bundle.visible()) return;
  entry(b).visible = entry(b).bundle.visible();
  update_visibility(b);
}

BundleId ActiveEdgeList::nearest_visible_before(BundleId b) const {
  BundleId from = entry(b).left;
  if (!subtree_visible(from)) {
    // Climbs to the first ancestor that lies left of b and is visible, or has a visible left subtree.
    BundleId child = b;
    BundleId a = entry(b).parent;
    while (a.valid() && (entry(a).left == child || !(entry(a).visible || subtree_visible(entry(a).left)))) {
      child = a;
      a = entry(a).parent;
    }
    if (!a.valid() || entry(a).visible) return a;
    from = entry(a).left;
  }
  while (true) {  // the rightmost visible entry of a subtree that has one
    if (subtree_visible(entry(from).right)) {
      from = entry(from).right;
    } else if (entry(from).visible) {
      return from;
    } else {
      from = entry(from).left;
    }
  }
}

}  // namespace sightline::inline sweep
