// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/curve_search.h>
#include <ringmotor/points/mesh_transfer.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  std::vector<CurvePoint> CurveSearch::starts_for(const CurveSetting &setting,
                                                  const std::vector<unsigned int> &wanted,
                                                  const bool from_rest)
  {
    std::vector<CurvePoint> starts;
    if (is_marched(parameters))
      return starts;
    if (has_all(with_coarser_modes, setting, wanted))
    {
      for (const unsigned int request : wanted)
        starts.push_back(with_coarser_modes.at(setting).at(request));
      return starts;
    }
    if (!(setting == steps.longest(setting.level)))
    {
      std::vector<unsigned int> without;
      for (const unsigned int request : wanted)
        if (!point_with_longer_steps(setting, request))
          without.push_back(request);
      find_points_of(longer_steps(setting), without, from_rest);
      for (const unsigned int request : wanted)
        starts.push_back(*point_with_longer_steps(setting, request));
      return starts;
    }
    for (const auto &[level, motor] : motors)
    {
      if (level == setting.level || !has_all(known, steps.longest(level), wanted))
        continue;
      const MeshTransfer transfer(*motor, motor_of(setting.level));
      for (const unsigned int request : wanted)
      {
        starts.push_back(known.at(steps.longest(level)).at(request));
        starts.back().fields = transfer.fields(starts.back().fields);
      }
      return starts;
    }
    if (from_rest)
      starts.resize(wanted.size());
    else if (!outline.empty())
      for (const unsigned int request : wanted)
        starts.push_back(nearest_of_outline(requests[request]));
    return starts;
  }

  const CurvePoint &CurveSearch::nearest_of_outline(const PointRequest &request) const
  {
    const PointQuantity &load = prescribed(request);
    const auto distance       = [&](const CurvePoint &point)
    { return std::abs(load.value(point) - request.value); };
    return *std::min_element(outline.begin(), outline.end(),
                             [&](const CurvePoint &one, const CurvePoint &other)
                             { return distance(one) < distance(other); });
  }

  bool CurveSearch::has_all(const KnownPoints &points, const CurveSetting &setting,
                            const std::vector<unsigned int> &wanted)
  {
    const auto of_setting = points.find(setting);
    return of_setting != points.end() &&
           std::all_of(wanted.begin(), wanted.end(),
                       [&](const unsigned int i) { return of_setting->second.count(i) > 0; });
  }

  CurveSetting CurveSearch::longer_steps(const CurveSetting &setting) const
  {
    return setting.has_changed_motor() || setting.n_parts % 2 != 0 ? steps.plain(setting.level)
                                                                   : setting.doubled();
  }

  const CurvePoint *CurveSearch::point_with_longer_steps(const CurveSetting &setting,
                                                         const unsigned int request) const
  {
    if (!setting.has_changed_motor())
      for (unsigned int parts = setting.n_parts - 1; parts > 1; --parts)
        if (has_all(known, {setting.level, parts}, {request}))
          return &known.at({setting.level, parts}).at(request);
    const CurveSetting longer = longer_steps(setting);
    return has_all(known, longer, {request}) ? &known.at(longer).at(request) : nullptr;
  }
} // namespace ringmotor
