// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <functional>
#include <type_traits>

namespace ringmotor
{
  const std::vector<PointQuantity> &point_quantities()
  {
    using Point = OperatingPoint;
    static const std::vector<PointQuantity> quantities{
        {"speed", units::speed, &Point::speed, &PointError::speed},
        {"torque", units::torque, &Point::torque, &PointError::torque},
        {"friction_loss", units::power, &Point::friction_loss, &PointError::loss},
        {"output_power", units::power, &Point::output_power},
        {"teeth_in_contact_per_wave", units::one, &Point::teeth_in_contact,
         &PointError::teeth_in_contact},
        {"stick_fraction", units::one, &Point::stick_fraction, &PointError::stick_fraction},
        {"second_stick_fraction", units::one, &Point::second_stick_fraction,
         &PointError::second_stick_fraction},
        {"tangential_loss", units::power, &Point::tangential_loss, &PointError::loss},
        {"radial_loss", units::power, &Point::radial_loss, &PointError::loss},
        {"radial_loss_share", units::one, &Point::radial_loss_share,
         &PointError::radial_loss_share},
        {"input_power", units::power, &Point::input_power},
        {"exchanged_power", units::power, &Point::gross_power},
        {"power_imbalance", units::one, &Point::power_imbalance},
        {"output_work", units::power, &Point::output_work},
        {"stored_power", units::power, &Point::stored_power},
        {"modal_power", units::power, &Point::modal_power},
        {"closing_work", units::power, &Point::closing_work},
        {"detuning", units::one, &Point::detuning},
        {"amplitude", units::amplitude, &Point::amplitude, &PointError::amplitude},
        {"rotor_power_per_loss_factor", units::power, &CurvePoint::rotor_power,
         &PointError::rotor_power}};
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
      std::vector<double OperatingPoint::*> members{&OperatingPoint::modal_damping};
      for (const PointQuantity &quantity : point_quantities())
        if (const auto *member = std::get_if<double OperatingPoint::*>(&quantity.source))
          members.push_back(*member);
      return members;
    }();
    return members;
  }

  std::vector<Quantity> quantities_of(const CurvePoint &point)
  {
    const PointError total = point.errors.total();
    const auto causes      = point.errors.causes();
    std::vector<Quantity> quantities;
    for (const PointQuantity &quantity : point_quantities())
    {
      quantities.push_back({quantity.name, quantity.unit, quantity.value(point)});
      if (quantity.error == nullptr)
        continue;
      quantities.back().error = total.*quantity.error;
      for (const auto &[cause, error] : causes)
        quantities.back().error_causes[cause] = error.*quantity.error;
    }
    return quantities;
  }

  const PointQuantity &quantity_with(double PointError::*const error)
  {
    return *std::find_if(point_quantities().begin(), point_quantities().end(),
                         [&](const PointQuantity &quantity) { return quantity.error == error; });
  }

  const PointQuantity &prescribed(const PointRequest &request)
  {
    return quantity_with(request.control == Control::torque ? &PointError::torque
                                                            : &PointError::speed);
  }
} // namespace ringmotor
