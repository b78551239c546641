// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/frequency_shift.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int most_passes = 12, most_dofs = 400000;

    /** The modes of a tooth do not depend on the nodal diameter: one stands for all. */
    Modes request_for(const Parameters &parameters)
    {
      Modes modes           = parameters.modes;
      modes.nodal_diameters = nodal_diameters_of(parameters);
      if (modes.body == Body::tooth)
        modes.nodal_diameters = {0};
      return modes;
    }

    /** What the modes may depend on. Other parameters are not available, so relevant_for_wave()
     * cannot miss any. */
    Parameters relevant_for_modes(const Parameters &parameters)
    {
      if (parameters.modes.body != Body::stator)
        return parameters;
      Parameters relevant = relevant_for_wave(parameters);
      relevant.modes      = parameters.modes;
      relevant.accuracy   = parameters.accuracy;
      return relevant;
    }

    /** WaveResult::relative_error() is at least this multiple of that of the frequency, see
     * shape_estimate(). */
    constexpr double wave_to_frequency_error = 3.;

    /** Largest relative error bar of the reference stator's modes of seven waves in the first pass.
     */
    constexpr double error_of_scout = 2.5e-3;

    /** The cheapest discretisation with which the modes of bodies like the reference motor's reach
     * a target immediately, or nearly so. */
    BodyDiscretisation fit_for(const Body body, const double target)
    {
      if (body == Body::rotor)
        return target >= 5.3e-4   ? BodyDiscretisation{3, 0}
               : target >= 3.3e-4 ? BodyDiscretisation{3, 1}
                                  : BodyDiscretisation{4, 0};
      return target >= 3e-3     ? BodyDiscretisation{2, 1}
             : target >= 3.8e-4 ? BodyDiscretisation{3, 1}
             : target >= 3.2e-4 ? BodyDiscretisation{3, 2}
             : target >= 1.9e-4 ? BodyDiscretisation{3, 3}
             : target >= 9.7e-5 ? BodyDiscretisation{4, 1}
             : target >= 5.9e-5 ? BodyDiscretisation{4, 2}
                                : BodyDiscretisation{4, 3};
    }
  } // namespace

  BodyDiscretisation discretisation_for(const Body body, const double target, const double found)
  {
    // Errors scale as (h k)^(2p), k a wave number: what is q times harder for degree 2 is q^2 times
    // harder for degree 4.
    return fit_for(body, target / std::max(1., std::pow(found / error_of_scout, 2)));
  }

  SectorMesh mesh_of_body(const Parameters &parameters, const BodyDiscretisation &discretisation,
                          const MotorModel &model, const MPI_Comm ranks)
  {
    switch (parameters.modes.body)
    {
    case Body::rotor:
      return rotor_shape(parameters)->sector(discretisation.level, ranks);
    case Body::tooth:
      return stator_shape(parameters)->tooth(discretisation.level, ranks);
    case Body::stator:
      break;
    }
    SectorMesh stator =
        discretisation.grading
            ? make_sector(stator_body(parameters), SectorForm::half, *discretisation.grading, ranks)
            : stator_shape(parameters)->sector(discretisation.level, ranks);
    add_to_stator(model, stator);
    return stator;
  }

  BodyModes::BodyModes(const Parameters &all_parameters, MPI_Comm ranks)
      : given(all_parameters), parameters(relevant_for_modes(all_parameters)),
        share_modes(request_for(parameters).nodal_diameters.size() > 1 ? ranks : MPI_COMM_SELF),
        share_mesh(share_modes == ranks ? MPI_COMM_SELF : ranks),
        motor_wave(parameters.motor.n_waves, parameters.wave)
  {
  }

  std::unique_ptr<ModeSearch> BodyModes::new_search(const MotorModel &model) const
  {
    return std::make_unique<ModeSearch>(
        material_table(parameters.materials, parameters.modes.body, model.ceramic),
        request_for(parameters), share_modes);
  }

  void BodyModes::find(const std::function<void(const Pass &)> &after_pass)
  {
    begin();
    if (parameters.accuracy.mode == AccuracyMode::fixed)
    {
      const unsigned int degree = parameters.accuracy.polynomial_degree;
      after_pass(compute({std::max(scout.degree, degree - 1), scout.level}));
      after_pass(compute({degree, parameters.accuracy.refinement}));
      find_capacitances();
      return;
    }

    after_pass(compute(scout));
    const Accuracy &accuracy = parameters.accuracy;
    const double by_wave = wave() ? AccuracyBudget(accuracy).wave() / wave_to_frequency_error : 1.;
    aim_at(by_wave < accuracy.target);
    const BodyDiscretisation discretisation =
        discretisation_for(parameters.modes.body, std::min(accuracy.target, by_wave),
                           mode_search->worst_relative_error());
    if (is_generated())
      make_mesh(discretisation);
    after_pass(compute_pass(discretisation.degree));
    const auto excess = [&]() { return mode_search->worst_relative_error() / accuracy.target; };
    const auto excess_of_wave = [&]()
    { return wave() ? wave()->relative_error() / AccuracyBudget(accuracy).wave() : 0.; };
    while (excess() > 1. || excess_of_wave() > 1.)
    {
      aim_at(excess_of_wave() > excess());
      if (n_passes == most_passes || mode_search->sector().n_dofs() > most_dofs)
        give_up();
      mode_search->refine(mesh);
      after_pass(compute_pass(discretisation.degree));
    }
    find_capacitances();
  }

  void BodyModes::find_capacitances()
  {
    if (circuits() == nullptr)
      return;
    const MotorModel model = motor_model(parameters);
    for (const unsigned int degree : {scout.degree, scout.degree + 1})
    {
      const SectorMesh coarse =
          mesh_of_body(parameters, {degree, scout.level}, model, MPI_COMM_SELF);
      const auto search = new_search(model);
      search->compute(coarse, degree);
      motor_circuits->add_capacitances(*search);
    }
  }

  void BodyModes::aim_at(const bool for_wave)
  {
    std::ostringstream entry;
    if (for_wave)
      entry << "Accuracy/Contact target = " << parameters.accuracy.strictest_target()
            << " (a fifth of it for the motor's wave)";
    else
      entry << "Accuracy/Target = " << parameters.accuracy.target;
    refined_for = entry.str();
  }

  bool BodyModes::is_generated() const
  {
    return !origin_of_modes(parameters).is_sector;
  }

  void BodyModes::make_mesh(const BodyDiscretisation &discretisation)
  {
    // Two ranks with parts of a mesh are no faster than one, but wait for each other; they have
    // half of its memory each.
    constexpr unsigned int few_cells = 500;
    level                            = discretisation.level;
    const MotorModel model           = motor_model(parameters);
    mesh = mesh_of_body(parameters, discretisation, model, MPI_COMM_SELF);
    if (mesh.n_cells() > few_cells && share_mesh != MPI_COMM_SELF)
      mesh = mesh_of_body(parameters, discretisation, model, share_mesh);
  }

  void BodyModes::begin()
  {
    choose_effects();
    const MotorModel model = motor_model(parameters);
    mode_search            = new_search(model);
    if (parameters.modes.body == Body::stator && model.ceramic)
      motor_circuits.emplace(given);
  }

  void BodyModes::choose_effects()
  {
    const auto has_to_choose = [&](const auto &effect)
    {
      return effect->stage == EffectStage::stator &&
             effect->choice(parameters) == EffectChoice::automatic;
    };
    const auto &all = all_effects();
    if (parameters.modes.body != Body::stator ||
        std::none_of(all.begin(), all.end(), has_to_choose))
      return;
    SectorMesh bare   = mesh_of_body(parameters, scout, MotorModel(), MPI_COMM_SELF);
    const auto search = new_search(MotorModel());
    search->compute(bare, scout.degree);
    choices_by(*search, parameters);
  }

  double BodyModes::shift_by_coupling(const MotorModel &coupled) const
  {
    const SectorMesh bare = mesh_of_body(parameters, scout, MotorModel(), MPI_COMM_SELF);
    const auto frequency  = [&](const MotorModel &model)
    {
      const auto search = new_search(model);
      search->compute(bare, scout.degree);
      const FoundMode *wave = search->working_mode(parameters.motor.n_waves);
      return (wave ? *wave : search->modes().front()).frequency.value;
    };
    return frequency(coupled) / frequency(MotorModel()) - 1.;
  }

  std::vector<EffectRow> BodyModes::choices_by(const ModeSearch &search, Parameters &chosen) const
  {
    const FoundMode *wave = search.working_mode(parameters.motor.n_waves);
    const Mode &mode      = wave ? wave->mode : search.modes().front().mode;
    // Only the given parameters show which effects are off.
    const Scene scene{given, nullptr,
                      [&](const Effect &effect)
                      {
                        MotorModel model;
                        effect.enter(given, model);
                        if (model.ceramic)
                          return shift_by_coupling(model);
                        return frequency_shift(search.sector(), mode, model);
                      }};
    return ringmotor::choose_effects(chosen, EffectStage::stator, scene,
                                     parameters.accuracy.target);
  }

  std::vector<EffectRow> BodyModes::effects() const
  {
    if (parameters.modes.body != Body::stator)
      return {};
    Parameters chosen           = given;
    std::vector<EffectRow> rows = choices_by(*mode_search, chosen);
    for (EffectRow &row : rows)
      for (const auto &effect : all_effects())
        if (effect->name == row.name)
          row.choice = effect->choice(parameters) == EffectChoice::off ? "off" : "on";
    return rows;
  }

  void BodyModes::locate()
  {
    begin();
    compute(scout);
  }

  Pass BodyModes::compute(const BodyDiscretisation &discretisation)
  {
    make_mesh(discretisation);
    return compute_pass(discretisation.degree);
  }

  Pass BodyModes::compute_pass(const unsigned int degree)
  {
    const auto begin = std::chrono::steady_clock::now();
    mode_search->compute(mesh, degree);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (parameters.modes.body == Body::stator)
      motor_wave.add_pass(*mode_search);
    const SectorNodes &nodes = mode_search->sector().nodes();
    if (motor_circuits && nodes.first_potential_dof() == nodes.n_dofs())
      throw UserError(parameters.stator.file_entry() +
                      " has no cells of the piezoceramic, which "
                      "Effects/Piezoelectric coupling needs; mark them, or set the effect to off");
    if (circuits() != nullptr)
      motor_circuits->add_pass(*mode_search, *wave());
    return {++n_passes,     degree, level, mesh.n_cells(), mode_search->sector().n_dofs(),
            seconds.count()};
  }

  void BodyModes::give_up() const
  {
    std::ostringstream message;
    message << "the frequencies are known to " << mode_search->worst_relative_error();
    if (wave())
      message << " and the motor's wave to " << wave()->relative_error();
    message << " (relative) after " << n_passes << " passes, the last one with "
            << mode_search->sector().n_dofs() << " degrees of freedom; " << refined_for
            << " was not reached: choose a larger one";
    throw ComputationError(message.str());
  }
} // namespace ringmotor
