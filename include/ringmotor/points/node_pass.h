// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>

#include <vector>

namespace ringmotor
{
  /**
   * What friction has done to contact nodes since they came into contact. In the motor of the paper
   * it first brakes the rotor at a node, which then sticks, is driven, sticks again, is braked and
   * breaks contact (Fig. 11): at best, a node sticks twice in a pass.
   */
  class NodePass
  {
  public:
    /** Nodes that have just come into contact. */
    explicit NodePass(const unsigned int n_nodes) : driven(n_nodes, false) {}

    /** At the begin of the steps of a steady state, whose earlier steps are those of other teeth.
     */
    explicit NodePass(const OperatingState &steady);

    /** Continues by a step. */
    void add(const ContactSolution &step);

    /** The part of the pressure force on nodes that stick in this step, although friction has
     * already driven the rotor there in the same pass: their second stick. 0 to 1. */
    double second_stick_fraction(const ContactSolution &step) const;

  private:
    std::vector<bool> driven; ///< by friction while the node slipped, since contact began
  };
} // namespace ringmotor
