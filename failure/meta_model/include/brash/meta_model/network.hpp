// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brash::meta_model {

/// The five inputs of Eq. 17.
struct Input {
  double b_lc = 0.0;   ///< b / l_c [-]
  double c_lc = 0.0;   ///< c / l_c [-]
  double theta = 0.0;  ///< [rad]
  double mu1 = 0.0;    ///< out-of-plane over in-plane normal load [-]
  double mu2 = 0.0;    ///< in-plane friction over in-plane normal load [-]
};

/// The two outputs of Eq. 17.
struct Output {
  double sigma_over_p = 0.0;
  double lbreak_over_lc = 0.0;
};

/// Values of the key `format` of a model file, for a Network, a HumpNetwork and a ProfileModel.
inline constexpr const char* kNetworkFormat = "brash-network";
inline constexpr const char* kHumpFormat = "brash-hump-network";
inline constexpr const char* kProfileFormat = "brash-profiles";
/// Of an EdgeResponseModel.
inline constexpr const char* kEdgeFormat = "brash-edge-responses";

/// The format that a model file states; nothing else is checked.
/// @throws InputError when it cannot be read.
std::string model_format(const std::string& path);

inline constexpr int kInputs = 5;
inline constexpr int kOutputs = 2;

/// `{b_lc, c_lc, theta, mu1, mu2}`, the order of the columns of W1.
constexpr std::array<double, kInputs> to_array(const Input& x) { return {x.b_lc, x.c_lc, x.theta, x.mu1, x.mu2}; }
constexpr Input to_input(const std::array<double, kInputs>& x) { return {x[0], x[1], x[2], x[3], x[4]}; }

/// Box that the training inputs fill.
struct Range {
  Input lower;
  Input upper;
};

/// Where an input lies against the range: the paper clamps below and shortens the step above (Sec. 2.2.2).
struct RangeCheck {
  bool below = false;
  bool above = false;
  bool inside() const { return !below && !above; }
};

/// Interface of all networks with the inputs and outputs of Eq. 17.
class ResponseNetwork {
 public:
  virtual ~ResponseNetwork() = default;

  Output predict(const Input& input) const;
  /// `outputs[i] = predict(inputs[i])`, bit by bit; shapes=(n,).
  virtual void predict(std::span<const Input> inputs, std::span<Output> outputs) const = 0;

  virtual const Range& range() const = 0;
  RangeCheck check(const Input& input) const;
  /// `input` moved into the range.
  Input clamp(const Input& input) const;
  /// h / l_c for which the network was trained [-]; the stress is scaled from it by Eq. 19.
  virtual double thickness_over_lc() const = 0;
};

/// Reads a Network or a HumpNetwork, as the file says.
/// @throws InputError naming the file, the place and the error.
std::unique_ptr<ResponseNetwork> read_network(const std::string& path);

/// Normalisation of a feature or target: z = (value - offset) / factor, a z-score over the training rows.
struct Normalisation {
  double offset = 0.0;
  double factor = 1.0;
};

/// Everything that a model file holds besides its hash.
struct NetworkParameters {
  std::array<Normalisation, kInputs> features;  ///< makes X of Eq. 17 from the features below
  std::array<Normalisation, kOutputs> targets;  ///< undone on y of Eq. 17; the targets are ln(sigma/p) and l_break/l_c
  int hidden = 0;                               ///< number of hidden units of all outputs together
  std::vector<double> w1;                       ///< shape=(hidden, kInputs), row by row
  std::vector<double> b1;                       ///< shape=(hidden,)
  std::vector<double> w2;                       ///< shape=(kOutputs, hidden), row by row
  std::vector<double> b2;                       ///< shape=(kOutputs,)
  Range range;
  double thickness_over_lc = 0.1;  ///< h / l_c of the training rows [-]
  std::string data_sha256;         ///< of the database file
};

/// The paper's network, Eq. 17: y = W2 S(W1 X + b1) + b2 with X, y normalised and S the logistic sigmoid.
///
/// X holds the five inputs as five features, each as a z-score:
///
///     ln(b/l_c + 0.1),  ln(c/l_c),  ln(1 + 2 b tan(theta/2) / c),  ln(mu1),  mu2^2.
///
/// The third is the base width over the tip width: it represents theta, and says nothing for b = 0, where theta has no
/// meaning. The last is even, as the stress on the centre line is. y holds ln(sigma/p) and l_break/l_c as z-scores.
///
/// Two networks of the paper's size, one an output, are one network here: W2 has zeros where a hidden unit serves the
/// other output.
class Network final : public ResponseNetwork {
 public:
  /// Takes trained parameters; their shapes are a contract.
  explicit Network(NetworkParameters parameters);

  /// Reads a model file written by `brash failure train`.
  /// @throws InputError naming the file, the place and the error (also when its hash does not fit).
  static Network read(const std::string& path);

  /// Writes the model file (JSON) by rename when whole; reading it gives the same network bit by bit.
  /// @return the content hash that the file states: SHA-256 of its JSON without that key.
  /// @throws RunError when the file cannot be written.
  std::string write(const std::string& path) const;

  using ResponseNetwork::predict;
  void predict(std::span<const Input> inputs, std::span<Output> outputs) const override;
  const Range& range() const override { return parameters_.range; }
  double thickness_over_lc() const override { return parameters_.thickness_over_lc; }
  const NetworkParameters& parameters() const { return parameters_; }

 private:
  NetworkParameters parameters_;
};

}  // namespace brash::meta_model
