// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/quantities/effect_on_points.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * The operating points that `Loading` asks for, on meshes and with time steps that get finer
   * until speeds and torques are as accurate as `Accuracy/Contact target` asks for.
   *
   * The meshes are the same for all points; each point has its own time step, so short that its
   * powers balance, too. Errors of a point come from its own changes alone: by the meshes from the
   * change from the next coarser ones, with a margin, as convergence is not regular at the edge of
   * contact; by the step, which is of first order, from the change since a longer one, on the mesh
   * in use; by the wave from a solution with the wave changed by its error.
   */
  class CurveSearch
  {
  public:
    /** Where motors and points come from. Collective: called on all ranks alike. */
    struct Sources
    {
      std::function<CondensedMotor(unsigned int level, unsigned int modes_level)> motor;
      std::function<std::vector<CurvePoint>(const Parameters &, const CondensedMotor &,
                                            const CurveSetting &, const std::vector<PointRequest> &,
                                            const std::vector<CurvePoint> &starts)>
          points;
    };

    /** @param wave_error relative, of the speed of the stator's surface
     * @param period s, of the wave
     * @param left_out effects that `auto` leaves out */
    CurveSearch(const Parameters &parameters, const double wave_error, const double period,
                const Sources &sources, const LeftOut &left_out = {});

    /** Refines until the target is met or, `Accuracy/Mode = fixed`, computes what is asked for.
     * @throws UserError for a load beyond stall
     * @throws ComputationError if the target is out of reach */
    void find();

    /** The meshes that find() ended with, their motor and its points with their error bars. */
    unsigned int level() const { return reached_level; }
    const CondensedMotor &motor() const { return *motors.at(reached_level); }
    const std::vector<CurvePoint> &points() const { return results; }
    /** Whether the wave does not turn the rotor: it stands still, as far as the target can tell,
     * though a quarter of the torque that friction bears loads it. The last point of a curve is
     * then this one. */
    bool rotor_sticks() const { return stalled.request.control == Control::torque; }
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
    static constexpr unsigned int finest_level = 3;
    /** A rotor pressed so hard that it hardly moves has neither a speed nor a torque with which
     * errors could be compared; then they are with this share of the speed of the wave's crests and
     * of the torque that friction bears. */
    static constexpr double share_of_scales = 0.5;
    /** The level whose change to @p level tells the error of the meshes. */
    static unsigned int compared_with(const unsigned int level)
    {
      return level == 0 ? 1 : level - 1;
    }

    const CondensedMotor &motor_of(const unsigned int level);
    /** Whether the error bars take the averaging window from points of this setting. */
    bool needs_window(const CurveSetting &setting) const;
    /** Computes points of some requests where they are not known yet. */
    void find_points_of(CurveSetting setting, const std::vector<unsigned int> &wanted);
    /** One of them. */
    const CurvePoint &point_of(const CurveSetting &setting, const unsigned int request)
    {
      find_points_of(setting, {request});
      return known[setting].at(request);
    }
    /** Known points from which others can be found: of longer steps, or of another mesh. */
    std::vector<CurvePoint> starts_for(const CurveSetting &setting,
                                       const std::vector<unsigned int> &wanted);
    /** The known one whose steps are longer than those of a setting, but not by much. */
    const CurvePoint &point_with_longer_steps(const CurveSetting &setting,
                                              const unsigned int request);
    /** Points with few steps of the reached level and of that with which it is compared. */
    void find_on_both_meshes();
    /** Points with the step that each has. */
    void find_with_own_steps();
    std::vector<unsigned int> all_requests() const;
    /** All points of the reached level with their time steps and error bars. */
    void evaluate();
    PointErrors errors_of(const unsigned int request);
    PointError mesh_error(const unsigned int request);
    /** Takes finer meshes as long as their error alone is too large. */
    void refine_meshes();
    void take_finer_meshes();
    /** Takes modes of the next level, with which all is found anew. */
    void take_finer_modes();
    /** The target is out of reach, @p error is not. @throws ComputationError */
    [[noreturn]] void refuse(const double error) const;
    /** Whether powers balance at all points; shortens the steps of those at which they do not. */
    bool powers_balance();
    /** Gives a point more parts of a step. */
    void shorten_step(const unsigned int request, const unsigned int parts);
    void refine();
    Rung rung_of(const CurveSetting &setting);
    /** Processor seconds of the points of a setting. */
    double point_seconds(const CurveSetting &setting);
    void find_requests(const unsigned int n_parts);
    /** Where the whole curve is computed: along its shape on the first mesh, or at rising torques
     * if the rotor sticks under all of them. */
    std::vector<PointRequest> points_of_curve();
    /** With which steps those of a point are compared. */
    CurveSetting compared_step(const unsigned int request) const;
    CurveSetting changed_wave() const;
    CurveSetting coarse_modes() const;
    CurveSetting other_scheme() const;
    /** All of these that tell an error of this motor. */
    std::vector<CurveSetting> changed_motors() const;
    /** Loads a rotor that nearly sticks at rest, to see whether it stands still. */
    void find_held_torque();
    /** Whether nearly all points stick at stall. */
    bool nearly_sticks() const;
    /** What friction bears (N m) where all points slip the same way. */
    double borne_torque() const;
    /** Of a speed relative to the fastest one, or to half that of the wave's crests if that is
     * more; of a torque to that at stall, or to half of what friction bears. */
    double relative(const PointError &error) const;

    const Parameters &parameters;
    const double wave_error;
    const StepChoice steps;
    const Sources sources;
    const LeftOut left_out;
    const bool has_inertia;
    CurvePoint stalled;       ///< on the first mesh; the loaded one if the rotor sticks
    double stall_torque = 0.; ///< N m; of the first motor that was computed
    std::vector<PointRequest> requests;
    unsigned int reached_level = 0;
    unsigned int modes_level;          ///< of the rotor, see RotorVibration
    std::vector<unsigned int> n_parts; ///< by request
    std::vector<CurvePoint> results;
    std::map<unsigned int, std::unique_ptr<const CondensedMotor>> motors; ///< by level
    std::map<CurveSetting, std::map<unsigned int, CurvePoint>> known;     ///< by request
    std::map<unsigned int, double> motor_seconds;                         ///< wall clock, by level
  };
} // namespace ringmotor
