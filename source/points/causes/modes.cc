// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** On the next coarser mesh. */
    const Variation coarse_modes{"coarse modes", nullptr,
                                 [](MotorInUse &motor, const double)
                                 { motor.modes = &motor.bodies.coarse_modes; },
                                 false, true};
    /** On that mesh, see RotorVibration. */
    const Variation other_harmonics{"modes of other harmonics", nullptr,
                                    [](MotorInUse &motor, const double)
                                    { motor.modes = &motor.bodies.modes_of_other_harmonics; },
                                    false, true};

    /** Without inertia of the bodies under contact forces. */
    const Variation bodies_at_rest{
        "bodies without inertia", nullptr,
        [](MotorInUse &motor, const double) { motor.leave_modes_of_stator_alone(); }, false, true};

    double with_damping(const CondensedMotor &motor)
    {
      constexpr double with_loss_factor = 1e-3;
      return with_loss_factor / std::max(with_loss_factor, motor.dynamics.loss_factor);
    }

    /** What modes of a level were found to be off by where neither a coarser mesh nor other
     * harmonics change the result, by chance, see effects.md; less where damping limits their
     * resonances. */
    PointError least_error(const CurvePoint &point, const CondensedMotor &motor,
                           const double crest_speed)
    {
      constexpr std::array<double, RotorVibration::finest_level + 1> of_speed{
          {1e-2, 1e-2, 8e-3, 4e-3}},
          of_loss{{5e-2, 3e-2, 1.5e-2, 7e-3}};
      const double sharpness = with_damping(motor);
      return shares_of(point, crest_speed, sharpness * of_speed[motor.modes_level],
                       sharpness * of_loss[motor.modes_level]);
    }

    /** The share of what inertia changes that modes of a level may miss. */
    double least_share(const CondensedMotor &motor)
    {
      constexpr std::array<double, RotorVibration::finest_level + 1> of_change{
          {0.2, 0.2, 0.1, 0.05}};
      return with_damping(motor) * of_change[motor.modes_level];
    }

    /** Whether modes of the rotor are excited in its resonances. */
    bool rotor_resonates(const CondensedMotor &motor)
    {
      return motor.has_modes_of(ModePart::rotor) && !motor.dynamics.is_hysteretic;
    }

    /** Vibrations of rotor and teeth: their mesh, and the harmonics left out. */
    class ErrorOfModes : public ErrorCause
    {
    public:
      ErrorOfModes() : ErrorCause("modes of rotor and teeth", Cure::modes) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        if (!scene.motor().has_modes())
          return {};
        std::vector<Discretisation> needed{scene.for_variations().with(coarse_modes),
                                           scene.for_variations().with(other_harmonics)};
        if (rotor_resonates(scene.motor()))
          needed.push_back(scene.for_variations().with(bodies_at_rest));
        return needed;
      }

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        if (!scene.motor().has_modes())
          return {};
        // From level to level the errors of the meshes are at most halved; those of the harmonics
        // left out decrease with the square of their number, which is multiplied by one and a half.
        constexpr double of_mesh = 0.6, of_harmonics = 1.8;
        const Discretisation requested = scene.for_variations();
        const CurvePoint &point        = scene.table.at(own, request),
                         &coarse       = scene.table.at(requested.with(coarse_modes), request),
                         &other        = scene.table.at(requested.with(other_harmonics), request);
        PointError error               = of_mesh * scene.change_by(coarse_modes, request);
        error.add_independent(of_harmonics * change(coarse, other));
        const CondensedMotor &motor = scene.motor();
        if (rotor_resonates(motor))
          error.raise(least_share(motor) * scene.change_by(bodies_at_rest, request));
        error.raise(least_of(point, scene));
        return error.raise(least_of_power(point, error));
      }

      PointError least_of(const CurvePoint &point, const ErrorScene &scene) const override
      {
        const CondensedMotor &motor = scene.motor();
        return rotor_resonates(motor) ? least_error(point, motor, scene.crest_speed(point))
                                      : PointError();
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_modes()
  {
    return std::make_unique<const ErrorOfModes>();
  }
} // namespace ringmotor
