// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/error_cause.h>
#include <ringmotor/points/point_quantities.h>

#include <cmath>

namespace ringmotor
{
  const PartList<ErrorCause> &all_error_causes()
  {
    static const PartList<ErrorCause> list = made_by<ErrorCause>(
        {causes::of_meshes, causes::of_modes, causes::of_time_step, causes::of_scheme,
         causes::of_window, causes::of_wave, causes::of_effects, causes::of_algebra});
    return list;
  }

  PointError ErrorScene::change_by(const Variation &variation, const PointRequest &request) const
  {
    return change(table.at(for_variations(), request),
                  table.at(for_variations().with(variation), request));
  }

  PointError least_of_power(const CurvePoint &point, const PointError &error)
  {
    PointError least;
    least["friction_loss"] = std::abs(point.result.torque) * error["speed"] +
                             std::abs(point.result.speed) * error["torque"];
    return least;
  }

  PointError shares_of(const CurvePoint &point, const double crest_speed, const double of_speed,
                       const double of_loss)
  {
    PointError error;
    error["friction_loss"] = of_loss * point.result.friction_loss();
    if (point.request.control == Control::torque)
      error["speed"] = of_speed * crest_speed;
    return error;
  }
} // namespace ringmotor
