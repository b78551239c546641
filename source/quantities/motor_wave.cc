// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/quantities/motor_wave.h>

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

    /** The numbers of the shape on this mesh, yet without error bars. */
    std::vector<WaveResult::ShapeNumber> shape_of(const WaveResult &wave)
    {
      const auto motion = [&](const std::string &name)
      {
        return std::find_if(wave.points.begin(), wave.points.end(),
                            [&](const PointResult &result) { return result.point.name == name; })
            ->motion;
      };
      const EllipticMotion center = motion("top_outer_C");
      const auto strain           = [&](const unsigned int part) {
        return Estimate{wave.energy.strain.at(part), 0.};
      };
      return {{tangential_ratio, "1", {center.tangential / center.normal, 0.}},
              {"A_r/A_n", "1", {center.radial / center.normal, 0.}},
              {"phi_edge", "deg", {motion("top_outer_R").phi * 180. / numbers::PI, 0.}},
              {"modal_mass", "kg", {wave.modal_mass, 0.}},
              {"strain_energy", "J", {wave.energy.total_strain, 0.}},
              {"strain_energy_base", "J", strain(ids::base)},
              {"strain_energy_tooth", "J", strain(ids::tooth)},
              {"strain_energy_piezoceramic", "J", strain(ids::piezoceramic)}};
    }
  } // namespace

  double WaveResult::relative_error() const
  {
    for (const ShapeNumber &number : shape)
      if (number.name == tangential_ratio)
        return found.frequency.error / found.frequency.value +
               std::abs(number.estimate.error / number.estimate.value);
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
    wave = make_result(search, *working);
    const Sample now{shape_of(*wave), working->samples.back()};
    if (earlier)
    {
      wave->shape = now.shape;
      for (unsigned int i = 0; i < now.shape.size(); ++i)
        wave->shape[i].estimate = shape_estimate(
            now.shape[i].estimate.value, earlier->shape[i].estimate.value, now.frequency,
            earlier->frequency, working->frequency.error / working->frequency.value);
    }
    earlier = now;
  }

  WaveResult MotorWave::make_result(const ModeSearch &search, const FoundMode &working) const
  {
    const std::vector<ToothPoint> points = tooth_points(search.sector());
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
