#include "reflect/world/panel.h"

namespace sightline::inline reflect {

Mesh panel_mesh(const Panel& panel) {
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < panel.corners.size(); ++i) corners.emplace_back(i);
  PolygonList faces;
  faces.push_back(corners);
  Mesh mesh = build_mesh(panel.corners, std::move(faces));
  const auto refuse = [&](const std::string& cause) { throw PanelError("panel \"" + panel.name + "\": " + cause); };
  if (!mesh.defects.empty()) refuse(to_string(mesh.defects.front().defect));
  if (mesh.face_planar.front() == 0) refuse("its corners are not in one plane");
  return mesh;
}

}  // namespace sightline::inline reflect
