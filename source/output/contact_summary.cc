// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/contact_summary.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ringmotor
{
  namespace
  {
    constexpr double rpm = dealii::numbers::PI / 30., milli = 1e-3;

    /** Adds one quantity of a point, its errors being that component of PointError. */
    void add_quantity(Summary &summary, const CurvePoint &point, const std::string &name,
                      const double value, const std::string &unit,
                      double PointError::*const component)
    {
      const bool of_torque = point.request.control == Control::torque;
      std::map<std::string, double> causes;
      for (const auto &[cause, error] : point.errors.causes())
        causes[cause] = error.*component;
      summary.quantities.push_back(
          {name,
           value,
           unit,
           point.errors.total().*component,
           causes,
           point.seconds,
           {{of_torque ? "torque_Nm" : "speed_rad_per_s", point.request.value}}});
    }
  } // namespace

  std::string describe(const CurvePoint &point)
  {
    const bool of_torque    = point.request.control == Control::torque;
    const PointError error  = point.errors.total();
    const std::string speed = text(point.result.speed / rpm, 2),
                      torque =
                          text((of_torque ? point.request.value : point.result.torque) / milli, 2);
    return (of_torque
                ? torque + " mN m: " + speed + " +- " + text(error.speed / rpm, 2) + " rpm"
                : speed + " rpm: " + torque + " +- " + text(error.torque / milli, 2) + " mN m") +
           ", friction loss " + text(point.result.friction_loss() / milli, 1) + " +- " +
           text(error.loss / milli, 1) + " mW (" + text(point.result.tangential_loss / milli, 1) +
           " tangential, " + text(point.result.radial_loss / milli, 1) + " radial), " +
           text(point.result.teeth_in_contact, 2) + " teeth per wave";
  }

  void add_points(Summary &summary, const std::vector<CurvePoint> &points)
  {
    double violation = 0., imbalance = 0.;
    for (const CurvePoint &point : points)
    {
      const OperatingPoint &result = point.result;
      if (point.request.control == Control::torque)
        add_quantity(summary, point, point.request.value == 0. ? "no_load_speed" : "speed",
                     result.speed, "rad/s", &PointError::speed);
      else
        add_quantity(summary, point, point.request.value == 0. ? "stall_torque" : "torque",
                     result.torque, "N m", &PointError::torque);
      for (const auto &[name, loss] :
           {std::pair("friction_loss", result.friction_loss()),
            std::pair("friction_loss_tangential", result.tangential_loss),
            std::pair("friction_loss_radial", result.radial_loss)})
        add_quantity(summary, point, name, loss, "W", &PointError::loss);
      violation = std::max(violation, point.largest_violation);
      imbalance = std::max(imbalance, result.power_imbalance());
    }
    summary.certificate.push_back(
        {"largest violation of the laws of contact and friction and of the balances of forces",
         violation, ContactCertificate::limit});
    summary.certificate.push_back(
        {"power put in against power out, friction loss and change of stored energy, relative",
         imbalance, OperatingPoint::largest_imbalance,
         "choose a larger Time/Snapshots, which makes steps shorter"});
  }

  void write_contact_study(const std::string &path, const std::vector<CurveSearch::Rung> &rungs)
  {
    CsvTable table({"interface_mesh", "points_per_tooth", "dofs", "steps_per_period", "seconds",
                    "seconds_with_error_bar", "largest_relative_error", "distance_from_best"});
    for (const CurveSearch::Rung &rung : rungs)
      table.add_row({rung.setting.level, rung.n_nodes, rung.n_dofs, rung.n_steps, rung.seconds,
                     rung.seconds_with_error_bar, rung.largest_error, rung.distance});
    table.write(path);
  }
} // namespace ringmotor
