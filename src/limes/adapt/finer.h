#pragma once

#include "limes/adapt/zienkiewicz_zhu.h"

namespace limes {

/// Squared difference of the fluxes of two solutions of bilinear elements over every face of the coarse
/// one, in the energy norm: integral of (q - q_h) . D^-1 (q - q_h), by the quadrature of the finer space.
/// Precondition: the spaces are those of the scheme `linear`, the finer one on the quads of the other after
/// `levels` quadrisections.
/// @return  by face of the coarse space; 0 for holes
[[nodiscard]] std::vector<double> error_against(const SubdivisionSpace& finer,
                                                const EnergyDensity& finer_energy, int levels,
                                                const SubdivisionSpace& space,
                                                const EnergyDensity& energy);

}  // namespace limes
