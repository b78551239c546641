// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/pictures/sector_field.h>
#include <ringmotor/points/curve_point.h>
#include <ringmotor/results/quantity.h>

#include <optional>

namespace ringmotor
{
  /** Strain energies (J) of the whole ring in the stator's travelling wave, constant in time. */
  struct WaveEnergies
  {
    double angular_frequency = 0.; ///< rad/s
    double amplitude         = 0.; ///< m, see StatorWave::amplitude
    Estimate metal, piezoceramic;
    Estimate felt; ///< of the felt under the ring, which follows the stator's lower side
  };

  /**
   * Strain energy (J) of a felt ring that carries the stator on a foundation of the stiffness felt
   * modulus / felt thickness per area and follows its lower side: the mean over a period of one
   * half of stiffness times normal displacement squared. Only the area where the felt lies under
   * the stator counts.
   * @param on_felt of the stator, see radii_on_felt()
   */
  double felt_energy(const Support &felt, const std::vector<RadialRange> &on_felt,
                     const unsigned int n_teeth, const WaveMotion &lower_side);

  /**
   * The power balance of an operating point, in W. Hysteretic damping: a part with the strain
   * energy E in a travelling wave of angular frequency omega loses 2 eta omega E, with the loss
   * factor eta. The stator's share is that of its wave and of the modes that the contact excites;
   * without Effect "Stator compliance" its deformation by contact forces is neglected, as in the
   * paper.
   */
  struct LossBudget
  {
    Estimate amplitude;                  ///< m, of the wave
    Estimate output;                     ///< torque times speed
    Estimate friction;                   ///< eq. (7) of the paper
    Estimate stator_metal, piezoceramic; ///< inside the stator, in its wave
    Estimate stator_vibration;           ///< inside the stator, in all its other modes
    Estimate rotor;                      ///< inside the rotor
    Estimate support;                    ///< inside the felt
    /** Parts of #rotor, those that there are if it has several. */
    std::optional<Estimate> rotor_metal{}, lining{}, adhesive{};

    Estimate stator() const;  ///< all inside it
    Estimate of_wave() const; ///< in the stator's wave and in the felt
    Estimate total() const;   ///< all but the output
    Estimate input() const;   ///< output and losses
    /** Output over output and total loss; 0 for a motor that is driven from outside. */
    Estimate efficiency() const;

    /** The losses, for all outputs. */
    std::vector<Quantity> losses() const;
    /** Input and output power and the efficiency, for all outputs. */
    std::vector<Quantity> powers() const;
  };

  /** Power loss per volume (W/m^3, the mean over a period) of the stator in its wave: by cell, then
   * by lattice point of the cell. */
  std::vector<std::vector<double>> loss_density(const SectorField &wave,
                                                const Materials &materials);

  LossBudget loss_budget(const CurvePoint &point, const WaveEnergies &wave,
                         const Materials &materials, const RotorLossFactor &of_rotor,
                         const Support &felt);
} // namespace ringmotor
