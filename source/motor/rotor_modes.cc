// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/motor/smooth_loads.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/response_modes.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
  } // namespace

  unsigned int nodal_diameter_of_harmonic(const Motor &motor, const unsigned int harmonic)
  {
    const unsigned int around = harmonic * motor.n_waves % motor.n_teeth;
    return std::min(around, motor.n_teeth - around);
  }

  std::map<unsigned int, std::vector<unsigned int>>
  harmonics_by_diameter(const Motor &motor, const unsigned int n_harmonics)
  {
    std::map<unsigned int, std::vector<unsigned int>> by_diameter;
    for (unsigned int m = 1; m <= n_harmonics; ++m)
      by_diameter[nodal_diameter_of_harmonic(motor, m)].push_back(m);
    return by_diameter;
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

  RotorModeSolver::RotorModeSolver(const Parameters &parameters, const unsigned int level,
                                   const double frequency, const unsigned int n_harmonics,
                                   const HarmonicRange &range, ModesByDiameter<Mode> *const kept)
      : body(parameters, LipModes::discretisation(level)), frequency(frequency),
        up_to(2. / 3. * n_harmonics * frequency), kept(kept)
  {
    const bool is_revolved = RevolvedSection::describes(body.sector);
    if (is_revolved)
      revolved.emplace(body.sector);
    if (motor_model(parameters).rotor_moves_as_whole)
    {
      any_frequency = true;
      if (!is_revolved)
        all.emplace(body.sector);
      for (unsigned int k = 2; 2 * k <= parameters.motor.n_teeth; ++k)
        excited[k];
      return;
    }
    if (!is_revolved)
      responses.emplace(body.sector);
    for (auto &[k, harmonics] : harmonics_by_diameter(parameters.motor, n_harmonics))
      if (k >= 2 && range.contains(harmonics.front()))
        excited[k] = std::move(harmonics);
  }

  std::vector<Mode> RotorModeSolver::modes(const unsigned int k)
  {
    if (!kept || any_frequency)
      return compute(k);
    const auto known = kept->find(*excited.find(k));
    return known == kept->end() ? kept->emplace(*excited.find(k), compute(k)).first->second
                                : known->second;
  }

  std::vector<Mode> RotorModeSolver::compute(const unsigned int k)
  {
    if (any_frequency)
      return revolved ? revolved->below(k, std::pow(up_to, 2)) : all->below(k, std::pow(up_to, 2));
    // Low harmonics have few vibrations below three times their own frequency.
    constexpr unsigned int least_harmonic      = 4;
    const std::vector<unsigned int> &harmonics = excited.at(k);
    std::vector<double> frequencies;
    for (const unsigned int harmonic : harmonics)
      frequencies.push_back(harmonic * frequency);
    const double highest = std::max(harmonics.back(), least_harmonic) * frequency;
    if (revolved)
      return revolved->responses(k, smooth_loads_in_section(body.lip, 1), frequencies, highest);
    return without_fast_vectors(
        responses->at(k, smooth_loads(body.sector, body.lip, k, {1, 4, /*vanish_at_cut =*/true}),
                      frequencies),
        highest);
  }

  LipModes::LipModes(const Parameters &parameters, const unsigned int level, const double frequency,
                     const unsigned int n_harmonics, const MPI_Comm communicator,
                     const HarmonicRange &range, Known *const known, const bool keeps_whole)
      : n_teeth(parameters.motor.n_teeth), modes(n_teeth / 2 + 1)
  {
    RotorModeSolver solver(parameters, level, frequency, n_harmonics, range,
                           known && keeps_whole ? &known->whole : nullptr);
    lip                        = solver.body.whole_lip;
    const bool gives_way_along = motor_model(parameters).rotor_gives_way_along;
    std::vector<unsigned int> missing;
    for (const auto &diameter : solver.diameters())
      if (known && known->on_lip.count(diameter) > 0)
        modes[diameter.first] = known->on_lip.at(diameter);
      else
        missing.push_back(diameter.first);
    const auto found = shared_work(
        missing,
        [&](const unsigned int k)
        {
          std::vector<LipMode> on_the_lip;
          for (const Mode &mode : solver.modes(k))
            on_the_lip.push_back(on_lip(solver.body, mode, gives_way_along));
          return on_the_lip;
        },
        communicator);
    for (std::size_t i = 0; i < missing.size(); ++i)
      modes[missing[i]] = found[i];
    if (known)
      for (const auto &diameter : solver.diameters())
        if (!diameter.second.empty())
          known->on_lip.emplace(diameter, modes[diameter.first]);
  }

  LipModes::LipMode LipModes::on_lip(const RotorBody &body, const Mode &mode,
                                     const bool gives_way_along)
  {
    LipMode of_lip{std::sqrt(mode.eigenvalue),
                   on_surface(body.sector, displacement_forms(body.lip), mode)};
    for (std::size_t i = 0; i < of_lip.motion.size(); ++i)
      if (i % 3 != 0 && !gives_way_along)
        of_lip.motion[i] = 0.;
    return of_lip;
  }

  RingMode LipModes::at_points(const LipMode &mode, const SectorSurface &lip,
                               const MortarCoupling &mortar, const double turn)
  {
    RingMode at_points{mode.angular_frequency,
                       at_contact_points(mode.motion, lip.origin, mortar, turn)};
    for (std::array<Complex, 3> &motion : at_points.motion)
      for (Complex &component : motion)
        component *= std::sqrt(0.5); // two halves make a sector
    return at_points;
  }

  RingModes LipModes::at(const ContactSurface &tooth_top, const double lip_turn) const
  {
    const double pitch          = 2. * numbers::PI / n_teeth;
    const MortarCoupling mortar = couple(tooth_top, lip.surface, pitch, lip_turn);
    RingModes at_nodes(modes.size());
    for (unsigned int k = 0; k < modes.size(); ++k)
      for (const LipMode &mode : modes[k])
        at_nodes[k].push_back(at_points(mode, lip, mortar, k * pitch));
    return at_nodes;
  }

  RotorVibration::RotorVibration(const Parameters &parameters, const double frequency,
                                 const MPI_Comm communicator)
      : parameters(parameters), frequency(frequency),
        moves_as_a_whole(motor_model(parameters).rotor_moves_as_whole), communicator(communicator)
  {
  }

  VibrationSetting RotorVibration::setting(const unsigned int level) const
  {
    constexpr std::array<unsigned int, finest_level + 1> n_low{{9, 13, 20, 30}},
        n_harmonics{{30, 45, 45, 60}};
    return {level, n_low.at(level), moves_as_a_whole ? n_low[level] : n_harmonics[level]};
  }

  VibrationSetting RotorVibration::on_coarser_mesh(const unsigned int level) const
  {
    VibrationSetting other = setting(level);
    --other.mesh;
    return other;
  }

  VibrationSetting RotorVibration::of_other_harmonics(const unsigned int level) const
  {
    VibrationSetting other = on_coarser_mesh(level);
    other.n_harmonics =
        moves_as_a_whole ? setting(level - 1).n_harmonics : 3 * other.n_harmonics / 2;
    return other;
  }

  std::vector<VibrationSetting> RotorVibration::settings(const unsigned int level,
                                                         const ModeSets sets) const
  {
    if (sets == ModeSets::own)
      return {setting(level)};
    return {setting(level), on_coarser_mesh(level), of_other_harmonics(level)};
  }

  void RotorVibration::prepare(const unsigned int modes_level, const ModeSets sets) const
  {
    const std::vector<VibrationSetting> all = settings(modes_level, sets);
    for (auto &[mesh, on_mesh] : results->by_mesh)
      if (mesh != all.front().mesh && mesh != 0)
        on_mesh.whole.clear();
    for (const VibrationSetting &each : all)
      for (const Part &part : parts(each))
        modes_of(part, parameters.output.vtu && &each == &all.front());
  }

  const LipModes &RotorVibration::of_harmonics(const unsigned int n_harmonics,
                                               const unsigned int level) const
  {
    return modes_of({level, n_harmonics, {}});
  }

  double RotorVibration::loss_factor() const
  {
    if (!results->loss_factor)
      results->loss_factor = rotor_loss_factor(parameters);
    return *results->loss_factor;
  }

  std::vector<RotorVibration::Part> RotorVibration::parts(const VibrationSetting &setting) const
  {
    if (moves_as_a_whole) // all of its nodal diameters have all frequencies
      return {{setting.mesh, setting.n_harmonics, {}}};
    return {{setting.mesh, setting.n_harmonics, {1, setting.n_low}},
            {0, setting.n_harmonics, {setting.n_low + 1}}};
  }

  RingModes RotorVibration::at(const VibrationSetting &setting, const ContactSurface &tooth_top,
                               const double lip_turn) const
  {
    RingModes all(parameters.motor.n_teeth / 2 + 1);
    for (const Part &part : parts(setting))
    {
      const RingModes of_part = modes_of(part).at(tooth_top, lip_turn);
      for (std::size_t k = 0; k < all.size(); ++k)
        if (!of_part[k].empty())
          all[k] = of_part[k];
    }
    return all;
  }

  std::vector<std::unique_ptr<RotorModeSolver>>
  RotorVibration::solvers(const VibrationSetting &setting) const
  {
    std::vector<std::unique_ptr<RotorModeSolver>> solvers;
    for (const auto &[mesh, n_harmonics, range] : parts(setting))
      solvers.push_back(std::make_unique<RotorModeSolver>(parameters, mesh, frequency, n_harmonics,
                                                          range, &results->by_mesh[mesh].whole));
    return solvers;
  }

  const LipModes &RotorVibration::modes_of(const Part &part, const bool keeps_whole) const
  {
    const auto &[mesh, n_harmonics, range] = part;
    std::unique_ptr<const LipModes> &modes =
        results->modes[{mesh, range.first, range.last, n_harmonics}];
    if (!modes)
      modes =
          std::make_unique<const LipModes>(parameters, mesh, frequency, n_harmonics, communicator,
                                           range, &results->by_mesh[mesh], keeps_whole);
    return *modes;
  }
} // namespace ringmotor
