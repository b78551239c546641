// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/contact_summary.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  namespace
  {
    /** Names in `summary.json` that differ from those of the list. */
    std::string name_in_summary(const std::string &name, const PointRequest &request)
    {
      static const std::map<std::string, std::string> others{
          {"tangential_loss", "friction_loss_tangential"}, {"radial_loss", "friction_loss_radial"}};
      if (request.value == 0. && name == "speed")
        return "no_load_speed";
      if (request.value == 0. && name == "torque")
        return "stall_torque";
      const auto other = others.find(name);
      return other != others.end() ? other->second : name;
    }
  } // namespace

  std::string describe(const CurvePoint &point)
  {
    const OperatingPoint &result = point.result;
    const auto with_error        = [&](const std::string &name, const int digits)
    {
      const PointQuantity &quantity = quantity_named(name);
      return text(quantity.estimate(point), quantity.unit, digits);
    };
    return text(point.request.value, prescribed(point.request).unit, 2) + ": " +
           with_error(point.request.control == Control::torque ? "speed" : "torque", 2) +
           ", friction loss " + with_error("friction_loss", 1) + " (" +
           text(result.tangential_loss / units::power.size, 1) + " tangential, " +
           text(result.radial_loss / units::power.size, 1) + " radial), " +
           text(result.teeth_in_contact, 2) + " teeth per wave";
  }

  namespace
  {
    /** An amplitude that is prescribed, or vibrations that the model leaves out. */
    bool is_given_by_the_model(const Quantity &quantity)
    {
      return (quantity.name == "amplitude" && quantity.estimate.error() == 0.) ||
             (quantity.name == "stator_vibration_loss" && quantity.estimate.value == 0.);
    }
  } // namespace

  void add_points(Summary &summary, const std::vector<CurvePoint> &points)
  {
    double violation = 0., imbalance = 0.;
    for (const CurvePoint &point : points)
    {
      const PointQuantity &given = prescribed(point.request);
      std::vector<Quantity> found;
      for (Quantity &quantity : quantities_of(point))
        if (quantity.name != given.name && !is_given_by_the_model(quantity))
        {
          quantity.name = name_in_summary(quantity.name, point.request);
          found.push_back(quantity);
        }
      add_quantities(summary, found, point.seconds,
                     {{name_with_unit(given.name, given.unit.si), point.request.value}});
      violation = std::max(violation, point.largest_violation);
      imbalance = std::max(imbalance, point.result.power_imbalance());
    }
    summary.certificate.push_back(
        {"largest violation of the laws of contact and friction and of the balances of forces",
         violation, ContactCertificate::limit});
    summary.certificate.push_back(
        {"power put in against power out, friction loss and change of stored energy, relative",
         imbalance, OperatingPoint::largest_imbalance,
         "choose a larger Time/Snapshots, which makes steps shorter"});
  }
} // namespace ringmotor
