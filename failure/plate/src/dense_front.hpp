// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::plate {

/// Eliminates the first unknowns of a dense symmetric system, by Cholesky's factorisation.
///
/// The matrices hold the lower triangle of the system, column after column. Their last row is the right-hand side, so
/// that the elimination also substitutes forward. What lies above the diagonal is not read and has no meaning.
///
/// @param own   shape=(k + r + 1, k). In: the columns of the k unknowns. Out: the columns of the factor.
/// @param left  shape=(r + 1, r). In: the columns of the other unknowns. Out: the same, reduced.
/// @return whether the pivots are positive.
[[nodiscard]] bool eliminate(double* own, int k, double* left, int r);

/// Finds the k unknowns from the r others, with the columns of the factor.
///
/// @param unknowns  shape=(k + r,). In: the last r. Out: all.
void substitute(const double* own, int k, int r, double* unknowns);

}  // namespace brash::plate
