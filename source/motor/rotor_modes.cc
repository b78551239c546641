// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/response_modes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** The harmonics of the wave by their nodal diameter, without those in which the rotor moves as
     * a whole. */
    std::map<unsigned int, std::vector<unsigned int>> harmonics(const Motor &motor,
                                                                const unsigned int n_harmonics)
    {
      std::map<unsigned int, std::vector<unsigned int>> by_diameter;
      for (unsigned int m = 1; m <= n_harmonics; ++m)
        if (const unsigned int k = nodal_diameter_of_harmonic(motor, m); k > 1)
          by_diameter[k].push_back(m);
      return by_diameter;
    }

    /** Loads on a half sector's lip with the symmetry of its motions, that span smooth forces on
     * the teeth: polynomials across the lip and around it that vanish between the teeth. */
    std::vector<std::vector<double>> lip_loads(const RotorBody &body, const unsigned int k)
    {
      constexpr unsigned int degree_across = 1, degree_around = 4;
      double inner = std::numeric_limits<double>::max(), outer = 0., end = 0.;
      for (const SurfaceNode &node : body.lip.nodes)
      {
        inner = std::min(inner, node.place[0]);
        outer = std::max(outer, node.place[0]);
        end   = std::max(end, node.place[1]);
      }
      std::vector<std::vector<double>> loads;
      for (const unsigned int component : {0u, 1u, 2u})
        for (unsigned int i = 0; i <= degree_across; ++i)
          for (unsigned int j = 0; j <= degree_around; ++j)
          {
            // U(-theta) = S conj(U(theta)), where S reverses the component along -theta
            const unsigned int part = (component == 1 ? j + 1 : j) % 2;
            std::array<Vector<double>, 2> fields{
                {Vector<double>(body.sector.n_dofs()), Vector<double>(body.sector.n_dofs())}};
            for (const SurfaceNode &node : body.lip.nodes)
            {
              const double across = (node.place[0] - inner) / (outer - inner),
                           around = node.place[1] / end,
                           force  = std::pow(across, i) * std::pow(around, j) * (1. - around * around);
              for (const auto &[dof, coefficient] : node.displacement[component])
                fields[part][dof] += force * coefficient;
            }
            loads.push_back(body.sector.loads_of(k, fields));
          }
      return loads;
    }
  } // namespace

  unsigned int nodal_diameter_of_harmonic(const Motor &motor, const unsigned int harmonic)
  {
    const unsigned int around = harmonic * motor.n_waves % motor.n_teeth;
    return std::min(around, motor.n_teeth - around);
  }

  std::vector<std::array<Complex, 3>> at_contact_points(const std::vector<double> &half,
                                                        const std::vector<MirroredNode> &origin,
                                                        const MortarCoupling &mortar,
                                                        const double turn)
  {
    const std::vector<std::array<Complex, 3>> rotor = sector_motion(half, origin);
    std::vector<std::array<Complex, 3>> motions;
    for (const MortarCoupling::Node &node : mortar.nodes)
    {
      std::array<Complex, 3> motion{};
      for (const MortarCoupling::Weight &weight : node.weights)
        for (unsigned int c = 0; c < 3; ++c)
          motion[c] +=
              weight.weight * std::polar(1., -weight.sector * turn) * rotor[weight.rotor_node][c];
      motions.push_back(motion);
    }
    return motions;
  }

  ContactDiscretisation LipModes::discretisation(const unsigned int level)
  {
    // Impacts excite resonances no wider than the loss factor, so frequencies have to be accurate.
    // On the flange modes of the reference motor, whose error is due to the singular edges where
    // flange and ring meet, it falls to less than 40 % from level to level.
    ContactDiscretisation discretisation;
    discretisation.lip   = {1, 1}; // modes move the lip smoothly
    discretisation.rotor = RotorGrading::level(level);
    if (level >= RotorVibration::usual_level)
    {
      discretisation.degree        = level + 1;
      discretisation.rotor.first   = 0.15;
      discretisation.rotor.ratio   = 0.15;
      discretisation.rotor.longest = 1.2;
    }
    return discretisation;
  }

  LipModes::LipModes(const Parameters &parameters, const unsigned int level, const double frequency,
                     const unsigned int n_harmonics)
      : n_teeth(parameters.motor.n_teeth), modes(n_teeth / 2 + 1)
  {
    const RotorBody body(parameters, discretisation(level));
    lip                                         = body.whole_lip;
    const std::vector<LinearForm> displacements = displacement_forms(body.lip);
    const MotorModel model                      = motor_model(parameters);
    const auto take                             = [&](const std::vector<Mode> &of_diameter)
    {
      for (const Mode &mode : of_diameter)
        modes[mode.nodal_diameter].push_back(
            {std::sqrt(mode.eigenvalue), on_surface(body.sector, displacements, mode)});
    };
    if (model.rotor_moves_as_whole)
    {
      const double up_to = 2. / 3. * n_harmonics * frequency;
      ModeSolver solver(body.sector);
      for (unsigned int k = 2; k < modes.size(); ++k)
        take(solver.below(k, std::pow(up_to, 2)));
    }
    else
    {
      ResponseModes responses(body.sector);
      for (const auto &[k, of_diameter] : harmonics(parameters.motor, n_harmonics))
      {
        std::vector<double> frequencies;
        for (const unsigned int harmonic : of_diameter)
          frequencies.push_back(harmonic * frequency);
        take(responses.at(k, lip_loads(body, k), frequencies));
      }
    }
    if (!model.rotor_gives_way_along)
      for (auto &of_diameter : modes)
        for (LipMode &mode : of_diameter)
          for (std::size_t i = 0; i < mode.motion.size(); ++i)
            if (i % 3 != 0)
              mode.motion[i] = 0.;
  }

  RingModes LipModes::at(const ContactSurface &tooth_top, const double lip_turn) const
  {
    const double pitch          = 2. * numbers::PI / n_teeth;
    const MortarCoupling mortar = couple(tooth_top, lip.surface, pitch, lip_turn);
    RingModes at_nodes(modes.size());
    for (unsigned int k = 0; k < modes.size(); ++k)
      for (const LipMode &mode : modes[k])
      {
        at_nodes[k].push_back({mode.angular_frequency,
                               at_contact_points(mode.motion, lip.origin, mortar, k * pitch)});
        for (std::array<Complex, 3> &motion : at_nodes[k].back().motion)
          for (Complex &component : motion)
            component *= std::sqrt(0.5); // two halves make a sector
      }
    return at_nodes;
  }

  RotorVibration::RotorVibration(const Parameters &parameters, const double frequency)
      : parameters(parameters), frequency(frequency)
  {
  }

  const LipModes &RotorVibration::level(const unsigned int level) const
  {
    constexpr std::array<unsigned int, finest_level + 1> n_harmonics{{9, 13, 20, 30}};
    if (!levels[level])
      levels[level] =
          std::make_shared<const LipModes>(parameters, level, frequency, n_harmonics[level]);
    return *levels[level];
  }
} // namespace ringmotor
