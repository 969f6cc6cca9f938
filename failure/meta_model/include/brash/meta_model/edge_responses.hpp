// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "brash/meta_model/network.hpp"
#include "brash/plate/edge_responses.hpp"

namespace brash::meta_model {

using plate::EdgeGeometry;
using plate::EdgeResponses;

/// One solved geometry.
struct EdgeSample {
  EdgeGeometry geometry;
  EdgeResponses responses;
};

/// Interpolates the responses of a moving ice edge between solved geometries.
///
/// The geometries fill a grid in depth, contact length, angle and thickness, for whole and for split sheets. The
/// responses are written in their principal modes, and the modes' coefficients are interpolated along each axis. A mass
/// ratio other than the database's 0.88 h / l_c scales the times: t / sqrt(mass_ratio + 0.15) stays.
/// @see docs/theory/fracture-of-the-edge.md
class EdgeResponseModel {
 public:
  /// Builds the model from solved geometries.
  /// @throws InputError when they do not fill a grid.
  static EdgeResponseModel fit(std::span<const EdgeSample> samples, const std::string& data_sha256);
  /// @throws InputError naming file, place and error.
  static EdgeResponseModel read(const std::string& path);
  /// Writes the model file (JSON) by rename when whole and returns its content hash.
  std::string write(const std::string& path) const;

  EdgeResponseModel(EdgeResponseModel&&) noexcept;
  EdgeResponseModel& operator=(EdgeResponseModel&&) noexcept;
  ~EdgeResponseModel();

  /// @param geometry  as clamp() leaves it. Its mass ratio may be any.
  EdgeResponses at(const EdgeGeometry& geometry) const;

  RangeCheck check(const EdgeGeometry& geometry) const;
  /// The nearest geometry that at() takes: in the range, or thicker by up to one and a half times the width of a grid
  /// of two thicknesses, along whose straight line it continues.
  EdgeGeometry clamp(const EdgeGeometry& geometry) const;
  /// `{lower, upper}`; mass ratio and split are not limited.
  const std::array<EdgeGeometry, 2>& range() const;
  int n_modes() const;

 private:
  struct Impl;
  explicit EdgeResponseModel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace brash::meta_model
