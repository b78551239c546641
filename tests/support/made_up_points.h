// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "support/paper_motor.h"

#include <gtest/gtest.h>

#include <ringmotor/points/curve_search.h>
#include <ringmotor/points/point_quantities.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ringmotor::tests
{
  inline constexpr double period = 1e-5 * dealii::numbers::PI; // s, of the synthetic wave

  /** Synthetic points: speeds w0 - T with a mesh error a / 4^level, a time step error b/n for n
   * parts, and an error in proportion to the wave; powers balance with four parts. */
  class MadeUpPoints : public PointSource
  {
  public:
    using Change =
        std::function<void(CurvePoint &, const Discretisation &, const CondensedMotor &)>;
    MadeUpPoints(const double a, const double b, const Change &change = {})
        : a(a), b(b), change(change)
    {
    }

    std::vector<TimedMotor> motors(const std::vector<unsigned int> &levels,
                                   const unsigned int modes_level) override
    {
      CondensedMotor motor;
      motor.n_teeth                = 90;
      motor.n_waves                = 7;
      motor.wave.angular_frequency = 2. * dealii::numbers::PI / period;
      motor.wave.amplitude         = 2e-6;
      motor.wave.free_motion.resize(4);
      motor.nodes  = {{1., 0., 1.}, {2., 0., 1.}, {1., 0.1, 1.}, {2., 0.1, 1.}};
      motor.faces  = {{0, 1, 2, 3}};
      motor.degree = 1;
      if (vibrates)
        motor.modes = {{{1e5, {}}}};
      motor.modes_level = modes_level;
      std::vector<TimedMotor> motors(levels.size(), {motor, 0.});
      for (std::size_t i = 0; i < levels.size(); ++i)
        if (levels[i] > 0) // two faces instead of one
        {
          motors[i].motor.nodes.insert(motors[i].motor.nodes.end(), {{3., 0., 1.}, {3., 0.1, 1.}});
          motors[i].motor.faces.push_back({1, 4, 3, 5});
          motors[i].motor.wave.free_motion.resize(6);
        }
      return motors;
    }

    std::vector<std::vector<CurvePoint>> points(const std::vector<PointSet> &sets) override
    {
      std::vector<std::vector<CurvePoint>> all;
      for (const PointSet &set : sets)
      {
        for (const CurvePoint &start : set.starts)
        {
          const std::size_t n_known = start.fields.state.force.size();
          EXPECT_TRUE(n_known == 0 || n_known == set.motor.nodes.size())
              << set.discretisation.text() << " starts on another mesh";
        }
        all.push_back(points_of(set.discretisation, set.motor, set.requests));
      }
      return all;
    }

    std::vector<CurvePoint> points_of(const Discretisation &discretisation,
                                      const CondensedMotor &motor,
                                      const std::vector<PointRequest> &requests) const
    {
      const Steps &steps     = discretisation.steps;
      const bool larger_wave = variation_of(discretisation) == "larger wave";
      std::vector<CurvePoint> points;
      for (const PointRequest &request : requests)
      {
        CurvePoint point;
        point.request        = request;
        const bool of_torque = request.control == Control::torque;
        point.result.torque  = of_torque ? request.value : 8.;
        const double exact   = (8. - point.result.torque) * (larger_wave ? 1. + wave_error : 1.);
        point.result.speed =
            of_torque
                ? exact + a * std::pow(0.25, discretisation.level) * (1. + point.result.torque) +
                      b / steps.number()
                : request.value;
        point.result.amplitude       = 2e-6;
        point.result.input_power     = 1.;
        point.result.gross_power     = 1.;
        point.result.output_work     = 0.5;
        point.result.tangential_loss = steps.n_parts < 4 ? 0.49 : 0.5;
        point.fields.time_step       = 1e-7;
        point.fields.state.force.resize(motor.nodes.size());
        point.fields.motion.resize(motor.nodes.size());
        point.fields.status.resize(motor.nodes.size(), PointStatus::open);
        point.result.teeth_in_contact = 3.;
        if (change)
          change(point, discretisation, motor);
        points.push_back(point);
      }
      return points;
    }

    static std::string variation_of(const Discretisation &discretisation)
    {
      return discretisation.variation ? discretisation.variation->name : "";
    }

    static constexpr double wave_error = 1e-3;
    bool vibrates                      = false;

  private:
    const double a, b;
    const Change change;
  };

  /** A search for listed torques. */
  class Search
  {
  public:
    Search(const std::vector<double> &torques, const double target, MadeUpPoints source)
        : source(std::move(source))
    {
      parameters                         = paper_motor();
      parameters.loading.values          = torques;
      parameters.loading.control         = Control::torque;
      parameters.initial_deformation     = {};
      parameters.accuracy.contact_target = target;
    }

    const CurveSearch &find()
    {
      StatorWave wave;
      wave.angular_frequency = 2. * dealii::numbers::PI / period;
      wave.relative_error    = MadeUpPoints::wave_error;
      search                 = std::make_unique<CurveSearch>(parameters, wave, source, progress);
      search->find();
      return *search;
    }

    Parameters parameters;
    MadeUpPoints source;

  private:
    Progress progress;
    std::unique_ptr<CurveSearch> search;
  };
} // namespace ringmotor::tests
