// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/frequency_response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>

namespace ringmotor
{
  namespace
  {
    constexpr double two_pi = 2. * dealii::numbers::PI;

    /** Amplitudes over that of the resonance, closer where the frequency changes little. */
    constexpr std::array<double, 15> shares{
        {1., 0.99, 0.965, 0.93, 0.88, 0.82, 0.75, 0.67, 0.58, 0.49, 0.4, 0.31, 0.23, 0.16, 0.1}};

    /** Frequency (Hz), speed (rad/s), conductance and susceptance (S) of a wave with a given
     * amplitude, at one side of the resonance. */
    using Numbers = std::array<double, 4>;

    /** Those below and above it. @param speed rad/s, at the frequency of @p load */
    std::array<Numbers, 2> both_sides(const VoltageDrive &drive, const double speed,
                                      const WaveLoad &load)
    {
      const std::array<double, 2> frequencies = drive.frequencies(load);
      std::array<Numbers, 2> sides{};
      for (unsigned int side = 0; side < 2; ++side)
      {
        const double frequency                = frequencies[side];
        const std::complex<double> admittance = drive.motional_admittance(load, frequency);
        sides[side] = {{frequency / two_pi, speed * frequency / load.frequency, admittance.real(),
                        admittance.imag()}};
      }
      return sides;
    }

    /** The largest changes if each number of the drive changes by its error, added up. */
    std::array<Numbers, 2> errors_of_drive(const VoltageDrive &drive, const double speed,
                                           const WaveLoad &load)
    {
      const auto given = both_sides(drive, speed, load);
      std::array<Numbers, 2> errors{};
      for (Estimate VoltageDrive::*const number :
           {&VoltageDrive::force_factor, &VoltageDrive::modal_mass,
            &VoltageDrive::natural_frequency, &VoltageDrive::internal_loss})
      {
        std::array<Numbers, 2> largest{};
        for (const double sign : {-1., 1.})
        {
          VoltageDrive other = drive;
          (other.*number).value += sign * (drive.*number).error();
          const auto changed = both_sides(other, speed, load);
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int i = 0; i < given[side].size(); ++i)
              largest[side][i] =
                  std::max(largest[side][i], std::abs(changed[side][i] - given[side][i]));
        }
        for (unsigned int side = 0; side < 2; ++side)
          for (unsigned int i = 0; i < given[side].size(); ++i)
            errors[side][i] += largest[side][i];
      }
      return errors;
    }

    /** The same motor in several discretisations, the first one with results, the others to
     * estimate their errors. */
    class Estimator
    {
    public:
      Estimator(const Parameters &parameters, const VoltageDrive &drive, const CondensedMotor &fine,
                const CondensedMotor &coarse, const Discretisation &discretisation)
          : drive(drive), feels_contact(motor_model(parameters).wave_feels_contact),
            wave_frequency(fine.wave.angular_frequency),
            finders{{finder(parameters, fine, discretisation),
                     finder(parameters, coarse, discretisation),
                     finder(parameters, fine, discretisation.with(discretisation.steps.halved()))}}
      {
      }

      /** The states at an amplitude: below and above the resonance. */
      std::array<ResponsePoint, 2> at(const PointRequest &request, const double amplitude)
      {
        constexpr double margin = 2.;
        std::array<std::array<Numbers, 2>, 3> found{};
        std::array<Numbers, 2> errors{};
        for (unsigned int i = 0; i < finders.size(); ++i)
        {
          const CurvePoint point = finders[i]->find_at(request, amplitude);
          const WaveLoad load    = load_at(point);
          found[i]               = both_sides(drive, point.result.speed, load);
          if (i == 0)
            errors = errors_of_drive(drive, point.result.speed, load);
        }
        std::array<ResponsePoint, 2> points{};
        for (unsigned int side = 0; side < 2; ++side)
        {
          const auto estimate = [&](const unsigned int number)
          {
            const double value = found[0][side][number];
            const auto change  = [&](const unsigned int other)
            { return margin * std::abs(found[other][side][number] - value); };
            return Estimate(value, {{causes::wave, errors[side][number]},
                                    {causes::meshes, change(1)},
                                    {causes::time_step, change(2)}});
          };
          points[side] = {amplitude, estimate(0), estimate(1), estimate(2), estimate(3), false};
        }
        return points;
      }

      /** The amplitude that the drive sustains at the resonance. */
      double at_resonance(const PointRequest &request)
      {
        VoltageDrive following = drive;
        following.frequency.reset();
        return finders[0]->find_driven(request, following).result.amplitude;
      }

    private:
      /** At the frequency of the state. */
      WaveLoad load_at(const CurvePoint &point) const
      {
        return wave_load(point, drive,
                         wave_frequency * (feels_contact ? 1. + point.result.detuning : 1.));
      }

      static std::unique_ptr<OperatingPointFinder> finder(const Parameters &parameters,
                                                          const CondensedMotor &motor,
                                                          const Discretisation &discretisation)
      {
        return std::make_unique<OperatingPointFinder>(
            with_parts_of_a_step(parameters, discretisation.steps.n_parts), motor, discretisation);
      }

      const VoltageDrive &drive;
      const bool feels_contact;
      const double wave_frequency;
      const std::array<std::unique_ptr<OperatingPointFinder>, 3> finders;
    };
  } // namespace

  const ResponsePoint *FrequencyResponse::loses() const
  {
    for (std::size_t i = 1; i < points.size(); ++i)
      if (!points[i - 1].is_stable && points[i].is_stable)
        return &points[i];
    return nullptr;
  }

  const ResponsePoint *FrequencyResponse::regains() const
  {
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i - 1].is_stable && !points[i].is_stable)
        return &points[i - 1];
    return nullptr;
  }

  FrequencyResponse frequency_response(const Parameters &parameters, const VoltageDrive &drive,
                                       const CondensedMotor &fine, const CondensedMotor &coarse,
                                       const Discretisation &discretisation, const double torque)
  {
    const PointRequest request{Control::torque, torque};
    FrequencyResponse response{torque, {}, {}};
    Estimator estimator(parameters, drive, fine, coarse, discretisation);
    std::vector<ResponsePoint> above;
    try
    {
      const double largest = estimator.at_resonance(request);
      for (const double share : shares)
      {
        const std::array<ResponsePoint, 2> sides = estimator.at(request, share * largest);
        if (sides[0].speed.value <= 0.)
        {
          response.end = "the load stops the rotor";
          break;
        }
        response.points.push_back(sides[0]);
        above.push_back(sides[1]);
      }
    }
    catch (const ComputationError &error)
    {
      response.end = error.what();
    }

    std::reverse(response.points.begin(), response.points.end());
    response.points.insert(response.points.end(), above.begin(), above.end());
    for (std::size_t i = 0; i < response.points.size(); ++i)
    {
      const std::size_t before = i > 0 ? i - 1 : i,
                        after  = std::min(i + 1, response.points.size() - 1);
      response.points[i].is_stable =
          response.points[after].frequency.value > response.points[before].frequency.value;
    }
    return response;
  }
} // namespace ringmotor
