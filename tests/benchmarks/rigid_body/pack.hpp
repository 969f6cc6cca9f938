// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

/// One pack of floes, pressed together and at rest in the end, and the engine that steps it: one for each executable.
namespace pack {

struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

/// A floe with upright sides, its corners along the axes.
struct Floe {
  Vec3 size{};   ///< [m]
  Vec3 start{};  ///< centre [m]
  Vec3 rest{};   ///< centre when all are pressed together [m]
  double mass = 0.0;
};

/// Layers of rafted floes between the bed z = 0 and a wall x = 0, both without friction; every second layer is shifted
/// by half a floe both ways, with halves and quarters at its ends. Each floe bears its weight and a push of kPush times
/// its weight towards the wall. So the rest is known: no gaps, the bed bears the weight and the wall the push.
struct Pack {
  std::vector<Floe> floes;
  double mass() const;
};

inline constexpr double kGravity = 9.81;    ///< [m/s2]
inline constexpr double kPush = 0.2;        ///< over the weight
inline constexpr double kFriction = 0.3;    ///< between floes
inline constexpr double kSeconds = 3.0;     ///< simulated
inline constexpr double kMeasured = 1.0;    ///< at their end: forces are compared here
inline constexpr double kBedExtent = 40.0;  ///< half size of bed and wall where they are boxes [m]

Pack make_pack(int along, int across, int layers);

/// How an engine steps.
struct Settings {
  double dt = 0.01;         ///< [s]
  int iterations = 50;      ///< of its solver a step; the engine defines an iteration
  double crushing = 0.5e6;  ///< the program's contacts give way at this, far above every pressure here [Pa]; inf: rigid
};

/// Forces on bed and wall in one step [N].
struct Loads {
  double bed = 0.0;
  double wall = 0.0;
};

/// An engine with the pack in it.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual Loads step() = 0;
  virtual Vec3 centre(std::size_t floe) const = 0;
};

/// The engine of this executable.
std::unique_ptr<Engine> make_engine(const Pack& pack, const Settings& settings);

/// The results of a run.
struct Outcome {
  double seconds = 0.0;         ///< CPU time of a simulated second
  double position_error = 0.0;  ///< largest distance of a centre from its place at the end [m]
  double bed_error = 0.0;       ///< mean of |force / weight - 1| over kMeasured
  double wall_error = 0.0;      ///< mean of |force / push - 1| over kMeasured
};

Outcome run(const Pack& pack, Engine& engine, double dt);

}  // namespace pack
