// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/voltage_drive.h>
#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/discretisation.h>
#include <ringmotor/points/point_store.h>
#include <ringmotor/points/progress.h>
#include <ringmotor/points/wave_balance.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>
#include <utility>

namespace ringmotor
{
  /** Finds operating points of a motor, steady or by marching as its parameters request. Uses only
   * relevant_for_points() of the parameters. */
  class OperatingPointFinder
  {
  public:
    /** The bodies of @p motor and @p memory, which is optional, must outlive this object. @p
     * parameters must match @p discretisation in the parts of a step, @p motor in all else. Without
     * a @p drive the wave has the amplitude of the motor, else the one that the drive gives it. */
    OperatingPointFinder(Parameters parameters, const MotorInUse &motor,
                         const Discretisation &discretisation     = {},
                         const std::optional<VoltageDrive> &drive = {},
                         PointMemory *memory                      = nullptr);

    /** From now on gives up points that are found with inertia after long searches only. */
    void search_briefly() { steady.search_briefly(); }

    /**
     * Looks in the memory first. The search for a steady state starts from that of @p start, of the
     * same or a similar request, or else from the previous point; from rest if @p start is a point
     * without fields. After a point from the memory, the next one is bitwise the same as if the
     * former had been computed.
     * @param start_before the start of the previous point: where that point is a better start, it
     * is changed by what has changed between the two starts
     * @throws ComputationError if none is found
     */
    CurvePoint find(const PointRequest &request, const CurvePoint *start = nullptr,
                    const CurvePoint *start_before = nullptr);

    /** The steady state with a wave of a given amplitude (m), whatever drives it, at the frequency
     * to which the contact shifts it if the model has it so; starts from the previous point.
     * @throws ComputationError if none is found */
    CurvePoint find_at(const PointRequest &request, const double of_wave);

    /** The steady state in which a drive balances the forces on the wave; the amplitude is searched
     * from that of the previous point. @throws ComputationError if none is found */
    CurvePoint find_driven(const PointRequest &request, const VoltageDrive &by);

  private:
    /** The excess of an unknown of the wave at a place, and the point there. */
    using TrialPoint = std::function<std::pair<double, CurvePoint>(double place)>;
    /** The point at which an unknown of the wave is in balance, see balanced(). */
    CurvePoint balance(const WaveUnknown &unknown, const double start, const TrialPoint &at) const;
    /** Whether what a search leaves open is negligible in all results. */
    bool is_negligible(const StableRoot<CurvePoint> &root) const;
    /** Sets the start of a steady state. */
    void begin(const PointRequest &request, const CurvePoint &start,
               const CurvePoint *start_before);
    /** The searches for amplitude and frequency of the wave begin with those of a point. */
    void begin_with_wave_of(const CurvePoint &start);
    CurvePoint find_steady(const PointRequest &request);
    /** The steady state with the wave at an amplitude (m) and a frequency (rad/s). */
    CurvePoint at_frequency(const PointRequest &request, const double of_wave, const double at);

    const unsigned int n_joined; ///< steps
    const Variation variation;
    const Parameters parameters;
    const MotorModel model;
    const MotorInUse motor;
    const std::optional<VoltageDrive> drive;
    SteadyDriver steady;
    double amplitude;     ///< m, at which the search for that of a driven wave begins
    double detuning = 0.; ///< see OperatingPoint, with which the search for the frequency begins
    PointMemory *const memory;
  };

  /** Several points of one motor, neighbours on a curve, to be found. */
  struct PointJob
  {
    Parameters parameters; ///< of the varied motor, still with undivided steps
    MotorInUse motor;      ///< with the mesh and the variation of the discretisation
    Discretisation discretisation      = {};
    std::optional<VoltageDrive> drive  = {};
    std::vector<PointRequest> requests = {};
    std::vector<CurvePoint> starts = {}; ///< see OperatingPointFinder::find(); one each, or none
    std::shared_ptr<PointMemory> memory = {}; ///< consulted on the rank that finds a point
  };

  /**
   * The points of each job, shared by ranks block by block; within a block each point is the start
   * of the next one, so that the values depend on the number of ranks, within what searches leave
   * open. Collective.
   * @param progress told on the rank that finds a point
   */
  std::vector<std::vector<CurvePoint>> find_points(const std::vector<PointJob> &jobs,
                                                   MPI_Comm communicator,
                                                   Progress *progress = nullptr);

  /** What the contact at a point does to a wave that @p drive drives, at a frequency (rad/s). */
  WaveLoad wave_load(const CurvePoint &point, const VoltageDrive &drive, const double frequency);
} // namespace ringmotor
