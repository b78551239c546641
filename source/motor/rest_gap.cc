// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/rest_gap.h>
#include <ringmotor/parameters/parameters.h>

#include <algorithm>
#include <array>
#include <complex>
#include <limits>
#include <numeric>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    void subtract_mean(std::vector<double> &values, const std::vector<double> &weights)
    {
      const double mean = std::inner_product(values.begin(), values.end(), weights.begin(), 0.);
      for (double &value : values)
        value -= mean;
    }

    /** Adds the normal motions at rest by modes that the static compliance does not contain, under
     * normal forces that are the same on all sectors. */
    void add_modes_at_rest(const std::vector<RingMode> &modes, const std::vector<double> &forces,
                           std::vector<double> &motion)
    {
      for (const RingMode &mode : modes)
      {
        std::complex<double> force = 0.;
        for (std::size_t a = 0; a < forces.size(); ++a)
          force += std::conj(mode.motion[a][0]) * forces[a];
        const double sign = (mode.response == ModeResponse::none ? 0. : 1.) - mode.at_once();
        for (std::size_t a = 0; a < forces.size(); ++a)
          motion[a] += sign * (mode.motion[a][0] * force).real() /
                       (mode.angular_frequency * mode.angular_frequency);
      }
    }
  } // namespace

  double RestGap::unevenness(const double preload) const
  {
    double least = std::numeric_limits<double>::max(), most = -least;
    for (std::size_t a = 0; a < drawn.size(); ++a)
    {
      const double distance = at(a, preload) + preload * deflection[a];
      least                 = std::min(least, distance);
      most                  = std::max(most, distance);
    }
    return most - least;
  }

  RestGap rest_gap(const Parameters &parameters, const CondensedMotor &motor)
  {
    const std::size_t n_nodes  = motor.nodes.size();
    const FaceProfile of_rotor = rotor_shape(parameters)->profile(),
                      of_teeth = stator_shape(parameters)->profile();
    RestGap gap;
    gap.is_lapped = parameters.contact.faces == ContactFaces::lapped;
    std::vector<double> shares; // of the area of a tooth
    for (const CondensedMotor::Node &node : motor.nodes)
    {
      gap.drawn.push_back(of_rotor.height(node.radius) - of_teeth.height(node.radius));
      shares.push_back(node.area);
    }
    const double area = std::accumulate(shares.begin(), shares.end(), 0.);
    for (double &share : shares)
      share /= area;

    std::vector<double> forces(3 * n_nodes * motor.n_teeth, 0.), motions(forces.size(), 0.),
        on_tooth;
    for (std::size_t a = 0; a < n_nodes; ++a)
      on_tooth.push_back(shares[a] / motor.n_teeth);
    for (std::size_t i = 0; i < n_nodes * motor.n_teeth; ++i)
      forces[3 * i] = on_tooth[i % n_nodes];
    motor.compliance.add_motions(forces.data(), motions.data());
    for (std::size_t a = 0; a < n_nodes; ++a)
      gap.deflection.push_back(motions[3 * a]);
    if (motor.has_modes())
      add_modes_at_rest(motor.modes[0], on_tooth, gap.deflection);
    subtract_mean(gap.drawn, shares);
    subtract_mean(gap.deflection, shares);
    return gap;
  }

  RestGap rough_rest_gap(Parameters parameters)
  {
    for (const std::string name :
         {"Rotor inertia", "Tooth vibration", "Damping", "Stator compliance"})
      parameters.effects[name] = EffectChoice::off;
    StatorWave at_rest;
    at_rest.n_waves           = parameters.motor.n_waves;
    at_rest.angular_frequency = 1.; // any
    at_rest.foot = at_rest.top = [](const dealii::Point<3> &)
    { return std::array<std::complex<double>, 3>(); };
    return condense_motor(parameters, at_rest, ContactDiscretisation::level(0)).gap;
  }

  std::string describe_faces(const RestGap &gap, const Parameters &parameters)
  {
    const double uneven = gap.unevenness(parameters.loading.preload);
    std::ostringstream text;
    text.precision(2);
    text << "under the preload, spread evenly, the faces in contact are " << 1e6 * uneven
         << " um from parallel";
    const bool touch_with_edge = !gap.is_lapped && uneven > parameters.wave.amplitude;
    if (touch_with_edge)
      text << ", more than the amplitude of the wave, " << 1e6 * parameters.wave.amplitude
           << " um: they touch with an edge; motors are made with Contact/Faces = lapped, or with "
              "faces drawn to fit";
    return (touch_with_edge ? "warning: " : "") + text.str();
  }
} // namespace ringmotor
