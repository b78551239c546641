// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/steady.h>

namespace ringmotor
{
  /** What a motor does at an operating point, of the whole ring and averaged over time. */
  struct OperatingPoint
  {
    double speed  = 0.; ///< rad/s, in the driven direction
    double torque = 0.; ///< N m, of friction on the rotor
    /** W, of friction, by sliding along the ring and across it. Forces are the means of both ends
     * of a step: then the power balance closes. */
    double tangential_loss = 0., radial_loss = 0.;
    double input_power      = 0.; ///< W, of the stator's forced motion on the contact forces
    double closing_work     = 0.; ///< W, that numbers lose where gaps close and open in a step
    double teeth_in_contact = 0.; ///< per wave
    double stick_fraction   = 0.; ///< of the pressure force, on points that stick

    double friction_loss() const { return tangential_loss + radial_loss; }
    double output_power() const { return torque * speed; }
    /** Input power less output power and friction loss, over the larger of input power and loss. */
    double power_imbalance() const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &speed &torque &tangential_loss &radial_loss &input_power &closing_work;
      archive &teeth_in_contact &stick_fraction;
    }
  };

  /** Evaluates a steady state. */
  OperatingPoint evaluate(const OperatingState &state);

  /** Evaluates one step from the state @p before. */
  OperatingPoint evaluate_step(const OperatingState &before, const OperatingState &state);

  /** The mean of several steps of equal length. */
  OperatingPoint mean(const std::vector<OperatingPoint> &points);
} // namespace ringmotor
