// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace brash::plate {

// Production sizes over l_c, chosen by the convergence study of docs/theory/fracture-of-the-edge.md.
inline constexpr double kTipSize = 0.035;       ///< along the tip edge, or kTipShare of it where that is less
inline constexpr double kTipShare = 0.105;      ///< of the contact length
inline constexpr double kTipCornerShare = 0.1;  ///< of the size along the tip edge, where the load ends
inline constexpr double kRootSize = 0.02;       ///< at the root, or kRootShare of its distance from the centre line
inline constexpr double kRootShare = 0.07;
inline constexpr double kCentreSize = 0.055;  ///< along the centre line where the plate breaks
inline constexpr double kSideSize = 0.08;     ///< along the sides, where shear makes a boundary layer
inline constexpr double kGradation = 0.3;     ///< growth of the size with distance
inline constexpr double kBreakingZone = 1.5;  ///< length of the fine centre line beyond the base line
inline constexpr double kHalfWidth =
    2000.0;  ///< of the sheet: bending needs 8; clamping the membrane at R adds 0.4 p c / R

// The same for a sheet that moves water, by the convergence study of docs/theory/fracture-of-the-edge.md.
inline constexpr double kMovingCentreSize = 0.08;
inline constexpr double kMovingTipSize = 0.05;
inline constexpr double kMovingTipReach = 0.5;     ///< of the fine part of a long tip edge from B
inline constexpr double kMovingCornerShare = 0.3;  ///< of the size along the tip edge
inline constexpr double kMovingEdgeSize = 0.05;    ///< along the free edge at B: the potential falls as a square root
inline constexpr double kMovingEdgeGrowth = 0.1;   ///< with the distance from B
inline constexpr double kMovingReach = 8.0;        ///< of the sheet
inline constexpr int kVibrationVectors = 140;

inline double moving_tip_size(double contact_length) { return std::min(kMovingTipSize, kTipShare * contact_length); }

/// Size along a tip edge of that length.
inline double tip_size(double contact_length) { return std::min(kTipSize, kTipShare * contact_length); }

}  // namespace brash::plate
