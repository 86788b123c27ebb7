#include "peers/painters/bsp_tree.h"

#include <algorithm>
#include <cstdlib>

#include "peers/scene/polygon_split.h"

namespace sightline::peers {
namespace {

using PolygonId = Id<struct PolygonTag>;
using PolygonIds = std::vector<PolygonId>;

// The lists are what lies on the sides of F's plane, as the viewer sees them.
struct SplitList {
  PolygonIds nearer;
  PolygonIds farther;
  PolygonIds within;
};

// This is a child that is still to be made.
struct Task {
  PolygonIds list;
  BspNodeId parent;
  bool is_front_child = false;
  std::size_t level = 1;
};

// Returns a sample that is evenly spaced and has at most so many.
PolygonIds sample(const PolygonIds& list, std::size_t most) {
  if (list.size() <= most) return list;
  PolygonIds chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(list[i * list.size() / most]);
  return chosen;
}

class MakeBsp {
 public:
  explicit MakeBsp(std::vector<FlatPolygon> polygons) : polygons_(std::move(polygons)) {}

  BspTree run() {
    PolygonIds all;
    for (std::size_t i = 0; i < polygons_.size(); ++i) all.emplace_back(i);
    add_task({std::move(all), {}, false, 1});
    while (!tasks_.empty()) {
      const Task task = std::move(tasks_.back());
      tasks_.pop_back();
      make_node(task);
    }
    return std::move(tree_);
  }

 private:
  [[nodiscard]] const FlatPolygon& polygon(PolygonId id) const { return polygons_[id.index()]; }

  void add_task(Task task) {
    if (!task.list.empty()) tasks_.push_back(std::move(task));
  }

  void make_node(const Task& task) {
    const BspNodeId node = new_node(task);
    const PolygonId f = choose_from(task.list);
    SplitList split = split_all(task.list, f);
    const bool viewer_is_in_front = polygon(f).is_front;
    tree_.nodes[node.index()].root = root_of(split.within);
    tree_.nodes[node.index()].viewer_is_in_front = viewer_is_in_front;
    add_task({std::move(split.nearer), node, viewer_is_in_front, task.level + 1});
    add_task({std::move(split.farther), node, !viewer_is_in_front, task.level + 1});
  }

  BspNodeId new_node(const Task& task) {
    const BspNodeId node(tree_.nodes.size());
    tree_.nodes.emplace_back();
    tree_.height = std::max(tree_.height, task.level);
    if (!task.parent.valid()) return node;
    BspNode& parent = tree_.nodes[task.parent.index()];
    (task.is_front_child ? parent.front_child : parent.back_child) = node;
    return node;
  }

  [[nodiscard]] PolygonId choose_from(const PolygonIds& list) const {
    const PolygonIds others = sample(list, 64);
    PolygonId best;
    std::int64_t least = 0;
    for (const PolygonId candidate : sample(list, 8)) {
      const std::int64_t cost = cost_of(candidate, others);
      if (best.valid() && cost >= least) continue;
      best = candidate;
      least = cost;
    }
    return best;
  }

  [[nodiscard]] std::int64_t cost_of(PolygonId f, const PolygonIds& others) const {
    std::int64_t splits = 0;
    std::int64_t balance = 0;
    for (const PolygonId other : others) {
      const Side side = side_of(polygon(other), polygon(f).plane);
      splits += side == Side::across ? 1 : 0;
      balance += side == Side::nearer ? 1 : (side == Side::farther ? -1 : 0);
    }
    return 8 * splits + std::abs(balance);
  }

  SplitList split_all(const PolygonIds& list, PolygonId f) {
    const DepthPlane plane = polygon(f).plane;
    SplitList result;
    for (const PolygonId id : list) {
      const Side side = id == f ? Side::within : side_of(polygon(id), plane);
      if (side == Side::within) result.within.push_back(id);
      if (side == Side::nearer) result.nearer.push_back(id);
      if (side == Side::farther) result.farther.push_back(id);
      if (side == Side::across) split_one(id, plane, result);
    }
    return result;
  }

  void split_one(PolygonId id, const DepthPlane& plane, SplitList& result) {
    Halves halves = split(polygon(id), plane);
    polygons_[id.index()] = std::move(halves.nearer);
    result.nearer.push_back(id);
    result.farther.emplace_back(polygons_.size());
    polygons_.push_back(std::move(halves.farther));
    ++tree_.splits;
  }

  [[nodiscard]] std::vector<FlatPolygon> root_of(const PolygonIds& within) const {
    std::vector<FlatPolygon> root;
    for (const PolygonId id : within) root.push_back(polygon(id));
    std::stable_sort(root.begin(), root.end(),
                     [](const FlatPolygon& a, const FlatPolygon& b) { return is_in_front_in_plane(b, a); });
    return root;
  }

  std::vector<FlatPolygon> polygons_;
  std::vector<Task> tasks_;
  BspTree tree_;
};

// A tree is to be displayed: all of it or, once the child on the other side is displayed, only its root.
struct ToDisplay {
  BspNodeId tree;
  bool root_only = false;
};

}  // namespace

BspTree make_bsp(const std::vector<FlatPolygon>& list) { return MakeBsp(list).run(); }

BackToFront display_bsp(const BspTree& tree) {
  BackToFront displayed;
  std::vector<ToDisplay> stack;
  if (!tree.nodes.empty()) stack.push_back({BspNodeId(0)});
  while (!stack.empty()) {
    const ToDisplay next = stack.back();
    stack.pop_back();
    if (!next.tree.valid()) continue;
    const BspNode& node = tree.nodes[next.tree.index()];
    if (next.root_only) {
      displayed.insert(displayed.end(), node.root.begin(), node.root.end());
    } else {
      stack.push_back({node.viewer_is_in_front ? node.front_child : node.back_child});
      stack.push_back({next.tree, true});
      stack.push_back({node.viewer_is_in_front ? node.back_child : node.front_child});
    }
  }
  return displayed;
}

Peer bsp_tree() {
  return {"bsp-tree",
          "BSP tree",
          "Slides 001 (BSP trees), 003 (BSP_display)",
          ComputedAt::image_precision,
          "Chooses a polygon, splits all others by its plane, and does the same to those in front of it and to those "
          "behind it, which makes a tree. For any eye, what is on the other side of a polygon's plane is painted "
          "first, then the polygon, then what is on the eye's own side. The tree is the same for all eyes; here it is "
          "used for one.",
          "Planes reach beyond their polygons and split what they never hide: there may be many more parts than "
          "polygons, and for a convex body the tree is a list. Sides are computed in doubles with a tolerance: of "
          "surfaces nearer to each other in depth than about 10^-12 the wrong one may come out in front. What is "
          "painted is as coarse as the pixels: a centre decides for the whole pixel.",
          [](const FlatScene& scene, int resolution) {
            const BspTree tree = make_bsp(scene.polygons);
            const BackToFront displayed = display_bsp(tree);
            Painting painting = paint(displayed, resolution);
            return Outcome{std::move(painting.buffer),
                           {{"nodes", tree.nodes.size()},
                            {"height of the tree", tree.height},
                            {"splits", tree.splits},
                            {"polygons painted", displayed.size()},
                            {"pixels painted", painting.pixels_painted}}};
          }};
}

}  // namespace sightline::peers
