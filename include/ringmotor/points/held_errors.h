// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_requests.h>
#include <ringmotor/points/error_cause.h>

#include <string>
#include <vector>

namespace ringmotor
{
  /** Errors of the quantities that `Accuracy/Quantities` lists against their targets. */
  class HeldErrors
  {
  public:
    /** All must outlive this object. */
    HeldErrors(const Parameters &parameters, const CurveRequests &requests,
               const ErrorScene &scene);

    /** The largest relative one; those of quantities with a target of their own are weighted so
     * that `Contact target` is the limit of all. */
    double relative(const PointError &error) const;
    /** The largest one of some points. */
    double worst_of(const std::vector<CurvePoint> &points) const;

    /** Reports that only @p error, not the target, can be reached. @throws ComputationError */
    [[noreturn]] void refuse(const double error, const std::string &where) const;
    /** @throws ComputationError if a cause that only the user can do something about exceeds the
     * target alone, see ErrorCause::remedy() */
    void require_bearable(const ErrorCause &cause, const std::vector<CurvePoint> &points) const;

  private:
    const Parameters &parameters;
    const CurveRequests &requests;
    const ErrorScene &scene;
  };
} // namespace ringmotor
