// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/torque_speed.h>

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** How finely bodies and time are divided. */
  struct CurveSetting
  {
    unsigned int level = 0; ///< of the meshes, see ContactDiscretisation::level()
    /** Into how many parts a step is divided: the moments of the steady state, or the parts of
     * Time/Time step. */
    unsigned int n_parts = 1;

    bool operator<(const CurveSetting &other) const
    {
      return std::pair(level, n_parts) < std::pair(other.level, other.n_parts);
    }
  };

  /**
   * The operating points that `Loading` asks for, on meshes and with time steps that get finer
   * until speeds and torques are as accurate as `Accuracy/Contact target` asks for.
   *
   * The error by the meshes is taken from the change from the next coarser ones, with a margin, as
   * convergence is not regular at the edge of contact; that by the step, which is of first order,
   * from the change by halving it on the coarser mesh.
   */
  class CurveSearch
  {
  public:
    /** Where motors and points come from. Collective: called on all ranks alike. */
    struct Sources
    {
      std::function<CondensedMotor(unsigned int level)> motor;
      std::function<std::vector<CurvePoint>(const Parameters &, const CondensedMotor &,
                                            const CurveSetting &,
                                            const std::vector<PointRequest> &)>
          points;
    };

    /** @param wave_error relative, of the speed of the stator's surface */
    CurveSearch(const Parameters &parameters, const double wave_error, const Sources &sources);

    /** Refines until the target is met or, `Accuracy/Mode = fixed`, computes what is asked for.
     * @throws UserError for a load beyond stall
     * @throws ComputationError if the target is out of reach */
    void find();

    /** The setting that find() ended with, its motor and its points with their error bars. */
    const CurveSetting &setting() const { return reached; }
    const CondensedMotor &motor() const { return *motors.at(reached.level); }
    const std::vector<CurvePoint> &points() const { return curves.at(reached); }
    /** Relative to the fastest speed and to the stall torque: the largest error bar. */
    double worst_error() const;

    /** How the result in the middle of the points would change, in rad/s with a given torque, else
     * in N m. */
    struct StaticFrictionEffect
    {
      CurvePoint middle;
      double dynamic_alone; ///< by the dynamic coefficient alone
      double half_step, finer_mesh;
    };
    StaticFrictionEffect static_friction_effect();

    /** A setting of a study, computed with all points. */
    struct Rung
    {
      CurveSetting setting;
      unsigned int n_nodes, n_dofs;
      unsigned int n_steps;          ///< in a period
      double largest_error;          ///< relative, see worst_error()
      double distance;               ///< largest change to the last setting, relative
      double seconds;                ///< of the motor and all its points
      double seconds_with_error_bar; ///< with those that the error bars take
    };
    /** Computes a ladder of settings, the finest mesh last: all interface meshes or, `Accuracy/Mode
     * = fixed`, those up to `Accuracy/Interface refinement`, each but the finest with half the time
     * step, too. @p after_rung is called after each, when its distance is not known yet. */
    std::vector<Rung> climb(const std::function<void(const Rung &)> &after_rung);

  private:
    const CondensedMotor &motor_of(const unsigned int level);
    std::vector<CurvePoint> &points_of(const CurveSetting &setting);
    std::vector<PointError> mesh_errors(const CurveSetting &setting);
    std::vector<PointError> time_errors(const CurveSetting &setting);
    /** Gives the points of a setting their error bars. */
    void estimate_errors(const CurveSetting &setting);
    void refine();
    Rung rung_of(const CurveSetting &setting);
    /** Processor seconds of the points of a setting. */
    double point_seconds(const CurveSetting &setting);
    void find_requests(const CurveSetting &setting);
    /** Steps of the steady state so that a period has ninety or more. */
    unsigned int parts_to_start_with() const;
    /** The larger one of the relative errors of speeds and torques. */
    double worst(const std::vector<PointError> &errors) const;

    const Parameters &parameters;
    const double wave_error;
    const Sources sources;
    double stall_torque = 0.; ///< N m; of the first motor that was computed
    std::vector<PointRequest> requests;
    CurveSetting reached;
    std::map<unsigned int, std::unique_ptr<const CondensedMotor>> motors; ///< by level
    std::map<CurveSetting, std::vector<CurvePoint>> curves;
    std::map<unsigned int, double> motor_seconds; ///< wall clock, by level
  };
} // namespace ringmotor
