// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/points/torque_speed.h>

#include <string>

namespace ringmotor
{
  /** All that the condensation of a motor on an interface mesh depends on: this very build of the
   * program, the wave and relevant_for_condensation() of the parameters. */
  std::string condensation_key(const Parameters &parameters, const StatorWave &wave,
                               const unsigned int level);

  /** All that operating points depend on besides the request. */
  std::string points_key(const Parameters &parameters, const StatorWave &wave,
                         const unsigned int level);

  /**
   * What a run of the program `contact` keeps in `kept/` below its folder for later runs: condensed
   * motors, which any run uses, and operating points, for a run that resumes. A file that is
   * damaged or belongs to other parameters, another wave or another build of the program is
   * computed again.
   *
   * All members are called on all ranks of @p communicator together, unlike most functions in this
   * folder.
   */
  class ContactKeep
  {
  public:
    /**
     * Removes the points of earlier runs unless this run @p resumes.
     * @param folder of the results, which exists; ends in a slash
     * @throws UserError if the file system refuses
     */
    ContactKeep(const std::string &folder, const StatorWave &wave, const bool resumes, Log &log,
                MPI_Comm communicator);

    /** Computes motors of some levels. */
    using Condense =
        std::function<std::vector<TimedMotor>(const std::vector<unsigned int> &levels)>;
    /** Condensed motors with ContactDiscretisation::level(): read or, if missing, computed.
     * @param modes_level of their rotor; none if it has no modes */
    std::vector<TimedMotor> condensed(const Parameters &parameters,
                                      const std::vector<unsigned int> &levels,
                                      const std::optional<unsigned int> &modes_level,
                                      const Condense &condense);

    /** find_points(): missing points are computed and kept immediately. */
    std::vector<CurvePoint> points(
        const Parameters &parameters, const CondensedMotor &motor, const CurveSetting &setting,
        const std::vector<PointRequest> &requests,
        const std::function<void(const CurvePoint &)> &after_point = [](const CurvePoint &) {},
        const std::vector<CurvePoint> &starts                      = {});

    /** Removes what is kept in the folder of the results, and reports how much that was.
     * @throws UserError if the file system refuses */
    static void clear(const std::string &folder);

    /** Logs how many points of a resumed run were available, and how much is kept. */
    void report();

  private:
    /** Numbers of points that a rank has looked for. */
    struct Counts
    {
      unsigned int found = 0, recalled = 0, damaged = 0; // found: computed by this run
    };
    class Points;

    std::optional<TimedMotor> read(const unsigned int level, const std::string &path,
                                   const std::string &key);

    const std::string motors, points_folder;
    const StatorWave &wave;
    const bool resumes;
    Log &log;
    const MPI_Comm communicator;
    Counts counts;
  };
} // namespace ringmotor
