// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/losses_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ringmotor
{
  namespace
  {
    constexpr double milli = 1e-3, rpm = dealii::numbers::PI / 30., percent = 1e-2;

    /** The parts of the loss by their names in `summary.json`. */
    std::vector<std::pair<std::string, Estimate>> parts_of(const LossBudget &budget)
    {
      return {{"friction_loss", budget.friction},
              {"internal_loss_stator_metal", budget.stator_metal},
              {"internal_loss_piezoceramic", budget.piezoceramic},
              {"internal_loss_rotor", budget.rotor},
              {"support_loss", budget.support},
              {"total_loss", budget.total()}};
    }

    /** All quantities of a point by their names in `summary.json`. */
    std::vector<std::pair<std::string, Estimate>> quantities_of(const LossBudget &budget)
    {
      auto quantities = parts_of(budget);
      quantities.emplace_back("internal_loss_stator", budget.stator());
      quantities.emplace_back("output_power", budget.output);
      quantities.emplace_back("efficiency", budget.efficiency());
      return quantities;
    }

    std::string with_error(const Estimate &estimate, const double unit, const int digits)
    {
      return text(estimate.value / unit, digits) + " +- " + text(estimate.error / unit, digits);
    }
  } // namespace

  std::string describe(const PointLosses &losses)
  {
    const LossBudget &budget = losses.budget;
    return text(losses.point.result.torque / milli, 2) + " mN m, " +
           text(losses.point.result.speed / rpm, 2) + " rpm: output " +
           with_error(budget.output, milli, 1) + " mW, losses " +
           with_error(budget.total(), milli, 1) + " mW (friction " +
           text(budget.friction.value / milli, 1) + ", stator " +
           text(budget.stator().value / milli, 1) + ", rotor " +
           text(budget.rotor.value / milli, 1) + ", support " +
           text(budget.support.value / milli, 1) + "), efficiency " +
           with_error(budget.efficiency(), percent, 2) + " %";
  }

  void write_losses(const std::string &path, const std::vector<PointLosses> &points)
  {
    std::vector<std::string> columns{"torque_mNm", "speed_rpm"};
    for (const auto &part : parts_of({}))
      columns.insert(columns.end(), {part.first + "_mW", part.first + "_error_mW"});
    CsvTable table(columns);
    for (const PointLosses &losses : points)
    {
      std::vector<CsvTable::Entry> row{losses.point.result.torque / milli,
                                       losses.point.result.speed / rpm};
      for (const auto &part : parts_of(losses.budget))
        row.insert(row.end(), {part.second.value / milli, part.second.error / milli});
      table.add_row(row);
    }
    table.write(path);
  }

  void write_efficiency(const std::string &path, const std::vector<PointLosses> &points)
  {
    CsvTable table({"torque_mNm", "speed_rpm", "input_power_mW", "output_power_mW",
                    "output_power_error_mW", "efficiency", "efficiency_error"});
    for (const PointLosses &losses : points)
    {
      const LossBudget &budget  = losses.budget;
      const Estimate efficiency = budget.efficiency();
      table.add_row({losses.point.result.torque / milli, losses.point.result.speed / rpm,
                     (budget.output.value + budget.total().value) / milli,
                     budget.output.value / milli, budget.output.error / milli, efficiency.value,
                     efficiency.error});
    }
    table.write(path);
  }

  void add_losses(Summary &summary, const std::vector<PointLosses> &points, const double seconds)
  {
    double worst_imbalance = 0., outside = 0.;
    for (const PointLosses &losses : points)
    {
      std::map<std::string, std::map<std::string, double>> causes; // by quantity
      for (const auto &[cause, budget] : losses.by_cause)
        for (const auto &[name, estimate] : quantities_of(budget))
          causes[name][cause] = estimate.error;
      for (const auto &[name, estimate] : quantities_of(losses.budget))
        summary.quantities.push_back({name,
                                      estimate.value,
                                      name == "efficiency" ? "1" : "W",
                                      estimate.error,
                                      causes[name],
                                      seconds,
                                      {{"torque_Nm", losses.point.result.torque},
                                       {"speed_rad_per_s", losses.point.result.speed}}});
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
  }
} // namespace ringmotor
