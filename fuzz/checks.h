// A fuzzer asks this of sightline, by a function per target. libFuzzer calls them with inputs that it makes up (target.cpp),
// the tests with every file of corpus/ (tests/fuzz/fuzz_corpus_test.cpp).
//
// In:  any bytes. Out: nothing; the call returns.
// Errors: Finding where a promise of sightline is broken: what() says which. Any other exception is a finding as well.
#pragma once

#include <stdexcept>
#include <string_view>

namespace sightline::fuzz {

class Finding : public std::logic_error {
  using std::logic_error::logic_error;
};

// The bytes are an OBJ file, and the MTL file that it names: it is read or refused with InputError, without opening any file; the
// mesh is valid, each face is in one region of each kind, and where it is small a fixed
// camera's view of it is valid at every stage; the labelled one is left out where a face's border lies on itself.
void check_obj(std::string_view bytes);

// The bytes are a mesh in any format: it is read or refused with InputError, without opening any file; the mesh is valid,
// and has normals where they are asked for, at the same vertices.
void check_mesh(std::string_view bytes);

// The bytes are a scene file: it is read or refused with InputError, without opening any file; and every camera that
// comes of it sees a fixed small mesh, valid at every stage.
void check_scene_file(std::string_view bytes);

// The bytes are a file of cameras, of whatever format, which scene files name in several ways: it is read or refused with
// InputError, without opening any file; every camera that comes of it has a folder's name of its own and finite numbers.
void check_cameras(std::string_view bytes);

// The bytes choose a camera and up to eight faces of three to five corners on a small grid: every stage is valid, and
// the visible area of each face equals an oracle's: as a rational number where no faces pass through each other and all
// images lie on the integer oracle's grid, else within what rounding to the grid explains; also of the scene moved off the grid.
void check_sweep(std::string_view bytes);

// The bytes choose faces as for check_sweep. Cut along their common lines they are a valid mesh, and the points that cutting makes
// do not depend on the order of the faces.
void check_cutting(std::string_view bytes);

}  // namespace sightline::fuzz
