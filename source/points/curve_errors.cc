// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/points/curve_search.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** How finely numbers that are counted are resolved: a tooth touches for whole steps, and a
     * contact node sticks or slips as a whole. Two discretisations often count the same. */
    PointError resolution(const CurvePoint &point, const CondensedMotor &motor)
    {
      PointError step;
      step["teeth_in_contact_per_wave"] = static_cast<double>(motor.n_teeth) / motor.n_waves *
                                          point.fields.time_step / motor.period();
      double largest = 0., whole = 0.;
      for (const PointVector &force : point.fields.force)
      {
        largest = std::max(largest, force[0]);
        whole += force[0];
      }
      for (const char *const fraction : {"stick_fraction", "second_stick_fraction"})
        step[fraction] = whole > 0. ? largest / whole : 0.;
      return step;
    }

    /** Given shares of the speed of the crests (rad/s), if a torque is given, and of the loss. */
    PointError shares(const CurvePoint &point, const double crest_speed, const double of_speed,
                      const double of_loss)
    {
      PointError error;
      error["friction_loss"] = of_loss * point.result.friction_loss();
      if (point.request.control == Control::torque)
        error["speed"] = of_speed * crest_speed;
      return error;
    }

    /** What meshes of a level were found to be off by where they agree with the next coarser one by
     * chance, see accuracy_and_cost.md: the coarsest ones are far from the regime of convergence,
     * only from level 3 on a change shows the division around the teeth, and the share of sticking
     * nodes changes with every layer of cells. */
    PointError least_mesh_error(const unsigned int level, const CurvePoint &point,
                                const double crest_speed)
    {
      constexpr std::array<double, ContactDiscretisation::finest_level + 1> of_speed{
          {5e-3, 5e-3, 2.5e-3, 0., 0.}},
          of_loss{{2e-2, 2e-2, 1e-2, 0., 0.}};
      PointError least        = shares(point, crest_speed, of_speed[level], of_loss[level]);
      least["stick_fraction"] = 0.06;
      return least;
    }

    /** What modes of a level were found to be off by where neither a coarser mesh nor other
     * harmonics change the result, by chance, see effects.md; less where damping limits their
     * resonances. */
    PointError least_modes_error(const CurvePoint &point, const CondensedMotor &motor,
                                 const double crest_speed)
    {
      constexpr std::array<double, RotorVibration::finest_level + 1> of_speed{
          {1e-2, 1e-2, 8e-3, 4e-3}},
          of_loss{{5e-2, 3e-2, 1.5e-2, 7e-3}};
      constexpr double with_loss_factor = 1e-3;
      const double sharpness =
          with_loss_factor / std::max(with_loss_factor, motor.dynamics.loss_factor);
      return shares(point, crest_speed, sharpness * of_speed[motor.modes_level],
                    sharpness * of_loss[motor.modes_level]);
    }

    /** A wave gives about the same power to other modes: what less speed or torque leaves of it is
     * lost in friction. */
    PointError least_of_power(const CurvePoint &point, const PointError &error)
    {
      PointError least;
      least["friction_loss"] = std::abs(point.result.torque) * error["speed"] +
                               std::abs(point.result.speed) * error["torque"];
      return least;
    }

  } // namespace

  PointError CurveSearch::mesh_error(const unsigned int request)
  {
    const CurvePoint &point          = point_of(steps.plain(reached_level), request);
    const unsigned int coarser_level = compared_with(reached_level);
    const CurvePoint &coarser        = point_of(steps.plain(coarser_level), request);
    PointError error                 = change(coarser, point);
    const bool is_coarse             = coarser_level == 0 || coarser_level > reached_level;
    // From level 1 on, each step of the sequence divides errors by about four: what remains is a
    // third of the last change, seldom three quarters of it, and the last change is a quarter of
    // the one before unless it happens to be small. With inertia impacts scatter on every mesh.
    const double margin = is_coarse ? 2. : has_inertia ? 1.25 : 0.75, ratio = has_inertia ? 3. : 4.;
    error *= margin;
    const auto before = is_coarse ? known.end() : known.find(steps.plain(coarser_level - 1));
    if (before != known.end() && before->second.count(request) > 0)
    {
      error.raise(margin / ratio * change(before->second.at(request), coarser));
    }
    error.raise(least_mesh_error(reached_level, point, crest_speed(point.result.amplitude)));
    return error;
  }

  namespace
  {
    /** The share of the dissipation of a scheme in its change to dissipating_otherwise(). */
    double share_of_change(const InertiaScheme &scheme)
    {
      constexpr double margin = 2., phase = 0.1; // rad in a step
      const auto dissipation = [&](const InertiaScheme &of)
      { return (1. / of.response(std::polar(1., phase), phase, 1., 0.)).imag(); };
      const double own = dissipation(scheme), other = dissipation(scheme.dissipating_otherwise());
      return std::min(1., margin * own / std::abs(other - own));
    }
  } // namespace

  std::map<std::string, PointError> CurveSearch::errors_of(const unsigned int request)
  {
    const CurveSetting own{reached_level, n_parts[request]}, other = compared_step(request),
                                                             plain = steps.plain(reached_level);
    const CurvePoint &point                                        = point_of(own, request),
                     &unchanged = point_of(unchanged_motor(), request);
    const double crests         = crest_speed(point.result.amplitude);
    std::map<std::string, PointError> errors;
    for (const char *const cause : causes::all)
      errors[cause] = {};
    errors[causes::meshes] = mesh_error(request);
    // First order, C / n with n steps per pitch: C follows from two values of n.
    PointError &time = errors[causes::time_step] = other.n_steps() /
                                                   std::abs(other.n_steps() - own.n_steps()) *
                                                   change(point, point_of(other, request));
    time.raise(resolution(point, motor()));
    PointError missing;
    missing["friction_loss"] = std::abs(point.result.missing_power());
    time.raise(missing);
    if (motor().has_modes())
    {
      // From level to level the errors of the meshes are at most halved; those of the harmonics
      // left out decrease with the square of their number, which is multiplied by one and a half.
      constexpr double of_mesh = 0.6, of_harmonics = 1.8;
      const CurvePoint &coarse = point_of(with_modes(ModesInUse::coarse), request);
      PointError &modes        = errors[causes::modes] =
          of_mesh * change(unchanged, coarse) +
          of_harmonics *
              change(coarse, point_of(with_modes(ModesInUse::of_other_harmonics), request));
      if (motor().has_rotor_modes() && !motor().dynamics.is_hysteretic)
        modes.raise(least_modes_error(point, motor(), crests));
      modes.raise(least_of_power(point, modes));
    }
    if (has_inertia) // The dissipation decreases with the third power of the step; quadratically,
                     // to be safe.
      errors[causes::scheme] = share_of_change(motor().dynamics.scheme) *
                               std::pow(plain.n_steps() / own.n_steps(), 2) *
                               change(unchanged, point_of(other_scheme(), request));
    errors[causes::wave] = change(unchanged, point_of(changed_wave(), request));
    if (is_driven())
      errors[causes::drive] = change(unchanged, point_of(other_drive(), request));
    // What a window given by the user misses does not depend on the steps.
    errors[causes::window] =
        parameters.time.n_steps ? point_of(plain, request).window : point.window;
    errors[causes::effects] = left_out.of(point);
    PointError &algebra     = errors[causes::algebra] =
        point.largest_violation * sizes_of(point) + point.unsettled;
    if (!is_driven())
      algebra["amplitude"] = 0.; // it is given
    return errors;
  }

  CurveSetting CurveSearch::unchanged_motor() const
  {
    // What another wave, scheme or other modes change depends little on the mesh.
    const bool has_coarser = reached_level > 1;
    return steps.plain(has_coarser ? compared_with(reached_level) : reached_level);
  }

  CurveSetting CurveSearch::changed_wave() const
  {
    CurveSetting setting = unchanged_motor();
    setting.wave_factor  = 1. + wave_error;
    return setting;
  }

  CurveSetting CurveSearch::compared_step(const unsigned int request) const
  {
    const CurveSetting plain = steps.plain(reached_level);
    if (!(plain == CurveSetting{reached_level, n_parts[request]}))
      return plain;
    // Longer steps are cheap, but where a step is undivided they may miss the contact of a tooth.
    return plain.n_parts % 2 == 0 ? plain.doubled() : plain.halved();
  }

  CurveSetting CurveSearch::with_modes(const ModesInUse modes) const
  {
    CurveSetting setting = unchanged_motor();
    setting.modes        = modes;
    return setting;
  }

  CurveSetting CurveSearch::other_scheme() const
  {
    CurveSetting setting     = unchanged_motor();
    setting.has_other_scheme = true;
    return setting;
  }

  CurveSetting CurveSearch::other_drive() const
  {
    CurveSetting setting    = unchanged_motor();
    setting.has_drive_error = true;
    return setting;
  }

  std::vector<CurveSetting> CurveSearch::changed_motors() const
  {
    std::vector<CurveSetting> settings{changed_wave()};
    if (motor().has_modes())
      for (const ModesInUse modes : {ModesInUse::coarse, ModesInUse::of_other_harmonics})
        settings.push_back(with_modes(modes));
    if (has_inertia)
      settings.push_back(other_scheme());
    if (is_driven())
      settings.push_back(other_drive());
    return settings;
  }

  double CurveSearch::worst_error() const
  {
    double worst = 0.;
    for (const CurvePoint &point : points())
      worst = std::max(worst, relative(point.error()));
    return worst;
  }

  QuantityScales CurveSearch::scales() const
  {
    return {crest_speed(largest_amplitude), borne_torque(), stall_torque};
  }

  double CurveSearch::relative(const PointError &error) const
  {
    const Accuracy &accuracy    = parameters.accuracy;
    const QuantityScales scales = this->scales();
    double worst                = 0.;
    for (const QuantityTarget &held : accuracy.quantities)
      if (const double value = error[held.quantity]; value > 0.)
      {
        double largest = 0.;
        for (const auto &[request, point] : known.at(steps.plain(reached_level)))
          largest = std::max(largest, std::abs(quantity_named(held.quantity).value(point)));
        worst = std::max(worst, value / scales.of(held.quantity, largest) *
                                    accuracy.contact_target / accuracy.target_of(held));
      }
    return worst;
  }
} // namespace ringmotor
