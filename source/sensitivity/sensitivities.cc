// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/sensitivity/sensitivities.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** Derivatives this small are rounding errors. */
    constexpr double negligible = 1e-7;

    /** The results of one entry, as ranks send them to each other. */
    struct Found
    {
      double step = 0.;
      std::vector<LogDerivative> of;
      std::string obstacle;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &step &of &obstacle;
      }
    };

    /** Where the other two motors are. */
    struct Places
    {
      Side side;
      double step; ///< relative to the largest one
    };

    /** Smaller changes for motors that can barely be made or whose meshes have almost other cells,
     * changes to one side for those where that is the case on the other side. */
    constexpr Places trials[] = {{Side::both, 1.},   {Side::both, 0.25},   {Side::above, 0.5},
                                 {Side::below, 0.5}, {Side::above, 0.125}, {Side::below, 0.125}};

    std::vector<LogDerivative> derivatives(const NearbyMotors &motors, const MotorEntry &entry,
                                           const Side side, const double step)
    {
      const int itself = side == Side::above ? 0 : side == Side::both ? 1 : 2;
      std::vector<std::vector<double>> values;
      for (int i = 0; i < 3; ++i)
        values.push_back(i == itself ? motors.values()
                                     : motors.values_of(with_entry(
                                           motors.parameters(), entry,
                                           entry.value * std::exp((i - itself) * step))));
      std::vector<LogDerivative> derivatives;
      for (std::size_t q = 0; q < motors.values().size(); ++q)
        if (values[0][q] > 0. && values[1][q] > 0. && values[2][q] > 0.)
          derivatives.push_back(log_derivative(
              {std::log(values[0][q]), std::log(values[1][q]), std::log(values[2][q])}, side,
              step));
        else
          derivatives.push_back({0., 0., false});
      return derivatives;
    }

    Found find(const NearbyMotors &motors, const MotorEntry &entry, const double largest_step)
    {
      Found found;
      for (const Places &trial : trials)
        try
        {
          found.step = trial.step * largest_step * entry.scale;
          found.of   = derivatives(motors, entry, trial.side, found.step / std::abs(entry.value));
          found.obstacle.clear();
          return found;
        }
        catch (const UserError &error)
        {
          found.obstacle = error.what();
        }
        catch (const ComputationError &error)
        {
          found.obstacle = error.what();
        }
      return found;
    }
  } // namespace

  double Sensitivity::per_scale() const
  {
    return entry.scale / std::abs(entry.value);
  }

  double Sensitivity::largest() const
  {
    double largest = 0.;
    for (const LogDerivative &derivative : of)
      largest = std::max(largest, std::abs(derivative.value));
    return per_scale() * largest;
  }

  LogDerivative log_derivative(const std::vector<double> &values, const Side side,
                               const double step)
  {
    const double mean      = (values[2] - values[0]) / (2. * step),
                 curvature = (values[2] - 2. * values[1] + values[0]) / (2. * step);
    // That of the parabola through all three, in the middle or at an end.
    const double to_end = side == Side::above ? -2. : side == Side::below ? 2. : 0.;
    return {mean + to_end * curvature, std::abs(curvature)};
  }

  std::vector<Sensitivity> sensitivities(const NearbyMotors &motors, const double step,
                                         MPI_Comm ranks,
                                         const std::function<void(double)> &after_entry)
  {
    const std::vector<MotorEntry> entries = motor_entries(motors.parameters());
    const std::vector<Found> found        = shared_work(
               entries,
               [&](const MotorEntry &entry)
               {
          Found found = find(motors, entry, step);
          if (after_entry)
            after_entry((&entry - entries.data() + 1.) / entries.size());
          return found;
        },
               ranks);
    std::vector<Sensitivity> all;
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      Sensitivity one{entries[i], found[i].step, found[i].of, found[i].obstacle};
      if (!one.obstacle.empty() || one.largest() > negligible)
        all.push_back(std::move(one));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Sensitivity &a, const Sensitivity &b)
                     { return a.largest() > b.largest(); });
    return all;
  }

  void add_differences(std::vector<Sensitivity> &all, const std::vector<Sensitivity> &on_others)
  {
    for (Sensitivity &one : all)
      for (const Sensitivity &other : on_others)
        if (one.entry.path == other.entry.path && one.of.size() == other.of.size())
          for (std::size_t q = 0; q < one.of.size(); ++q)
            one.of[q].error += std::abs(one.of[q].value - other.of[q].value);
  }
} // namespace ringmotor
