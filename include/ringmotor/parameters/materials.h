// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/piezoelectric.h>

#include <optional>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /** A linear elastic material with hysteretic damping: isotropic, unless it has a #law. */
  struct Material
  {
    double young_modulus; ///< Pa, positive
    double poisson_ratio; ///< above -1 and below 0.5
    double density;       ///< kg/m^3, positive
    double loss_factor;   ///< energy lost per radian over the stored energy
    /** Of a piezoelectric solid, instead of modulus and Poisson ratio. */
    std::optional<PiezoelectricLaw> law{};

    /** Declares the entries, all of them required where the part is in the motor. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** The materials of the parts. */
  struct Materials
  {
    Material stator_metal{141.e9, 0.29, 8100., 1.e-3};
    Material piezoceramic{81.e9, 0.31, 7600., 2.e-3};
    Material rotor_metal{68.9e9, 0.33, 2700., 1.e-3};
    Material target_plate{193.e9, 0.29, 8000., 1.e-3};
    Material lining{3.e9, 0.35, 1500., 3.e-2};
    Material adhesive{3.e9, 0.35, 1200., 3.e-2};

    /** Declares one subsection for each material. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
