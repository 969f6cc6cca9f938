// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace brash::failure {

/// Stress intensities of an edge crack in a rectangular plate, by tests/failure/splitting/splitting_fem.py, to 1 %. A
/// row is of a breadth, a column of a crack length, both in lengths of the plate along the crack.
inline constexpr std::array<double, 11> kCrackLengths{0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
inline constexpr std::array<double, 5> kBreadths{0.25, 0.5, 1, 2, 4};

/// K h sqrt(W a) (1 - a)^1.5 / P of the pair of forces P at the mouth, (G7).
inline constexpr std::array<std::array<double, 11>, 5> kOpening{{
    {1.5713, 2.2473, 3.8589, 7.1073, 9.6304, 11.1105, 11.3818, 10.4653, 8.4253, 5.6552, 3.7900},
    {1.4404, 1.6056, 2.0768, 3.2376, 4.1479, 4.6207, 4.6320, 4.2542, 3.7243, 3.4371, 3.6090},
    {1.4071, 1.4195, 1.4915, 1.7742, 2.0843, 2.3364, 2.5355, 2.7316, 2.9761, 3.2825, 3.6182},
    {1.4008, 1.3914, 1.3992, 1.5275, 1.7442, 2.0111, 2.3084, 2.6242, 2.9522, 3.2860, 3.6190},
    {1.3989, 1.3906, 1.3983, 1.5259, 1.7421, 2.0090, 2.3072, 2.6238, 2.9521, 3.2855, 3.6181},
}};

/// The same of the push N against the inertia of the plate, which closes the crack: -K.
inline constexpr std::array<std::array<double, 11>, 5> kClosing{{
    {0.4146, 0.4799, 0.6377, 0.7813, 0.7829, 0.7164, 0.6081, 0.4777, 0.3357, 0.2000, 0.1231},
    {0.4158, 0.4067, 0.4435, 0.5350, 0.5511, 0.5079, 0.4331, 0.3467, 0.2715, 0.2325, 0.2339},
    {0.4265, 0.4011, 0.3794, 0.3828, 0.3964, 0.4003, 0.3986, 0.4018, 0.4167, 0.4418, 0.4694},
    {0.4514, 0.4546, 0.4628, 0.5032, 0.5609, 0.6266, 0.6948, 0.7621, 0.8264, 0.8859, 0.9393},
    {0.5078, 0.5884, 0.7028, 0.9043, 1.0825, 1.2447, 1.3939, 1.5308, 1.6572, 1.7730, 1.8782},
}};

}  // namespace brash::failure
