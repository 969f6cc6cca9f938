// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brash/meta_model/network.hpp"

namespace brash::meta_model {

/// The stress along the centre line has a hump beside the load and one farther in. They meet at this |AB| / l_c: of the
/// places where two humps of nearly equal height lie on different sides of a fixed one, it has the most.
inline constexpr double kHumpBoundary = 0.3;
inline constexpr std::size_t kHumps = 2;
inline constexpr int kHumpFeatures = 6;

/// One network of one output: logistic hidden layers, y = W_n S(... S(W_1 X + b_1) ...) + b_n.
struct LayeredNetwork {
  Normalisation target;         ///< undone on y
  std::vector<double> weights;  ///< layer by layer, W row by row and then b
};

/// Everything that the model file of a HumpNetwork holds besides its hash.
struct HumpParameters {
  std::array<Normalisation, kHumpFeatures> features;
  std::vector<int> hidden;                    ///< units of each hidden layer, the same in all networks
  std::array<LayeredNetwork, kHumps> stress;  ///< ln(sigma/p), near hump and far one
  std::array<LayeredNetwork, kHumps> place;   ///< ln(|AB|/l_c + 0.03)
  Range range;
  double thickness_over_lc = 0.1;  ///< h / l_c of the training rows [-]
  std::string data_sha256;         ///< of the superposition that answered the training rows
};

/// Number of weights of a network with `n_inputs` inputs, the hidden layers `hidden` and one output.
std::size_t n_weights(int n_inputs, const std::vector<int>& hidden);

/// A deeper network with the inputs and outputs of Eq. 17: one stress and one place for each of the two humps that the
/// stress along the centre line can have; the hump with the larger stress answers. So the place can jump, which a
/// smooth function cannot, and the stress has a kink there, as the plate's has.
///
/// X holds the features of Network and ln(1 + 2 (b/l_c) / (c/l_c)), each as a z-score.
class HumpNetwork final : public ResponseNetwork {
 public:
  /// Takes trained parameters; their shapes are a contract.
  explicit HumpNetwork(HumpParameters parameters);
  /// @throws InputError naming the file, the place and the error (also when its hash does not fit).
  static HumpNetwork read(const std::string& path);
  /// Writes the model file (JSON) by rename when whole and returns its content hash.
  /// @throws RunError when the file cannot be written.
  std::string write(const std::string& path) const;

  using ResponseNetwork::predict;
  void predict(std::span<const Input> inputs, std::span<Output> outputs) const override;
  const Range& range() const override { return parameters_.range; }
  double thickness_over_lc() const override { return parameters_.thickness_over_lc; }
  const HumpParameters& parameters() const { return parameters_; }

 private:
  HumpParameters parameters_;
};

}  // namespace brash::meta_model
