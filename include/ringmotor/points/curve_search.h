// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/points/curve_requests.h>
#include <ringmotor/points/held_errors.h>
#include <ringmotor/points/power_balance.h>

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace ringmotor
{
  /**
   * The operating points that `Loading` requests, with meshes and time steps refined until speeds
   * and torques meet `Accuracy/Contact target`.
   *
   * The meshes are the same for all points; each point has its own time step, short enough that its
   * powers also balance. The errors of a point are estimated from its own changes, see ErrorCause;
   * along a curve from those of points nearby, see MeasuredPoints.
   */
  class CurveSearch
  {
  public:
    /** @param wave whose error and frequency matter
     * @param left_out effects that `auto` leaves out */
    CurveSearch(const Parameters &parameters, const StatorWave &wave, PointSource &source,
                Progress &progress, const LeftOut &left_out = {});

    /** Refines until the target is met or, with `Accuracy/Mode = fixed`, computes what is
     * requested.
     * @throws UserError for a load beyond stall
     * @throws ComputationError if the target is out of reach */
    void find();

    /** The motor on the final meshes of find(), and its points with error bars. */
    const CondensedMotor &motor() const { return scene.motor(); }
    /** The motor on the meshes with which those of motor() were compared. */
    const CondensedMotor &compared_motor() const
    {
      return scene.table.motor(ErrorScene::compared_with(scene.level), scene.modes_level);
    }
    /** The final meshes, with the steps with which they were compared. */
    Discretisation discretisation() const { return scene.plain(); }
    const std::vector<CurvePoint> &points() const { return results; }
    /** See CurveRequests::rotor_sticks(). */
    bool rotor_sticks() const { return requests->rotor_sticks(); }
    /** The parameters with the discretisation of find() as given settings, `Accuracy/Mode = fixed`:
     * its meshes and modes, and for all points the shortest of their steps. */
    Parameters frozen() const;
    /** The largest error bar of the quantities that `Accuracy/Quantities` lists, relative to the
     * largest of their values at measured points. */
    double worst_error() const { return errors->worst_of(results); }

    /** How much the result at the middle point, or at a measured one near it, would change, in
     * rad/s for a given torque, else in N m. */
    struct StaticFrictionEffect
    {
      CurvePoint middle;
      bool is_step_longer;  ///< the other one: twice, not half as long
      double dynamic_alone; ///< with the dynamic coefficient alone
      double other_step, finer_mesh;
    };
    StaticFrictionEffect static_friction_effect();

  private:
    /** Finds all points, those of a marched motor perhaps without their fields. */
    void search();
    /** That of the curve which shows where points are wanted. Of a marched motor, whose points
     * are dear, it is the cheap one for variations. */
    Discretisation for_first_curve() const;
    /** Refines the meshes while their error alone is too large. */
    void refine_meshes();
    /** Some requests by the discretisation in which their results are given. */
    PointTable::Needs own_points(const std::vector<PointRequest> &of) const;
    /** What own points and the error bars need. */
    PointTable::Needs needs_of(const std::vector<PointRequest> &these) const;
    /** Computes the measured points from which others start. */
    void fill_starts();
    /** The part of the error bar of a point that a cause has. */
    PointError error_of(const ErrorCause &cause, const PointRequest &request);
    /** Computes points of the reached level with their time steps and error bars. */
    void evaluate(const std::vector<PointRequest> &these);
    /** Evaluates points. If they miss the target or the balance of powers, refines what helps.
     * @return whether they do not */
    bool suffices(const std::vector<PointRequest> &these);
    /** Of a step: the smaller number of the measured points around a point. */
    unsigned int parts_nearby(const PointRequest &request) const;
    /** Whether powers balance at the evaluated points; shortens the steps where they do not. */
    bool powers_balance();
    /** Measures the errors of points that miss the target by those of their neighbours. Without
     * such points takes, for each one that misses it, the cheapest cures that are expected to
     * suffice.
     * @throws ComputationError if a point has none */
    void refine();
    /** The squares of the relative errors of a point that can be made smaller, by what does. */
    std::map<Cure, double> curable_errors(const CurvePoint &point) const;
    void take(const std::set<Cure> &cures);
    void take_finer_meshes();
    void shorten_steps(const PointRequest &request, const unsigned int parts);

    /** The discretisation of a point. */
    Discretisation own(const PointRequest &request) const
    {
      return scene.plain().with(Steps{n_parts.at(request)});
    }

    const Parameters &parameters;
    const AccuracyBudget budget;
    const double wave_error;
    const LeftOut left_out;
    Progress &progress;
    const StepChoice steps;
    PointTable table;
    ErrorScene scene;
    /** Of the discretisations that are tried: with inertia all but the last one, which gains
     * nothing against the scatter of impacts. */
    const unsigned int finest_level;
    PowerBalance balance;
    std::unique_ptr<CurveRequests> requests;
    std::unique_ptr<const HeldErrors> errors;
    std::map<PointRequest, unsigned int> n_parts; ///< of a step
    std::vector<CurvePoint> results;
  };
} // namespace ringmotor
