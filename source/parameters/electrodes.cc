// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/electrodes.h>

namespace ringmotor
{
  using namespace dealii;

  void Electrodes::declare(ParameterHandler &prm)
  {
    const auto number = number_or("usual", whole_number(1, 10000));
    add_entry(prm, "Arcs of phase A", n_arcs_a, number,
              "Number of electrode arcs of phase A under the ceramic, each half a wave long, poled "
              "up and down in turn; \"usual\" is one less than Motor/Number of waves.");
    add_entry(prm, "Arcs of phase B", n_arcs_b, number, "The same for phase B.");
    add_entry(prm, "Distance of phases", phase_distance,
              number_within(0., 10000., "a number from 0 to 10000"),
              "Distance between the last arc of phase A and the first one of phase B in "
              "wavelengths: a quarter, or a quarter and a whole number of halves, lets the phases "
              "drive standing waves a quarter of a wavelength apart. Units: none.");
    add_entry(prm, "Gap between arcs", arc_gap, plausible(non_negative_number(), 1e-6, 1e-2),
              "Width without metal between two arcs, at the mean radius of the base. Units: m.");
  }
} // namespace ringmotor
