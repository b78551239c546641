// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/text.h>
#include <ringmotor/programs/contact_progress.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    constexpr double worth_telling = 10.; ///< s
  }

  void ContactProgress::enter(const std::string &phase)
  {
    leave();
    scope.emplace(phases, phase);
  }

  void ContactProgress::condensed(const unsigned int level, const CondensedMotor &motor)
  {
    log.line("interface mesh " + std::to_string(level) + ": " + std::to_string(motor.nodes.size()) +
             " contact nodes per tooth, " + std::to_string(motor.n_dofs) + " dofs condensed");
  }

  void ContactProgress::before_refinement(const unsigned int level, const double of_motor,
                                          const double of_points)
  {
    // From one mesh of the sequence to the next, mainly by the growing interface.
    constexpr double of_seconds = 4., of_memory = 2.5, gigabyte = 1e3; // MB
    log.line("refining: interface mesh " + std::to_string(level) + " may take about " +
             text(of_seconds * of_motor, 1) + " s to condense, " + text(of_seconds * of_points, 1) +
             " s for its operating points, and " +
             text(of_memory * peak_memory_MB() / gigabyte, 1) + " GB of memory");
  }

  void ContactProgress::before_points(const Discretisation &discretisation,
                                      const CondensedMotor &motor, const unsigned int n_points)
  {
    effort  = std::pow(motor.nodes.size() * discretisation.steps.n_parts, 1.5);
    n_asked = n_points;
    n_found = 0;
    begin = told         = Clock::now();
    const double seconds = n_points * seconds_per_effort * effort;
    if (seconds > worth_telling)
      log.line((n_points == 1 ? "the next operating point on interface mesh "
                              : "each of the next " + std::to_string(n_points) +
                                    " operating points on interface mesh ") +
               std::to_string(discretisation.level) + " has " +
               std::to_string(motor.nodes.size() * motor.repeating().n_sectors() *
                              discretisation.steps.n_parts) +
               " contact nodes; " + (n_points == 1 ? "it" : "together they") + " may take about " +
               text(seconds, 0) +
               " s; Accuracy/Time limit stops them, a larger Accuracy/Contact target makes them "
               "cheaper");
  }

  void ContactProgress::after_point(const CurvePoint &point)
  {
    ++n_found;
    log.progress("operating points", std::min(1., n_found / (1. * n_asked)));
    seconds_per_effort = point.seconds / effort;
    if (seconds_since(told) < worth_telling)
      return;
    told                        = Clock::now();
    const OperatingPoint &found = point.result;
    log.line(std::to_string(n_found) + " of " + std::to_string(n_asked) +
             " operating points found on this interface mesh, the last one, still without error "
             "bars, at " +
             text(found.torque / units::torque.size, 2) + " mN m and " +
             text(found.speed / units::speed.size, 2) + " rpm" +
             (n_found < n_asked
                  ? "; the others on this mesh may take about " +
                        text(seconds_since(begin) * (n_asked - n_found) / n_found, 0) + " s"
                  : ""));
  }
} // namespace ringmotor
