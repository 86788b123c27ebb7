#include "oracle/truth/fraction.h"

#include <algorithm>

namespace sightline::oracle::image {
namespace {

// The quotient is top / bottom rounded down; cpp_int rounds towards zero.
void floor_quotient(const Integer& top, const Integer& bottom, Integer& quotient) {
  Integer rest;
  divide_qr(top, bottom, quotient, rest);
  if (rest < 0) --quotient;
}

}  // namespace

Key key_of(const Integer& top, const Integer& bottom) {
  static const Integer most = Integer(1) << (key_places + 2);
  const Integer dividend = top << key_places;
  Integer places;
  floor_quotient(dividend, bottom, places);
  if (places > most) return Key{1} << (key_places + 2);
  if (places < -most) return -(Key{1} << (key_places + 2));
  return static_cast<Key>(places);
}

Fraction fraction(Integer top, Integer bottom) {
  if (bottom < 0) return fraction(-top, -bottom);
  const Key key = key_of(top, bottom);
  return {std::move(top), std::move(bottom), key};
}

bool operator<(const Fraction& a, const Fraction& b) {
  return a.key != b.key ? a.key < b.key : a.top * b.bottom < b.top * a.bottom;
}

bool operator==(const Fraction& a, const Fraction& b) { return a.key == b.key && a.top * b.bottom == b.top * a.bottom; }

// Where the keys leave room, this is a number of key_places: key + 1 is beyond a, and what is below b's key is below b.
Fraction between(const Fraction& a, const Fraction& b) {
  if (b.key - a.key < 2) return fraction(a.top * b.bottom + b.top * a.bottom, 2 * a.bottom * b.bottom);
  const Key middle = a.key + (b.key - a.key) / 2;
  return {Integer(middle), Integer(1) << key_places, middle};
}

}  // namespace sightline::oracle::image
