// A program of somebody else: what does a camera see of a square and of a triangle behind it?
#include <sightline/sightline.h>

#include <iostream>

int main() {
  sightline::PolygonList faces;
  faces.push_back(
      std::array{sightline::VertexId{0}, sightline::VertexId{1}, sightline::VertexId{2}, sightline::VertexId{3}});
  faces.push_back(std::array{sightline::VertexId{4}, sightline::VertexId{5}, sightline::VertexId{6}});
  const sightline::Analyzer analyzer(sightline::build_mesh(
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-3, 0, -1}, {3, 0, -1}, {0, 0.5, -1}}, std::move(faces)));
  const sightline::ViewPoint view{.eye = {0, 0, 8}, .target = {0, 0, 0}};
  const sightline::View result = analyzer.view(sightline::perspective_camera("front", view, 60));
  for (const sightline::VisiblePolygon& polygon : result.polygons.polygons) {
    std::cout << "face " << polygon.face.value << " shows " << polygon.area << '\n';
  }
}
