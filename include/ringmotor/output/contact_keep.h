// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/output/log.h>
#include <ringmotor/points/point_store.h>

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
   * All members but those of points are called on all ranks of @p communicator together, unlike
   * most functions in this folder.
   */
  class ContactKeep : public PointStore
  {
  public:
    /**
     * Removes the points of earlier runs unless this run @p resumes.
     * @param folder of the results, which exists; ends in a slash
     * @param parameters, wave which must outlive this object
     * @throws UserError if the file system refuses
     */
    ContactKeep(const std::string &folder, const Parameters &parameters, const StatorWave &wave,
                const bool resumes, Log &log, MPI_Comm communicator);

    std::optional<TimedMotor> recall_motor(const unsigned int level,
                                           const std::optional<unsigned int> &modes_level) override;
    void keep_motor(const unsigned int level, const std::optional<unsigned int> &modes_level,
                    const CondensedMotor &motor) override;
    std::unique_ptr<PointMemory> points(const Parameters &varied,
                                        const Discretisation &discretisation) override;

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

    /** The file of a motor, and what it must belong to. */
    struct Place
    {
      std::string path, key;
    };
    Place place_of(const unsigned int level, const std::optional<unsigned int> &modes_level) const;

    const std::string motors, points_folder;
    const Parameters &parameters;
    const StatorWave &wave;
    const bool resumes;
    Log &log;
    const MPI_Comm communicator;
    Counts counts;
  };
} // namespace ringmotor
