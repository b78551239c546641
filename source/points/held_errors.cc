// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/held_errors.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  HeldErrors::HeldErrors(const Parameters &parameters, const CurveRequests &requests,
                         const ErrorScene &scene)
      : parameters(parameters), requests(requests), scene(scene)
  {
  }

  double HeldErrors::relative(const PointError &error) const
  {
    const Accuracy &accuracy    = parameters.accuracy;
    const QuantityScales scales = requests.scales(scene.motor());
    double worst                = 0.;
    for (const QuantityTarget &held : accuracy.quantities)
      if (const double value = error[held.quantity]; value > 0.)
      {
        const PointQuantity &quantity = quantity_named(held.quantity);
        double largest                = 0.;
        for (const PointRequest &request : requests.measured().all())
          largest =
              std::max(largest, std::abs(quantity.value(scene.table.at(scene.plain(), request))));
        worst = std::max(worst, value / scales.of(held.quantity, largest) *
                                    accuracy.contact_target / accuracy.target_of(held));
      }
    return worst;
  }

  double HeldErrors::worst_of(const std::vector<CurvePoint> &points) const
  {
    double worst = 0.;
    for (const CurvePoint &point : points)
      worst = std::max(worst, relative(point.error()));
    return worst;
  }

  void HeldErrors::refuse(const double error, const std::string &where) const
  {
    throw ComputationError(
        "the relative error of " + parameters.accuracy.names_of_quantities() + " is still " +
        short_text(error) + " " + where +
        ", but Accuracy/Contact target = " + short_text(parameters.accuracy.contact_target) +
        "; choose a larger one" + (is_marched(parameters) ? ", or a smaller Time/Time step" : "") +
        (parameters.loading.control == Control::speed
             ? "; where the torque changes much with the speed, as near no load, prescribe torques"
             : ""));
  }

  void HeldErrors::require_bearable(const ErrorCause &cause,
                                    const std::vector<CurvePoint> &points) const
  {
    const std::string remedy = cause.remedy(parameters);
    if (remedy.empty())
      return;
    double worst = 0.;
    for (const CurvePoint &point : points)
      worst = std::max(worst, relative(point.errors.at(cause.name)));
    if (worst > parameters.accuracy.contact_target)
      throw ComputationError(
          "the errors of the " + cause.name + " alone change the results by " + short_text(worst) +
          ", Accuracy/Contact target = " + short_text(parameters.accuracy.contact_target) + remedy);
  }
} // namespace ringmotor
