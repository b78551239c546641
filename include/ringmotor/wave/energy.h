// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <map>

namespace ringmotor
{
  /** Energies of the whole ring when it carries the travelling wave Re(U exp(i omega t)). */
  struct WaveEnergy
  {
    /** Strain energy in J by material id; constant in time for a travelling wave. */
    std::map<dealii::types::material_id, double> strain;
    double total_strain = 0.; ///< J
    double electric     = 0.; ///< J, of the fields inside a piezoelectric ceramic, in total_strain
    double kinetic      = 0.; ///< J; equals total_strain for a natural mode
  };

  /** Integrates the energies of @p mode as it is scaled. */
  WaveEnergy wave_energy(const CyclicSector &sector, const Mode &mode);

  /**
   * Mass in kg of the equivalent oscillator of one standing mode (cosine or sine) with unit
   * displacement where the travelling wave has the amplitude @p amplitude (m).
   */
  double modal_mass(const WaveEnergy &energy, const Mode &mode, const double amplitude);
} // namespace ringmotor
