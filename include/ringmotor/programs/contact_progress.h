// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/points/progress.h>

#include <chrono>
#include <optional>

namespace ringmotor
{
  /**
   * Measures the phases of a search and tells how far it is, and in advance what meshes and
   * operating points may cost, from what the last ones did. The seconds of a point are taken as
   * proportional to (contact nodes * steps)^1.5.
   */
  class ContactProgress : public Progress
  {
  public:
    ContactProgress(Log &log, Phases &phases) : log(log), phases(phases) {}

    void enter(const std::string &phase) override;
    void leave() override { scope.reset(); }
    void condensed(const unsigned int level, const CondensedMotor &motor) override;
    void before_refinement(const unsigned int level, const double of_motor,
                           const double of_points) override;
    /** Says nothing if they take little time. */
    void before_points(const Discretisation &discretisation, const CondensedMotor &motor,
                       const unsigned int n_points) override;
    void after_point(const CurvePoint &point) override;

  private:
    using Clock = std::chrono::steady_clock;
    static double seconds_since(const Clock::time_point time)
    {
      return std::chrono::duration<double>(Clock::now() - time).count();
    }

    Log &log;
    Phases &phases;
    std::optional<Phases::Scope> scope;
    double effort             = 0.; ///< of a point: (contact nodes * steps)^1.5
    double seconds_per_effort = 0.; ///< at the last point
    unsigned int n_asked = 0, n_found = 0;
    Clock::time_point begin, told;
  };
} // namespace ringmotor
