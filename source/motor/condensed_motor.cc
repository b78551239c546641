// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/condensed_bodies.h>
#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/contained_modes.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/motor/tooth_modes.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** Compliance (m/N) of the springs at a node between tooth and rotor: those of the penalty
     * method, which are the same at all nodes, and those of a lining, by area. */
    double spring_compliance(const Parameters &parameters, const MotorModel &model,
                             const unsigned int component, const double area)
    {
      const bool normal = component == 0;
      double compliance = 0.;
      if (parameters.contact.formulation == ContactFormulation::penalty)
        compliance += 1. / (normal ? *parameters.contact.normal_penalty
                                   : *parameters.contact.tangential_penalty);
      return compliance +
             (normal ? model.lining_normal_compliance : model.lining_tangential_compliance) / area;
    }

    /** Adds the contact points, the compliance of the teeth and that of springs between teeth and
     * rotor to the motor. */
    void add_teeth(CondensedMotor &motor, const CondensedTooth &tooth, const MortarCoupling &mortar,
                   const Parameters &parameters, const MotorModel &model)
    {
      const unsigned int n = mortar.nodes.size();
      std::vector<unsigned int> point_of(tooth.surface.surface.nodes.size(),
                                         numbers::invalid_unsigned_int);
      motor.tooth_compliance.reinit(3 * n, 3 * n);
      FullMatrix<double> between(3 * n, 3 * n);
      for (unsigned int a = 0; a < n; ++a)
      {
        const unsigned int i = mortar.nodes[a].tooth_node;
        point_of[i]          = a;
        motor.nodes.push_back({tooth.surface.surface.nodes[i].place[0],
                               tooth.surface.surface.nodes[i].place[1], mortar.nodes[a].area});
        motor.wave.free_motion.push_back(tooth.free_motion[i]);
        if (model.teeth_give_way)
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < 3; ++d)
                motor.tooth_compliance(3 * a + c, 3 * b + d) =
                    tooth.compliance(3 * i + c, 3 * mortar.nodes[b].tooth_node + d);
        for (unsigned int c = 0; c < 3; ++c)
          between(3 * a + c, 3 * a + c) =
              spring_compliance(parameters, model, c, mortar.nodes[a].area);
      }
      motor.compliance.add_within_sectors(motor.tooth_compliance);
      motor.compliance.add_within_sectors(between);
      for (const std::vector<unsigned int> &face : tooth.surface.surface.faces)
      {
        std::vector<unsigned int> points;
        for (const unsigned int node : face)
          points.push_back(point_of[node]);
        if (std::find(points.begin(), points.end(), numbers::invalid_unsigned_int) == points.end())
          motor.faces.push_back(points);
      }
    }

    /** The inverse of the median normal compliance of the contact points, and of the largest
     * eigenvalue of the tangential compliance of a tooth. */
    ComplementarityConstants constants_for(const RingCompliance &compliance)
    {
      const unsigned int n = compliance.n_nodes();
      std::vector<double> normal;
      FullMatrix<double> of_node(3, 3);
      for (unsigned int a = 0; a < n; ++a)
      {
        of_node = 0.;
        compliance.add_entries(0, {a}, {a}, 1., 0, of_node, 0, 0);
        normal.push_back(of_node(0, 0));
      }
      std::nth_element(normal.begin(), normal.begin() + n / 2, normal.end());

      const std::size_t n_all = 3 * n * compliance.n_sectors();
      std::vector<double> force(n_all, 0.), motion;
      double eigenvalue = std::sqrt(2. * n);
      motion.assign(3 * n, 1.);
      for (unsigned int step = 0; step < 50; ++step) // only its magnitude matters
      {
        for (unsigned int i = 0; i < 3 * n; ++i)
          force[i] = i % 3 == 0 ? 0. : motion[i] / eigenvalue;
        motion.assign(n_all, 0.);
        compliance.add_motions(force.data(), motion.data());
        double square = 0.;
        for (unsigned int i = 0; i < 3 * n; ++i)
          square += i % 3 == 0 ? 0. : motion[i] * motion[i];
        eigenvalue = std::sqrt(square);
      }
      return {1. / normal[n / 2], 1. / eigenvalue};
    }
  } // namespace

  unsigned int CondensedMotor::n_repeats() const
  {
    return std::gcd(n_waves, n_teeth);
  }

  bool CondensedMotor::has_modes_of(const ModePart part) const
  {
    return std::any_of(modes.begin(), modes.end(),
                       [&](const std::vector<RingMode> &of_diameter)
                       {
                         return std::any_of(of_diameter.begin(), of_diameter.end(),
                                            [&](const RingMode &mode)
                                            { return mode.part == part; });
                       });
  }

  WaveAtNodes WaveAtNodes::at(const double other_amplitude, const double other_frequency) const
  {
    const double factor = other_amplitude == amplitude ? 1. : other_amplitude / amplitude;
    WaveAtNodes other{other_amplitude, other_frequency, factor * factor * energy, free_motion};
    for (std::array<Complex, 3> &motion : other.free_motion)
      for (Complex &component : motion)
        component *= factor;
    return other;
  }

  double WaveAtNodes::period() const
  {
    return 2. * numbers::PI / angular_frequency;
  }

  double CondensedMotor::crest_speed(const WaveAtNodes &of_wave) const
  {
    double fastest = 0.;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      fastest = std::max(fastest, of_wave.angular_frequency * std::abs(of_wave.free_motion[i][1]) /
                                      nodes[i].radius);
    return fastest;
  }

  double CondensedMotor::pitch() const
  {
    return 2. * numbers::PI / n_teeth;
  }

  namespace
  {
    /** Adds the modes of its bodies to a motor, whose static compliance must be known. */
    void add_modes(CondensedMotor &motor, const SectorSurface &tooth_top,
                   const MortarCoupling &mortar, const ContactDiscretisation &discretisation,
                   const Parameters &parameters, const MotorModel &model,
                   const unsigned int modes_level, const MotorVibration &vibration,
                   const ModeSets sets)
    {
      const auto modes_at = [&](const VibrationSetting &setting)
      {
        RingModes modes(motor.n_teeth / 2 + 1);
        if (model.rotor_needs_modes())
          modes = vibration.rotor.at(setting, tooth_top.surface, discretisation.lip_turn);
        RingModes of_stator(modes.size());
        if (model.stator_gives_way)
          of_stator = vibration.stator.modes(setting).at(tooth_top.surface, mortar);
        for (unsigned int k = 0; k < modes.size(); ++k)
          modes[k].insert(modes[k].end(), of_stator[k].begin(), of_stator[k].end());
        if (!model.teeth_vibrate)
          return modes;
        const std::vector<RingMode> of_tooth = tooth_modes(
            parameters, setting.mesh, setting.n_harmonics * motor.wave.angular_frequency,
            tooth_top.surface, mortar);
        const auto excited = harmonics_by_diameter(parameters.motor, setting.n_harmonics);
        for (unsigned int k = 0; k < modes.size(); ++k)
          if (of_stator[k].empty() && (model.rotor_moves_as_whole || excited.count(k) > 0))
            modes[k].insert(modes[k].end(), of_tooth.begin(), of_tooth.end());
        return modes;
      };
      motor.dynamics = {model.rotor_loss_factor > 0. ? vibration.rotor.loss_factor() : 0.,
                        InertiaScheme::second_order(parameters.time.spectral_radius),
                        model.rotor_needs_modes() && !model.rotor_vibrates};
      motor.modes_level = modes_level;
      motor.modes       = modes_at(vibration.rotor.setting(modes_level));
      if (sets == ModeSets::with_compared)
      {
        motor.coarse_modes             = modes_at(vibration.rotor.on_coarser_mesh(modes_level));
        motor.modes_of_other_harmonics = modes_at(vibration.rotor.of_other_harmonics(modes_level));
      }
      contain_modes({&motor.modes, &motor.coarse_modes, &motor.modes_of_other_harmonics},
                    motor.compliance, motor.dynamics);
    }
  } // namespace

  CondensedMotor condense_motor(const Parameters &all_parameters, const StatorWave &wave,
                                const ContactDiscretisation &discretisation,
                                const std::optional<unsigned int> &modes_level,
                                const MotorVibration *vibration, const ModeSets sets)
  {
    const Parameters parameters = relevant_for_condensation(all_parameters);
    const MotorModel model      = motor_model(parameters);
    const BodiesByMesh not_kept;
    const auto bodies =
        (vibration ? vibration->bodies : not_kept).at(parameters, wave, discretisation);
    const CondensedTooth &tooth = bodies->tooth;
    const CondensedRotor &rotor = bodies->rotor;
    CondensedMotor motor;
    motor.n_teeth                = parameters.motor.n_teeth;
    motor.n_waves                = wave.n_waves;
    motor.wave.amplitude         = wave.amplitude;
    motor.wave.angular_frequency = wave.angular_frequency;
    motor.wave.energy            = wave.strain_energy;
    motor.near_rigid_modes       = rotor.near_rigid_modes;
    motor.rotor_mass             = rotor.mass;
    motor.compliance             = rotor.compliance;
    motor.degree                 = discretisation.degree;
    motor.n_dofs                 = tooth.n_dofs + rotor.n_dofs;
    add_teeth(motor, tooth, rotor.mortar, parameters, model);
    if (motor.compliance.is_small())
      motor.compliance.tabulate();
    if (motor.n_repeats() > 1)
      motor.folded = motor.compliance.folded(motor.n_repeats());
    motor.constants = constants_for(motor.compliance);
    if (model.needs_modes())
      add_modes(motor, tooth.surface, rotor.mortar, discretisation, parameters, model,
                modes_level.value_or(RotorVibration::usual_level),
                vibration ? *vibration : MotorVibration(parameters, wave), sets);
    motor.gap = rest_gap(parameters, motor);
    return motor;
  }

  void MotorInUse::leave_modes_of_stator_alone()
  {
    RingModes left(modes->size());
    for (std::size_t k = 0; k < modes->size(); ++k)
      std::copy_if((*modes)[k].begin(), (*modes)[k].end(), std::back_inserter(left[k]),
                   [](const RingMode &mode) { return mode.part == ModePart::stator; });
    if (std::all_of(left.begin(), left.end(), [](const auto &of_k) { return of_k.empty(); }))
      left.clear();
    own_modes = std::make_shared<const RingModes>(std::move(left));
    modes     = own_modes.get();
  }
} // namespace ringmotor
