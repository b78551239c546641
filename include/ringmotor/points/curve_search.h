// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/effect_on_points.h>
#include <ringmotor/points/quantity_scales.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace ringmotor
{
  /**
   * The operating points that `Loading` requests, with meshes and time steps refined until speeds
   * and torques meet `Accuracy/Contact target`.
   *
   * The meshes are the same for all points; each point has its own time step, short enough that its
   * powers also balance. The errors of a point are estimated from its own changes alone: that of
   * the meshes from the change from the next coarser ones, with a margin, as convergence is not
   * regular at the edge of contact; that of the step, of first order, from the change from a longer
   * one on the mesh in use; that of the wave from a solution with the wave changed by its error.
   */
  class CurveSearch
  {
  public:
    /** Functions that compute motors and points. Collective: called on all ranks. */
    struct Sources
    {
      /** Motors at several levels, which ranks can share. */
      std::function<std::vector<TimedMotor>(const std::vector<unsigned int> &levels,
                                            unsigned int modes_level)>
          motors;
      std::function<std::vector<CurvePoint>(const Parameters &, const CondensedMotor &,
                                            const CurveSetting &, const std::vector<PointRequest> &,
                                            const std::vector<CurvePoint> &starts)>
          points;
      /** Told before meshes are refined: the next level, and the seconds that the motor and the
       * points took on the last one. */
      std::function<void(unsigned int level, double motor_seconds, double point_seconds)>
          before_refinement = [](const unsigned int, const double, const double) {};
    };

    /** @param wave_error relative, of the speed of the stator's surface
     * @param period s, of the wave
     * @param left_out effects that `auto` leaves out */
    CurveSearch(const Parameters &parameters, const double wave_error, const double period,
                const Sources &sources, const LeftOut &left_out = {});

    /** Refines until the target is met or, with `Accuracy/Mode = fixed`, computes what is
     * requested.
     * @throws UserError for a load beyond stall
     * @throws ComputationError if the target is out of reach */
    void find();

    /** The final meshes of find(), their motor and its points with error bars. */
    unsigned int level() const { return reached_level; }
    const CondensedMotor &motor() const { return *motors.at(reached_level); }
    /** The motor on the meshes with which those of motor() were compared. */
    const CondensedMotor &compared_motor() const
    {
      return *motors.at(compared_with(reached_level));
    }
    /** The steps with which meshes were compared. */
    CurveSetting setting() const { return steps.plain(reached_level); }
    const std::vector<CurvePoint> &points() const { return results; }
    /** Whether the wave does not turn the rotor: within the target it stands still under a quarter
     * of the torque that friction can bear. This is then the last point of a curve. */
    bool rotor_sticks() const { return stalled.request.control == Control::torque; }
    /** The parameters with the discretisation of find() as given settings, `Accuracy/Mode = fixed`:
     * its meshes and modes, and for all points the shortest of their steps. */
    Parameters frozen() const;
    /** The largest error bar of the quantities that `Accuracy/Quantities` lists, relative to the
     * largest of their values. */
    double worst_error() const;

    /** How much the result at the middle point would change, in rad/s for a given torque, else in
     * N m. */
    struct StaticFrictionEffect
    {
      CurvePoint middle;
      double dynamic_alone; ///< with the dynamic coefficient alone
      double half_step, finer_mesh;
    };
    StaticFrictionEffect static_friction_effect();

  private:
    /** The level compared with @p level to estimate the error of the meshes. */
    static unsigned int compared_with(const unsigned int level)
    {
      return level == 0 ? 1 : level - 1;
    }

    /** Condenses those that are missing of some levels. */
    void condense(const std::vector<unsigned int> &levels);
    const CondensedMotor &motor_of(const unsigned int level);
    /** Whether the error of the averaging window is taken from points of this setting. */
    bool needs_window(const CurveSetting &setting) const;
    /** Computes points of some requests where they are not known yet.
     * @param from_rest see starts_for() */
    void find_points_of(CurveSetting setting, const std::vector<unsigned int> &wanted,
                        const bool from_rest = false);
    /** Takes points of the first curve for the requests that ask for them. */
    void recognise(const std::vector<CurvePoint> &points);
    /** One of them. */
    const CurvePoint &point_of(const CurveSetting &setting, const unsigned int request)
    {
      find_points_of(setting, {request});
      return known[setting].at(request);
    }
    /** Points by setting and request. */
    using KnownPoints = std::map<CurveSetting, std::map<unsigned int, CurvePoint>>;
    static bool has_all(const KnownPoints &points, const CurveSetting &setting,
                        const std::vector<unsigned int> &wanted);
    /** Points from which others can be started: with coarser modes, with longer steps, on another
     * mesh, or near them on the first curve. @param from_rest without any, each is to be found from
     * rest, not from the one before it */
    std::vector<CurvePoint> starts_for(const CurveSetting &setting,
                                       const std::vector<unsigned int> &wanted,
                                       const bool from_rest);
    /** The point of the #outline that is nearest to a request: the most similar load. */
    const CurvePoint &nearest_of_outline(const PointRequest &request) const;
    /** Steps of twice the length, if they divide the pitch; those of plain() for a changed motor.
     */
    CurveSetting longer_steps(const CurveSetting &setting) const;
    /** The known one with the shortest steps that are longer than those of a setting; null without
     * one. */
    const CurvePoint *point_with_longer_steps(const CurveSetting &setting,
                                              const unsigned int request) const;
    /** Finds points with few steps on the reached level and on that with which it is compared. */
    void find_on_both_meshes();
    /** Finds each point with its own step. */
    void find_with_own_steps();
    std::vector<unsigned int> all_requests() const;
    /** Computes all points of the reached level with their time steps and error bars. */
    void evaluate();
    std::map<std::string, PointError> errors_of(const unsigned int request);
    PointError mesh_error(const unsigned int request);
    /** Refines the meshes while their error alone is too large. */
    void refine_meshes();
    void take_finer_meshes();
    /** Takes modes of the next level; all points must then be computed again. */
    void take_finer_modes();
    /** Reports that only @p error, not the target, can be reached. @throws ComputationError */
    [[noreturn]] void refuse(const double error,
                             const std::string &where = "on the finest interface mesh") const;
    /** Whether powers balance at all points; shortens the steps where they do not. */
    bool powers_balance();
    /** @throws ComputationError if the imbalance of a point's powers, @p excess times the largest
     * admissible one, falls so slowly with the step that no step will do */
    void foresee_balance(const unsigned int request, const double excess);
    /** Divides the step of a point into more parts. */
    void shorten_step(const unsigned int request, const unsigned int parts);
    /** What reduces one cause of the error of a point. */
    struct Cure
    {
      enum class Kind
      {
        modes,
        step,
        mesh
      } kind;
      double error;   ///< relative, of that cause now
      double remains; ///< which share of it is expected to remain
    };
    /** Those that are possible, of the largest error first. */
    std::vector<Cure> cures_of(const unsigned int request) const;
    /** For each point that misses the target takes the fewest cures that are expected to suffice.
     * @throws ComputationError if a point has none */
    void refine();
    /** @throws ComputationError if the errors of the drive alone exceed the target */
    void require_accurate_drive() const;
    /** Processor seconds of the points of a setting. */
    double point_seconds(const CurveSetting &setting);
    void find_requests(const unsigned int n_parts);
    /** Finds stall and, for a curve, no load; what the rotor is held by if it stands still. */
    void find_ends();
    /** The same at a given voltage: no load and, for a curve, stall. */
    void find_driven_ends();
    /** @throws UserError for a given torque beyond stall */
    void require_bearable_torques() const;
    /** Whether a curve is wanted whose points depend on its shape. */
    bool needs_shape() const;
    /** Where the whole curve is computed: along its shape on the first mesh, or at rising torques
     * if the rotor stands still under all of them, or without load. */
    std::vector<PointRequest> points_of_curve();
    /** Speeds in even steps, from no load to stall: at a given voltage torques in between may be
     * larger than at stall. */
    std::vector<PointRequest> falling_speeds() const;
    /** Torques in even steps, from no load to the last point. */
    std::vector<PointRequest> rising_torques() const;
    /** Whether the rotor moves less than the target, relative to the wave's crests. */
    bool stands_still(const CurvePoint &point) const;
    /** The setting with whose steps those of a point are compared. */
    CurveSetting compared_step(const unsigned int request) const;
    /** The setting on which changes of the motor are made: on the last mesh but one, from mesh 2
     * on. */
    CurveSetting unchanged_motor() const;
    CurveSetting changed_wave() const;
    CurveSetting with_modes(const ModesInUse modes) const;
    CurveSetting other_scheme() const;
    CurveSetting other_drive() const;
    /** All of these that serve to estimate an error of this motor. */
    std::vector<CurveSetting> changed_motors() const;
    /** Loads a rotor that may stand still more and more, to see under which torques it does. */
    void find_held_torque();
    /** Whether so many points stick at rest that friction may balance any torque. */
    bool may_stand_still() const;
    /** The speed (rad/s) of the crests of a wave of an amplitude (m), see
     * CondensedMotor::crest_speed(). */
    double crest_speed(const double amplitude) const;
    /** Whether the amplitude of the wave follows from a voltage. */
    bool is_driven() const { return parameters.wave.drive == Drive::voltage; }
    /** The torque (N m) that friction bears if all contact points slip the same way. */
    double borne_torque() const;
    QuantityScales scales() const;
    /** The largest relative error of the held quantities, those with a target of their own weighted
     * so that `Contact target` is the limit of all. */
    double relative(const PointError &error) const;

    const Parameters &parameters;
    const double wave_error;
    const StepChoice steps;
    const Sources sources;
    const LeftOut left_out;
    const bool has_inertia;
    /** Of the discretisations that are tried: with inertia all but the last one, which gains
     * nothing against the scatter of impacts. */
    const unsigned int finest_level;
    CurvePoint stalled;            ///< on the first mesh; the loaded point if the rotor sticks
    double stall_torque      = 0.; ///< N m; of the first motor that was computed
    double largest_amplitude = 0.; ///< m, of the wave; that without load
    /** The first points of all, on the first mesh, from which others start: at rest if the rotor
     * may stand still, then those that tell the shape of the curve. */
    std::vector<CurvePoint> outline;
    std::vector<PointRequest> requests;
    unsigned int reached_level = 0;
    unsigned int modes_level;          ///< of the rotor, see RotorVibration
    std::vector<unsigned int> n_parts; ///< by request
    /** Parts of a step and imbalance of the powers when it was first too large, by level and
     * request. */
    std::map<std::pair<unsigned int, unsigned int>, std::pair<double, double>> first_imbalances;
    std::vector<CurvePoint> results;
    std::map<unsigned int, std::unique_ptr<const CondensedMotor>> motors; ///< by level
    KnownPoints known, with_coarser_modes;
    std::map<unsigned int, double> motor_seconds; ///< wall clock, by level
  };
} // namespace ringmotor
