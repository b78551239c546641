// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/sensitivity/motor_entries.h>
#include <ringmotor/sensitivity/nearby_motors.h>

#include <boost/serialization/optional.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>

namespace ringmotor
{
  /** A logarithmic derivative d ln q / d ln e of a quantity q with respect to an entry e: percent
   * of the one per percent of the other. */
  struct LogDerivative
  {
    double value = 0., error = 0.;
    bool is_known = true; ///< not where q has no sign for the logarithm

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &value &error &is_known;
    }
  };

  /** What an entry changes. */
  struct Sensitivity
  {
    MotorEntry entry;
    double step = 0.;                ///< of the entry, in its units
    std::vector<LogDerivative> of{}; ///< the sensitive_quantities(); empty if it has no effect
    std::string obstacle{};          ///< why it is not known, if it is not

    /** From a derivative to the percent that the quantity changes by one percent of
     * MotorEntry::scale: 1 but for radii. */
    double per_scale() const;
    /** The largest absolute value of all derivatives, per_scale(): by which entries are compared.
     */
    double largest() const;
  };

  /** On which side of a motor the two are with which it is compared. */
  enum class Side
  {
    below,
    both,
    above
  };

  /** The derivative from the logarithms of a quantity for three motors, the motor itself and two on
   * a side, of which the logarithms of the entry rise by @p step. The error is half of the
   * difference of both slopes: what the curvature, jumps of the state and the solver leave open. */
  LogDerivative log_derivative(const std::vector<double> &values, const Side side,
                               const double step);

  /**
   * The derivatives with respect to all motor_entries() that have an effect, those that change a
   * quantity most first, then those that are not known.
   * @param step relative to MotorEntry::scale
   * @param ranks share the entries; collective
   * @param after_entry told the part of the work of this rank that is done, 0 .. 1
   */
  std::vector<Sensitivity> sensitivities(const NearbyMotors &motors, const double step,
                                         MPI_Comm ranks,
                                         const std::function<void(double)> &after_entry = {});

  /** Adds to the error bars how far the derivatives are from those of the same entries on other
   * meshes; those that have none there keep theirs. */
  void add_differences(std::vector<Sensitivity> &all, const std::vector<Sensitivity> &on_others);
} // namespace ringmotor
