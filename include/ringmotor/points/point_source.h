// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/point_store.h>
#include <ringmotor/points/progress.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace ringmotor
{
  /** Operating points of one motor, which are neighbours on a curve. */
  struct PointSet
  {
    Discretisation discretisation;
    const CondensedMotor &motor; ///< not varied
    std::vector<PointRequest> requests;
    std::vector<CurvePoint> starts; ///< see OperatingPointFinder::find(); empty or one for each
    bool anew = false;              ///< even if a store knows them
  };

  /** Computes motors and their operating points. Collective: called on all ranks. */
  class PointSource
  {
  public:
    virtual ~PointSource() = default;

    /** The motors on several meshes, with one level of vibrations. */
    virtual std::vector<TimedMotor> motors(const std::vector<unsigned int> &levels,
                                           const unsigned int modes_level) = 0;
    /** The points of each set; the more sets, the better they can be shared. */
    virtual std::vector<std::vector<CurvePoint>> points(const std::vector<PointSet> &sets) = 0;
    /** A point has another form, which is to be stored. */
    virtual void replace(const Discretisation & /*discretisation*/, const CurvePoint & /*point*/) {}
  };

  /** Those of a real motor, shared by ranks; what a store knows is not computed again. */
  class ComputedPoints : public PointSource
  {
  public:
    /** All must outlive this object. */
    ComputedPoints(const Parameters &parameters, const StatorWave &wave,
                   const MotorVibration &vibration, PointStore &store, Progress &progress,
                   MPI_Comm communicator);

    std::vector<TimedMotor> motors(const std::vector<unsigned int> &levels,
                                   const unsigned int modes_level) override;
    std::vector<std::vector<CurvePoint>> points(const std::vector<PointSet> &sets) override;
    void replace(const Discretisation &discretisation, const CurvePoint &point) override;

  private:
    /** The parameters of the motor that is varied for a discretisation. */
    Parameters varied(const Discretisation &discretisation) const;
    /** Each by one of the ranks. */
    std::vector<TimedMotor> condense(const std::vector<unsigned int> &levels,
                                     const unsigned int modes_level) const;

    const Parameters &parameters;
    const StatorWave &wave;
    const MotorVibration &vibration;
    PointStore &store;
    Progress &progress;
    const MPI_Comm communicator;
  };
} // namespace ringmotor
