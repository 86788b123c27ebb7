#include "peers/pixels/watkins.h"

#include <algorithm>
#include <tuple>

#include "peers/errors/pixel_cover.h"
#include "peers/scene/nearest.h"

namespace sightline::peers {
namespace {

struct EdgeEntry {
  double x = 0;  // where the scan line is; in ET, where the first one crosses the edge
  double y_max = 0;
  double delta_x = 0;
  PolygonNumber id = no_polygon;
};

bool operator<(const EdgeEntry& a, const EdgeEntry& b) {
  return std::tie(a.x, a.delta_x, a.id) < std::tie(b.x, b.delta_x, b.id);
}

// The ID is the entry's place in the table.
struct PolygonEntry {
  DepthPlane plane_equation;
  FaceId shading_info;
  bool in = false;  // the in-out flag
};

using EdgeTable = std::vector<std::vector<EdgeEntry>>;  // per row: the edges of which it is the lowest scan line
using PolygonTable = std::vector<PolygonEntry>;
using ActiveEdgeTable = std::vector<EdgeEntry>;

void add_edge(EdgeTable& edge_table, const ItemBuffer& buffer, const Corner& p, const Corner& q, PolygonNumber id) {
  const Corner& low = p.y < q.y ? p : q;
  const Corner& high = p.y < q.y ? q : p;
  const PixelRange rows = rows_between(buffer, low.y, high.y);
  if (rows.empty()) return;
  const int first = rows.end - 1;
  const double slope = (high.x - low.x) / (high.y - low.y);
  edge_table[static_cast<std::size_t>(first)].push_back(
      {low.x + slope * (buffer.y_of(first) - low.y), high.y, slope * 2 / buffer.resolution(), id});
}

EdgeTable edge_table_of(const FlatScene& scene, const ItemBuffer& buffer) {
  EdgeTable edge_table(static_cast<std::size_t>(buffer.resolution()));
  for (PolygonNumber id = 0; id < scene.polygons.size(); ++id) {
    const std::vector<Corner>& corners = scene.polygons[id].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add_edge(edge_table, buffer, corners[i], corners[(i + 1) % corners.size()], id);
    }
  }
  return edge_table;
}

PolygonTable polygon_table_of(const FlatScene& scene) {
  PolygonTable table;
  for (const FlatPolygon& polygon : scene.polygons) table.push_back({polygon.plane, polygon.face, false});
  return table;
}

class ScanLines {
 public:
  ScanLines(const FlatScene& scene, int resolution)
      : buffer_(resolution), edge_table_(edge_table_of(scene, buffer_)), polygon_table_(polygon_table_of(scene)) {}

  Outcome run() && {
    for (int row = buffer_.resolution() - 1; row >= 0; --row) {
      update_active_edges(row);
      scan(row);
    }
    return {std::move(buffer_),
            {{"active edges", active_edges_}, {"sample spans", sample_spans_}, {"depths computed", depths_}}};
  }

 private:
  void update_active_edges(int row) {
    const double y = buffer_.y_of(row);
    const auto is_over = [y](const EdgeEntry& edge) { return edge.y_max <= y; };
    aet_.erase(std::remove_if(aet_.begin(), aet_.end(), is_over), aet_.end());
    for (EdgeEntry& edge : aet_) edge.x += edge.delta_x;
    const std::vector<EdgeEntry>& starting = edge_table_[static_cast<std::size_t>(row)];
    aet_.insert(aet_.end(), starting.begin(), starting.end());
    std::sort(aet_.begin(), aet_.end());
    active_edges_ += aet_.size();
  }

  // Between two active edges the same polygons are in.
  void scan(int row) {
    PixelRange span;
    for (const EdgeEntry& edge : aet_) {
      span.end = first_column_from(buffer_, edge.x);
      if (!in_.empty() && !span.empty()) show(span, row);
      span.begin = span.end;
      pass(edge.id);
    }
  }

  void pass(PolygonNumber id) {
    PolygonEntry& polygon = polygon_table_[id];
    polygon.in = !polygon.in;
    if (polygon.in) {
      in_.push_back(id);
    } else {
      in_.erase(std::find(in_.begin(), in_.end(), id));
    }
  }

  void show(PixelRange span, int row) {
    ++sample_spans_;
    const PolygonNumber front = nearest(span.begin, row);
    const PolygonNumber last = nearest(span.end - 1, row);
    if (front != last) return show_parts(span, row, crossing_column(front, last, span, row));
    for (int column = span.begin; column < span.end; ++column) {
      buffer_.paint(column, row, polygon_table_[front].shading_info);
    }
  }

  void show_parts(PixelRange span, int row, int column) {
    show({span.begin, column}, row);
    show({column, span.end}, row);
  }

  // Returns the first column right of where the two segments cross, so that both parts of the span have a pixel.
  int crossing_column(PolygonNumber p, PolygonNumber q, PixelRange span, int row) const {
    const DepthPlane& one = polygon_table_[p].plane_equation;
    const DepthPlane& other = polygon_table_[q].plane_equation;
    const double x = -((one.b - other.b) * buffer_.y_of(row) + (one.c - other.c)) / (one.a - other.a);
    return std::clamp(first_column_from(buffer_, x), span.begin + 1, span.end - 1);
  }

  // Returns the nearest of those that are in. A single one needs no depth.
  PolygonNumber nearest(int column, int row) {
    if (in_.size() == 1) return in_.front();
    Nearest front;
    for (const PolygonNumber id : in_) {
      front.consider(id, polygon_table_[id].plane_equation.at(buffer_.x_of(column), buffer_.y_of(row)));
    }
    depths_ += in_.size();
    return front.polygon;
  }

  ItemBuffer buffer_;
  EdgeTable edge_table_;
  PolygonTable polygon_table_;
  ActiveEdgeTable aet_;
  std::vector<PolygonNumber> in_;  // the polygons whose in-out flag says in
  std::uint64_t active_edges_ = 0;
  std::uint64_t sample_spans_ = 0;
  std::uint64_t depths_ = 0;
};

}  // namespace

Peer watkins() {
  return {
      "watkins",
      "Watkins' scan line algorithm",
      "slides 003, \"Watkins-ov postupak\"",
      ComputedAt::image_precision,
      "Goes through the image row by row. The edges that the row crosses, sorted from left to right, divide it into "
      "spans; passing an edge turns its polygon's in-out flag. Inside a span the same polygons are in from end to end, "
      "so the depths at its two ends tell which one is in front all along, and the pixels between are filled without "
      "a further test. From row to row only the places of the edges change, by one addition each.",
      "Along the row it knows where edges are to the precision of its numbers, but it paints pixels by their centres "
      "and knows nothing of what happens between two rows: so the steps along edges are those of ray casting, and "
      "faces between two rows of centres are missed. Because the places of edges are added up, a pixel whose centre "
      "an edge almost touches may go to the wrong side.",
      [](const FlatScene& scene, int resolution) { return ScanLines(scene, resolution).run(); }};
}

}  // namespace sightline::peers
