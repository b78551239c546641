// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/losses_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>
#include <ringmotor/points/wave_balance.h>

#include <algorithm>

namespace ringmotor
{
  namespace
  {
    using List = std::vector<Quantity> (LossBudget::*)() const;

    /** What distinguishes operating points. */
    std::vector<Quantity> load_of(const PointLosses &losses)
    {
      return {{"torque", units::torque, losses.point.result.torque},
              {"speed", units::speed, losses.point.result.speed}};
    }

    void write_points(const std::string &path, const std::vector<PointLosses> &points,
                      const List list)
    {
      std::vector<NamedRow> rows;
      for (const PointLosses &losses : points)
      {
        rows.emplace_back();
        add_entries(rows.back(), load_of(losses));
        add_entries(rows.back(), (losses.budget.*list)());
      }
      write_table(path, rows);
    }
  } // namespace

  namespace
  {
    /** `12.31 +- 0.22 V and ...` */
    std::string describe(const DrivePoint &drive)
    {
      const std::string driven = drive.voltage.error() > 0.
                                     ? text(drive.voltage, units::voltage, 2)
                                     : text(drive.amplitude, units::amplitude, 3) + " by " +
                                           text(drive.voltage.value, 2) + " V";
      return driven + " per phase at " + text(1e-3 * drive.frequency.value, 3) +
             " kHz, electrical efficiency " + text(drive.electrical_efficiency, units::percent, 2);
    }
  } // namespace

  std::string describe(const PointLosses &losses)
  {
    const LossBudget &budget = losses.budget;
    const auto part = [](const Estimate &loss) { return text(loss.value / units::power.size, 1); };
    return text(losses.point.result.torque, units::torque, 2) + ", " +
           text(losses.point.result.speed, units::speed, 2) + ": output " +
           text(budget.output, units::power, 1) + ", losses " +
           text(budget.total(), units::power, 1) + " (friction " + part(budget.friction) +
           ", stator " + part(budget.stator()) + ", rotor " + part(budget.rotor) + ", support " +
           part(budget.support) + "), efficiency " + text(budget.efficiency(), units::percent, 2) +
           (losses.drive ? "; " + describe(*losses.drive) : "");
  }

  void write_losses(const std::string &path, const std::vector<PointLosses> &points)
  {
    write_points(path, points, &LossBudget::losses);
  }

  void write_efficiency(const std::string &path, const std::vector<PointLosses> &points)
  {
    write_points(path, points, &LossBudget::powers);
  }

  void write_drive(const std::string &path, const std::vector<PointLosses> &points)
  {
    std::vector<NamedRow> rows;
    for (const PointLosses &losses : points)
    {
      rows.emplace_back();
      add_entries(rows.back(), load_of(losses));
      add_entries(rows.back(), losses.drive->quantities());
    }
    write_table(path, rows);
  }

  void add_losses(Summary &summary, const std::vector<PointLosses> &points, const double seconds)
  {
    double worst_imbalance = 0., worst_electrical = 0., outside = 0., mismatch = 0.;
    for (const PointLosses &losses : points)
    {
      Summary::Labels labels;
      for (const Quantity &load : load_of(losses))
        labels[name_with_unit(load.name, load.unit.si)] = load.value();
      for (const List list : {&LossBudget::losses, &LossBudget::powers})
        add_quantities(summary, (losses.budget.*list)(), seconds, labels);
      if (losses.drive)
      {
        add_quantities(summary, losses.drive->quantities(), seconds, labels);
        worst_electrical       = std::max(worst_electrical, losses.drive->imbalance);
        mismatch               = std::max(mismatch, losses.drive->voltage_mismatch);
        const double from_plug = losses.drive->electrical_efficiency.value;
        outside                = std::max({outside, -from_plug, from_plug - 1.});
      }
      const Estimate efficiency = losses.budget.efficiency();
      worst_imbalance           = std::max(worst_imbalance, losses.point.result.power_imbalance());
      outside                   = std::max({outside, -efficiency.value, efficiency.value - 1.});
    }
    summary.certificate.push_back(
        {"power put into the contact against output, friction loss and change of stored energy, "
         "relative",
         worst_imbalance, OperatingPoint::largest_imbalance,
         "run the program contact with a larger Time/Snapshots or a smaller Accuracy/Contact "
         "target"});
    summary.certificate.push_back({"efficiency outside 0 to 1", outside, 0.});
    if (points.front().drive)
    {
      summary.certificate.push_back({"electrical input against output and all losses, relative",
                                     worst_electrical, OperatingPoint::largest_imbalance});
      summary.certificate.push_back(
          {"voltage that the amplitude found needs against the given one, relative", mismatch,
           largest_excess_of_drive});
    }
  }
} // namespace ringmotor
