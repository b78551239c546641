// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/curve_points.h>

#include <deal.II/base/point.h>

namespace ringmotor
{
  using namespace dealii;

  const std::vector<double> &shares_for_shape()
  {
    static const std::vector<double> shares{0., 0.3, 0.6, 0.8, 0.9, 0.97};
    return shares;
  }

  std::vector<PointRequest> points_along_curve(const std::vector<CurvePoint> &shape,
                                               const unsigned int n_points)
  {
    Assert(shape.size() > 1 && n_points > 1, ExcInternalError());
    // Motors operate where torque changes their speed little: a fall of the speed to zero counts
    // less than a rise of the torque to stall.
    constexpr double weight = 0.4;
    const double torque = shape.back().result.torque, speed = shape.front().result.speed / weight;
    Assert(torque != 0. && speed != 0., ExcMessage("a curve without extent has no shape"));
    std::vector<Point<2>> corners;
    for (const CurvePoint &point : shape)
      corners.emplace_back(point.result.torque / torque, point.result.speed / speed);
    double length = 0.;
    for (std::size_t i = 1; i < corners.size(); ++i)
      length += corners[i - 1].distance(corners[i]);

    std::vector<PointRequest> requests{{Control::torque, 0.}};
    double before         = 0.; // the length up to a corner
    std::size_t from      = 0;
    const auto of_segment = [&] { return corners[from].distance(corners[from + 1]); };
    for (unsigned int i = 1; i + 1 < n_points; ++i)
    {
      const double place = length * i / (n_points - 1);
      while (from + 2 < corners.size() && before + of_segment() < place)
        before += of_segment(), ++from;
      const Tensor<1, 2> along = corners[from + 1] - corners[from];
      const Point<2> here      = corners[from] + (place - before) / of_segment() * along;
      const bool is_steep      = std::abs(along[1]) > 1.001 * weight * std::abs(along[0]);
      if (!is_steep)
        requests.push_back({Control::torque, here[0] * torque});
      else
        requests.push_back({Control::speed, here[1] * speed});
    }
    requests.push_back({Control::speed, 0.});
    return requests;
  }
} // namespace ringmotor
