#pragma once

#include <cstdint>
#include <span>

#include "limes/limit/tile_coefficients.h"

namespace limes {

/// A point in a tile; tile points to its 64 numbers (see TileCoefficients).
struct TilePoint {
  const double* tile;
  double u, v;
};

/// Where values go: three numbers a point. What is above the wanted order is not read.
struct TileValues {
  double* x;
  double* xu;
  double* xv;
  double* xuu;
  double* xuv;
  double* xvv;
};

/// Which instructions evaluate_tiles uses.
enum class TileVectors {
  two_doubles,  ///< on every machine
  best          ///< four where the machine has AVX2
};

/// Values and derivatives up to `order` of polynomials, by Horner's rule: the same operations in the
/// same order, and so the same bits, with every instruction set.
void evaluate_tiles(std::span<const TilePoint> points, int order, const TileValues& out,
                    TileVectors vectors = TileVectors::best);

}  // namespace limes
