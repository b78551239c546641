// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/point_store.h>
#include <ringmotor/points/progress.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace ringmotor
{
  /** Computes motors and their operating points. Collective: called on all ranks. */
  class PointSource
  {
  public:
    virtual ~PointSource() = default;

    /** The motors on several meshes, with one level of vibrations. */
    virtual std::vector<TimedMotor> motors(const std::vector<unsigned int> &levels,
                                           const unsigned int modes_level) = 0;
    /** The points of requests. @param motor not varied
     * @param starts see OperatingPointFinder::find() */
    virtual std::vector<CurvePoint> points(const Discretisation &discretisation,
                                           const CondensedMotor &motor,
                                           const std::vector<PointRequest> &requests,
                                           const std::vector<CurvePoint> &starts) = 0;
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
    std::vector<CurvePoint> points(const Discretisation &discretisation,
                                   const CondensedMotor &motor,
                                   const std::vector<PointRequest> &requests,
                                   const std::vector<CurvePoint> &starts) override;

  private:
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
