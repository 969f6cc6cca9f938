// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// Four numbers: the arithmetic of the four runs side by side.
class Lanes {
 public:
  Lanes() = default;
  Lanes(double all) : low_{all, all}, high_{all, all} {}
  Lanes(double a, double b, double c, double d) : low_{a, b}, high_{c, d} {}

  double operator[](std::size_t i) const { return i < 2 ? low_[i] : high_[i - 2]; }

  friend Lanes operator+(Lanes a, Lanes b) { return {a.low_ + b.low_, a.high_ + b.high_}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.low_ - b.low_, a.high_ - b.high_}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.low_ * b.low_, a.high_ * b.high_}; }
  friend Lanes operator-(Lanes a) { return {-a.low_, -a.high_}; }
  Lanes& operator+=(Lanes b) { return *this = *this + b; }

  friend Lanes min(Lanes a, Lanes b) { return {lesser(a.low_, b.low_), lesser(a.high_, b.high_)}; }
  friend Lanes max(Lanes a, Lanes b) { return {greater(a.low_, b.low_), greater(a.high_, b.high_)}; }
  friend Lanes abs(Lanes a) { return max(a, -a); }
  friend Lanes sqrt(Lanes a) {
    return {Pair{std::sqrt(a.low_[0]), std::sqrt(a.low_[1])}, Pair{std::sqrt(a.high_[0]), std::sqrt(a.high_[1])}};
  }

  friend double sum(Lanes a) {
    const Pair two = a.low_ + a.high_;
    return two[0] + two[1];
  }
  friend bool any_above(double limit, Lanes a) {
    const Pair two = greater(a.low_, a.high_);
    return static_cast<bool>((two[0] > limit) | (two[1] > limit));
  }
  friend double least(Lanes a) {
    const Pair two = lesser(a.low_, a.high_);
    return std::min(two[0], two[1]);
  }
  friend double greatest(Lanes a) {
    const Pair two = greater(a.low_, a.high_);
    return std::max(two[0], two[1]);
  }

 private:
  using Pair = double __attribute__((vector_size(16)));  // every x86-64 machine has registers of two
  Lanes(Pair low, Pair high) : low_(low), high_(high) {}
  static Pair lesser(Pair a, Pair b) { return a < b ? a : b; }
  static Pair greater(Pair a, Pair b) { return a > b ? a : b; }

  Pair low_{};
  Pair high_{};
};

/// Four vectors.
struct Vectors {
  Lanes x;
  Lanes y;
  Lanes z;

  friend Vectors operator+(const Vectors& a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vectors operator-(const Vectors& a, const Vectors& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vectors operator*(Lanes s, const Vectors& a) { return {s * a.x, s * a.y, s * a.z}; }
  Vectors& operator+=(const Vectors& b) { return x += b.x, y += b.y, z += b.z, *this; }
  friend Vectors abs(const Vectors& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
  friend Lanes dot(const Vectors& a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vectors cross(Vec3 a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Vec3 sum(const Vectors& a) { return {sum(a.x), sum(a.y), sum(a.z)}; }
};

}  // namespace brash::hydrodynamics
