// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/measured_points.h>

#include <algorithm>

namespace ringmotor
{
  MeasuredPoints::MeasuredPoints(const std::vector<PointRequest> &curve, const unsigned int spacing)
      : curve(curve)
  {
    for (auto begin = curve.begin(); begin != curve.end();)
    {
      const auto end         = std::find_if(begin, curve.end(),
                                            [&](const PointRequest &request)
                                            { return request.control != begin->control; });
      const std::size_t last = end - begin - 1, n_intervals = (last + spacing - 1) / spacing;
      chosen.insert(*begin);
      for (std::size_t interval = 1; interval <= n_intervals; ++interval)
        chosen.insert(begin[interval * last / n_intervals]);
      begin = end;
    }
    find_neighbours();
  }

  void MeasuredPoints::add(const PointRequest &request)
  {
    chosen.insert(request);
    find_neighbours();
  }

  void MeasuredPoints::find_neighbours()
  {
    measured.clear();
    std::vector<PointRequest> between;
    for (const PointRequest &request : curve)
      if (!contain(request))
        between.push_back(request);
      else
      {
        for (const PointRequest &one : between)
          neighbours[one] = {measured.back(), request};
        between.clear();
        measured.push_back(request);
        neighbours[request] = {request};
      }
  }
} // namespace ringmotor
