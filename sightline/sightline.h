// Everything a user of the library needs; each header says what goes in and out of its stage.
#pragma once

#include "geometry/camera.h"
#include "geometry/common_lines.h"
#include "geometry/culling.h"
#include "geometry/errors.h"
#include "geometry/ids.h"
#include "geometry/interpenetration.h"
#include "geometry/mesh.h"
#include "geometry/obj_reader.h"
#include "geometry/predicates.h"
#include "geometry/projected_scene.h"
#include "geometry/vector3.h"
#include "reconstruct/labelled_mesh.h"
#include "reconstruct/visible_polygons.h"
#include "sightline/analyze.h"
#include "sweep/sweep.h"
#include "sweep/visible_segments.h"
