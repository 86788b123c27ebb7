// This is a bijection on 64 bits that spreads neighbouring numbers: SplitMix64's finaliser (Steele, Lea, Flood 2014).
// It is for priorities and fingerprints that must be the same in every run; nothing is ordered or found by it.
#pragma once

#include <cstdint>

namespace sightline::inline geometry {

constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace sightline::inline geometry
