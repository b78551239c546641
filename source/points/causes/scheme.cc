// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace ringmotor
{
  namespace
  {
    const Variation other_scheme{"other scheme", nullptr, [](MotorInUse &motor, const double) {
                                   motor.dynamics.scheme =
                                       motor.dynamics.scheme.dissipating_otherwise();
                                 }};

    /** The share of the dissipation of a scheme in its change to dissipating_otherwise(). */
    double share_of_change(const InertiaScheme &scheme)
    {
      constexpr double margin = 2., phase = 0.1; // rad in a step
      const auto dissipation = [&](const InertiaScheme &of)
      { return (1. / of.response(std::polar(1., phase), phase, 1., 0.)).imag(); };
      const double own = dissipation(scheme), other = dissipation(scheme.dissipating_otherwise());
      return std::min(1., margin * own / std::abs(other - own));
    }

    /** Dissipation of the time integration of inertia. */
    class ErrorOfScheme : public ErrorCause
    {
    public:
      ErrorOfScheme() : ErrorCause("dissipation of the scheme", Cure::steps) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        if (!scene.has_inertia)
          return {};
        return {scene.for_variations().with(other_scheme)};
      }

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        if (!scene.has_inertia)
          return {};
        // The dissipation decreases with the third power of the step; quadratically, to be safe.
        return share_of_change(scene.motor().dynamics.scheme) *
               std::pow(scene.steps.plain().number() / own.steps.number(), 2) *
               scene.change_by(other_scheme, request);
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_scheme()
  {
    return std::make_unique<const ErrorOfScheme>();
  }
} // namespace ringmotor
