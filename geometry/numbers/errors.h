// The exceptions that the library throws, and where.
//
//   InputError             read_obj, for a file that is refused
//   CameraError            the functions that make a camera (camera.h)
//   PanelError             panel_mesh, and make_mirror_world, which calls it (panel.h)
//   std::invalid_argument  build_mesh, for a coordinate that is not finite and a corner that names no vertex
//   InternalError          every stage from the sweep on, where an invariant is broken: that is a defect of sightline,
//                          never of the input
//   ArithmeticError        the projection and the stages after it, where an invariant broke because float or double
//                          was asked for (arithmetic.h)
//   std::runtime_error     png_image, where libpng fails
//   std::bad_alloc         whatever needs memory
//
// The first four are thrown at the boundary, where input enters; inside, preconditions hold. Two more are caught within
// the library: ConstraintConflict (constrained_delaunay.h), an InternalError where it is not expected, makes the
// labelling give a surface one label, and TokenTooLong (obj_scanner.h) becomes an InputError.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

class SIGHTLINE_EXPORT Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The input is wrong. what() reads "FILE:LINE: cause" (or "FILE: cause" where no line applies; line() is then 0).
class SIGHTLINE_EXPORT InputError : public Error {
 public:
  InputError(const std::string& file, std::size_t line, const std::string& cause)
      : Error(file + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + cause), line_(line) {}
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

// A camera defines no view: zero direction, singular matrix, angle out of range, ...
class SIGHTLINE_EXPORT CameraError : public Error {
  using Error::Error;
};

// A panel is no planar polygon; what() names it and says why.
class PanelError : public Error {
  using Error::Error;
};

// An invariant of the program does not hold; what() says which, and where in the sweep.
class SIGHTLINE_EXPORT InternalError : public Error {
  using Error::Error;
};

// The arithmetic that was asked for is too weak for this view; what() says which invariant broke, and where.
class SIGHTLINE_EXPORT ArithmeticError : public Error {
 public:
  ArithmeticError(const std::string& arithmetic, const std::string& broken)
      : Error(arithmetic + " arithmetic is too weak for this view: " + broken + "; use exact"), broken_(broken) {}
  [[nodiscard]] const std::string& broken() const { return broken_; }

 private:
  std::string broken_;
};

}  // namespace sightline::inline geometry
