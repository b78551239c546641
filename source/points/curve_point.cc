// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/curve_point.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace ringmotor
{
  std::string PointRequest::text() const
  {
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<double>::max_digits10)
         << (control == Control::torque ? "torque " : "speed ") << value;
    return text.str();
  }

  std::vector<PointRequest> listed_points(const Loading &loading)
  {
    std::vector<PointRequest> requests;
    for (const double value : loading.values)
      requests.push_back({loading.control, value});
    return requests;
  }

  RotorLoad load_of(const Loading &loading, const PointRequest &request)
  {
    RotorLoad load{loading.preload, {}, request.value};
    if (request.control == Control::torque)
      load.torque = request.value;
    return load;
  }

  PointError CurvePoint::error() const
  {
    PointError whole;
    for (const auto &[cause, error] : errors)
      whole.add_independent(error);
    return whole;
  }

  void CurvePoint::add_certificate(const ContactSolution &solution)
  {
    largest_violation = std::max(largest_violation, solution.certificate.worst());
    n_iterations += solution.n_iterations;
    if (!solution.how.empty())
      remark = "Newton's method did not converge directly: " + solution.how;
  }
} // namespace ringmotor
