// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/measured_points.h>

#include <algorithm>

namespace ringmotor
{
  MeasuredPoints::MeasuredPoints(const std::vector<PointRequest> &curve, const unsigned int spacing)
  {
    for (auto begin = curve.begin(); begin != curve.end();)
    {
      const auto end         = std::find_if(begin, curve.end(),
                                            [&](const PointRequest &request)
                                            { return request.control != begin->control; });
      const std::size_t last = end - begin - 1, n_intervals = (last + spacing - 1) / spacing;
      const auto measured_one = [&](const std::size_t interval)
      { return n_intervals == 0 ? 0 : interval * last / n_intervals; };
      for (std::size_t interval = 0; interval <= n_intervals; ++interval)
      {
        const PointRequest &here = begin[measured_one(interval)];
        measured.push_back(here);
        neighbours[here] = {here};
        if (interval < n_intervals)
          for (std::size_t i = measured_one(interval) + 1; i < measured_one(interval + 1); ++i)
            neighbours[begin[i]] = {here, begin[measured_one(interval + 1)]};
      }
      begin = end;
    }
  }
} // namespace ringmotor
