# The headers that are installed: those that a program begins with, those of the stages (docs/how-it-works.md), those that
# write results, and what these include. tests/consumer/headers compiles each of them alone against what is installed.
set(sightline_headers
  sightline/sightline.h
  sightline/analyzer.h
  sightline/options.h
  sightline/view.h
  sightline/matrices.h
  sightline/version.h

  geometry/mesh/mesh.h
  geometry/mesh/vertex_normals.h
  geometry/mesh/cut_mesh.h
  geometry/projection/camera.h
  reflect/world/panel.h
  reflect/world/flush_panels.h
  reflect/world/obstacles.h
  reflect/world/reflection_options.h
  coverage/coverage.h
  geometry/numbers/arithmetic.h
  geometry/numbers/errors.h
  geometry/numbers/ids.h
  geometry/numbers/vector3.h

  formats/reading/mesh_reader.h
  formats/reading/obj_reader.h
  geometry/cutting/interpenetration.h
  geometry/cutting/common_lines.h
  geometry/cutting/coincidence.h
  geometry/projection/culling.h
  geometry/projection/projected_scene.h
  sweep/engine.h
  sweep/plain/sweep.h
  sweep/segments/visible_segments.h
  reconstruct/polygons/visible_polygons.h
  reconstruct/labelling/labelled_mesh.h
  reflect/world/mirror_world.h
  reflect/reflections.h
  reflect/triangles/reflecting_triangles.h
  coverage/seen_part.h
  coverage/union_share.h

  formats/writing/coverage_table.h
  formats/writing/labelled_obj.h
  formats/writing/labelled_ply.h
  formats/writing/segments_table.h
  formats/writing/view_svg.h

  formats/reading/face_regions.h
  formats/reading/mesh_file.h
  formats/reading/read_limits.h
  formats/writing/text_buffer.h
  formats/writing/window_points.h
  geometry/mesh/box_hierarchy.h
  geometry/numbers/exact_integer.h
  geometry/numbers/exact_position.h
  geometry/numbers/export.h
  geometry/numbers/image_point.h
  geometry/numbers/predicates.h
  geometry/projection/clipping.h
  geometry/projection/lens.h
  geometry/projection/lens_image.h
  geometry/projection/exact_place.h
  sweep/plain/depth_ranges.h
  sweep/segments/swap_edge.h)
