// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brash/meta_model/hump_network.hpp"
#include "brash/meta_model/profile_model.hpp"

namespace brash::training {

using meta_model::HumpNetwork;
using meta_model::Input;
using meta_model::kHumps;
using meta_model::Output;

/// The largest stress on one part of the centre line.
struct Hump {
  Output output;
  double plateau_from = 0.0;  ///< |AB| / l_c where the stress of this part first exceeds 99 % of it
  double plateau_to = 0.0;    ///< where it last does
};

/// One row to learn from: the part of the centre line up to kHumpBoundary, and the rest.
struct HumpSample {
  Input input;
  std::array<Hump, kHumps> humps;
};

/// A row that the superposition answers instead of the plate: the largest stress on the centre line up to kHumpBoundary
/// and beyond it.
/// @param input  moved into the range of `model`.
HumpSample hump_sample(const meta_model::ProfileModel& model, const Input& input, double thickness_over_lc);

struct HumpTrainingOptions {
  std::vector<int> hidden{12, 12};
  int max_iterations = 120;  ///< of Levenberg-Marquardt, each network
  int patience = 20;         ///< iterations without a smaller validation loss before a network's training ends
  /// Every so manieth row stops the training and is not learned; odd: an even share of a Sobol sequence lies in one
  /// part of the box.
  int validate_every = 11;
  std::uint64_t seed = 1;  ///< of the first weights
  double thickness_over_lc = 0.1;
  std::string data_sha256{};
};

/// How the training of one of the four networks went.
struct LayeredFit {
  std::string name{};
  int iterations = 0;
  double training_loss = 0.0;
  double validation_loss = 0.0;
  std::string ended{};
};

struct TrainedHumps {
  HumpNetwork network;
  std::vector<LayeredFit> fits;
};

/// Trains the four networks by Levenberg-Marquardt (GSL multilarge_nlinear), each on the sum of squares of
///
///   ln(sigma_predicted / sigma) / (0.005 max(1, 0.25 / (sigma/p)) + 0.3 s)   or
///   ln((l_predicted + 0.03) / (l + 0.03)) / (t (1 + 50 s)),
///
/// t = 0.3 times half the plateau's width in that logarithm, at least 0.01. s is the share by which this hump is below
/// the larger one: of a hump that does not answer only that it is the lower one matters, so its stress is also raised
/// to 0.3 times the larger one's. The same samples and options give the same network.
/// @throws InputError when there are fewer rows than weights.
/// @see docs/theory/fracture-of-the-edge.md
TrainedHumps train_humps(std::span<const HumpSample> samples, const HumpTrainingOptions& options);

}  // namespace brash::training
