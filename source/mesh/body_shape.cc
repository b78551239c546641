// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/shapes.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/parameters.h>

#include <algorithm>

namespace ringmotor
{
  std::unique_ptr<const StatorShape> stator_shape(const Parameters &parameters)
  {
    return parameters.stator.mesh_file.empty() ? revolved_stator(parameters)
                                               : read_stator(parameters);
  }

  std::unique_ptr<const RotorShape> rotor_shape(const Parameters &parameters)
  {
    return parameters.rotor.mesh_file.empty() ? revolved_rotor(parameters) : read_rotor(parameters);
  }

  double rise_to_contact(const BodyShape &rotor, const BodyShape &stator)
  {
    return stator.contact_line().highest - rotor.contact_line().lowest;
  }

  void check_bodies(const Parameters &parameters)
  {
    if (!parameters.stator.has_dimensions())
    {
      const auto stator                           = stator_shape(parameters);
      const std::vector<dealii::Point<2>> outline = stator->meridian().outline;
      const auto [low, high]                      = std::minmax_element(
                               outline.begin(), outline.end(),
                               [](const dealii::Point<2> &a, const dealii::Point<2> &b) { return a[1] < b[1]; });
      check_amplitude(parameters.wave, "the height of " + stator->origin.entry, (*high - *low)[1]);
    }
    if (!parameters.rotor.has_dimensions())
      rotor_shape(parameters);
  }
} // namespace ringmotor
