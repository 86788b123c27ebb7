// Back-face culling alone: every polygon that faces the eye is seen whole, every other one not at all.
//
// Source: slides 001 ("Izlocanje zadnjih ploskev (backface culling)": F is a back face if (P - eye) dot m_F > 0), 003
//      and 004 ("Back Face Detection": V . N), and Koucky 3.5.
// Precision: object. The sign of (P - eye) dot m_F is exact: projecting the scene has decided it (FacetFacing).
// Cost: O(n).
// Right for: one closed convex body in view, whole; there it solves the visible-surface problem (004).
// Cannot: tell what hides what. Of two bodies, or of one that is not convex, it shows what is hidden, and its parts of
//      different faces overlap. An open surface seen from behind is not shown.
// Departure: Koucky culls vertices, by the mean of the normals around each, and then the triangles that lost one; that
//      takes away triangles along the silhouette, too. Here it is the polygon's own normal, as in the slides.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer back_face_culling();

}  // namespace sightline::peers
