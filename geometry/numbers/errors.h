// Every exception that sightline throws.
//
// InputError and CameraError are thrown at the boundary, where input enters; inside, preconditions hold.
// InternalError reports a broken invariant: a defect of sightline, never of the input. ArithmeticError reports one that
// broke because float or double was asked for (arithmetic.h).
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

// A camera that defines no view: zero direction, singular matrix, angle out of range, ...
class SIGHTLINE_EXPORT CameraError : public Error {
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
