// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/wave/motor_wave.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    const std::string tangential_ratio = "A_t/A_n";

    /** The quantities of the shape on this mesh, still without error bars. */
    std::vector<Quantity> shape_of(const WaveResult &wave)
    {
      const auto motion = [&](const std::string &name)
      {
        return std::find_if(wave.points.begin(), wave.points.end(),
                            [&](const PointResult &result) { return result.point.name == name; })
            ->motion;
      };
      const EllipticMotion center                        = motion("top_outer_C");
      const std::map<types::material_id, double> &strain = wave.energy.strain;
      std::vector<Quantity> shape{
          {tangential_ratio, units::one, center.tangential / center.normal},
          {"A_r/A_n", units::one, center.radial_along_normal() / center.normal},
          {"phi_edge", units::degree, motion("top_outer_R").phi * 180. / numbers::PI},
          {"modal_mass", units::kilogram, wave.modal_mass},
          {"strain_energy", units::joule, wave.energy.total_strain},
          {"strain_energy_base", units::joule, strain.at(ids::base)},
          {"strain_energy_tooth", units::joule, strain.at(ids::tooth)},
          {"strain_energy_piezoceramic", units::joule, strain.at(ids::piezoceramic)}};
      if (wave.energy.electric > 0.)
        shape.push_back({"electric_energy", units::joule, wave.energy.electric});
      return shape;
    }
  } // namespace

  std::vector<Quantity> quantities_of(const PointResult &result)
  {
    const Point<3> &x            = result.point.position;
    const EllipticMotion &motion = result.motion;
    return {{"r", units::length, std::hypot(x[0], x[1])},
            {"theta", units::angle, std::atan2(x[1], x[0])},
            {"z", units::length, x[2]},
            {"A_n", units::amplitude, motion.normal},
            {"A_t", units::amplitude, motion.tangential},
            {"A_r", units::amplitude, motion.radial},
            {"phase_n", units::angle, motion.phase_n},
            {"phi", units::angle, motion.phi},
            {"phase_r", units::angle, motion.phase_r}};
  }

  double WaveResult::relative_error() const
  {
    for (const Quantity &number : shape)
      if (number.name == tangential_ratio)
        return found.frequency.relative_error() + number.estimate.relative_error();
    return std::numeric_limits<double>::infinity();
  }

  MotorWave::MotorWave(const unsigned int n_waves, const Wave &request)
      : n_waves(n_waves), request(request)
  {
  }

  void MotorWave::add_pass(const ModeSearch &search)
  {
    wave.reset();
    const FoundMode *working = search.working_mode(n_waves);
    if (working == nullptr)
      return;
    const std::vector<ToothPoint> points = tooth_points(search.sector());
    if (points.empty())
      return;
    wave = make_result(search, *working, points);
    const Sample now{shape_of(*wave), working->samples.back()};
    if (earlier)
    {
      for (unsigned int i = 0; i < now.shape.size(); ++i)
        wave->shape.emplace_back(now.shape[i].name, now.shape[i].unit,
                                 shape_estimate(now.shape[i].value(), earlier->shape[i].value(),
                                                now.frequency, earlier->frequency,
                                                working->frequency.relative_error()));
    }
    earlier = now;
  }

  WaveResult MotorWave::make_result(const ModeSearch &search, const FoundMode &working,
                                    const std::vector<ToothPoint> &points) const
  {
    WaveResult result;
    result.found     = working;
    result.amplitude = request.amplitude;
    result.angular_frequency =
        2. * numbers::PI * request.frequency.value_or(working.frequency.value);
    normalise_to_amplitude(result.found.mode, points, result.amplitude);
    for (const ToothPoint &point : points)
      result.points.push_back({point, elliptic_motion(point, result.found.mode)});
    result.energy     = wave_energy(search.sector(), result.found.mode);
    result.modal_mass = modal_mass(result.energy, result.found.mode, result.amplitude);
    for (const FoundMode &other : search.modes())
      if (other.mode.nodal_diameter == working.mode.nodal_diameter)
      {
        const double gap = other.frequency.value / working.frequency.value - 1.;
        double &nearest  = gap > 0. ? result.gap_above : result.gap_below;
        if (gap != 0. && (nearest == 0. || std::abs(gap) < nearest))
          nearest = std::abs(gap);
      }
    return result;
  }
} // namespace ringmotor
