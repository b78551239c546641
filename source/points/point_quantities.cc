// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>

namespace ringmotor
{
  const std::vector<PointQuantity> &point_quantities()
  {
    using Point = OperatingPoint;
    static const std::vector<PointQuantity> quantities{
        {"speed", units::speed, &Point::speed, "speed"},
        {"torque", units::torque, &Point::torque, "torque"},
        {"friction_loss", units::power, &Point::friction_loss, "friction_loss"},
        {"output_power", units::power, &Point::output_power},
        {"teeth_in_contact_per_wave", units::one, &Point::teeth_in_contact,
         "teeth_in_contact_per_wave"},
        {"stick_fraction", units::one, &Point::stick_fraction, "stick_fraction"},
        {"second_stick_fraction", units::one, &Point::second_stick_fraction,
         "second_stick_fraction"},
        {"tangential_loss", units::power, &Point::tangential_loss, "friction_loss"},
        {"radial_loss", units::power, &Point::radial_loss, "friction_loss"},
        {"radial_loss_share", units::one, &Point::radial_loss_share, "radial_loss_share"},
        {"input_power", units::power, &Point::input_power},
        {"exchanged_power", units::power, &Point::gross_power},
        {"power_imbalance", units::one, &Point::power_imbalance},
        {"output_work", units::power, &Point::output_work},
        {"stored_power", units::power, &Point::stored_power},
        {"modal_power", units::power, &Point::modal_power},
        {"stator_vibration_loss", units::power, &Point::stator_damping, "stator_vibration_loss"},
        {"closing_work", units::power, &Point::closing_work},
        {"detuning", units::one, &Point::detuning},
        {"amplitude", units::amplitude, &Point::amplitude, "amplitude"},
        {"rotor_power_per_loss_factor", units::power, &CurvePoint::rotor_power,
         "rotor_power_per_loss_factor"}};
    return quantities;
  }

  double PointQuantity::value(const CurvePoint &point) const
  {
    return std::visit(
        [&](const auto member) -> double
        {
          if constexpr (std::is_invocable_v<decltype(member), const OperatingPoint &>)
            return std::invoke(member, point.result);
          else
            return point.*member;
        },
        source);
  }

  double *PointQuantity::place(CurvePoint &point) const
  {
    if (const auto *member = std::get_if<double OperatingPoint::*>(&source))
      return &(point.result.**member);
    if (const auto *member = std::get_if<double CurvePoint::*>(&source))
      return &(point.**member);
    return nullptr;
  }

  const std::vector<double OperatingPoint::*> &OperatingPoint::members()
  {
    static const std::vector<double OperatingPoint::*> members = []
    {
      // In addition to the list, one that only serves to compute another.
      std::vector<double OperatingPoint::*> all{&OperatingPoint::modal_damping};
      for (const PointQuantity &quantity : point_quantities())
        if (const auto *member = std::get_if<double OperatingPoint::*>(&quantity.source))
          all.push_back(*member);
      return all;
    }();
    return members;
  }

  Estimate PointQuantity::estimate(const CurvePoint &point) const
  {
    Estimate estimate(value(point));
    for (const auto &[cause, error] : point.errors)
      estimate.errors[cause] = error[error_of];
    return estimate;
  }

  const PointQuantity &quantity_named(const std::string &name)
  {
    const auto found =
        std::find_if(point_quantities().begin(), point_quantities().end(),
                     [&](const PointQuantity &quantity) { return quantity.name == name; });
    Assert(found != point_quantities().end(), dealii::ExcMessage(name + " is no quantity"));
    return *found;
  }

  std::vector<Quantity> quantities_of(const CurvePoint &point)
  {
    std::vector<Quantity> quantities;
    for (const PointQuantity &quantity : point_quantities())
      if (quantity.error_of.empty())
        quantities.emplace_back(quantity.name, quantity.unit, quantity.value(point));
      else
        quantities.emplace_back(quantity.name, quantity.unit, quantity.estimate(point));
    return quantities;
  }

  const PointQuantity &prescribed(const PointRequest &request)
  {
    return quantity_named(request.control == Control::torque ? "torque" : "speed");
  }

  PointError values_of(const CurvePoint &point)
  {
    PointError values;
    for (const PointQuantity &quantity : point_quantities())
      if (quantity.has_own_error())
        values[quantity.name] = quantity.value(point);
    values[prescribed(point.request).name] = 0.;
    return values;
  }

  PointError change(const CurvePoint &from, const CurvePoint &to)
  {
    PointError change;
    for (const PointQuantity &quantity : point_quantities())
      if (quantity.has_own_error())
        change[quantity.name] = std::abs(quantity.value(from) - quantity.value(to));
    change[prescribed(to.request).name] = 0.;
    return change;
  }

  PointError sizes_of(const CurvePoint &point)
  {
    return change(CurvePoint(), point);
  }
} // namespace ringmotor
