// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/whole_ring.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/wave/mesh_errors.h>
#include <ringmotor/wave/ring_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int most_passes = 8, most_dofs = 4000000;

    Parameters with_effects(Parameters parameters)
    {
      for (const auto &effect : all_effects())
        if (effect->stage == EffectStage::stator &&
            effect->choice(parameters) == EffectChoice::automatic)
          parameters.effects[effect->name] = EffectChoice::on;
      return parameters;
    }
  } // namespace

  RingSearch::RingSearch(const Parameters &parameters, const MPI_Comm communicator)
      : parameters(with_effects(parameters)), communicator(communicator)
  {
  }

  void RingSearch::find(const std::function<void(const Pass &)> &after_pass)
  {
    const Accuracy &accuracy = parameters.accuracy;
    make_mesh(scout.level);
    after_pass(compute(scout.degree));
    if (accuracy.mode == AccuracyMode::fixed)
    {
      make_mesh(accuracy.refinement);
      after_pass(compute(accuracy.polynomial_degree));
      return;
    }
    const BodyDiscretisation discretisation =
        discretisation_for(parameters.modes.body, accuracy.target, worst_relative_error());
    if (!origin_of_modes(parameters).is_sector)
      make_mesh(discretisation.level);
    after_pass(compute(discretisation.degree));
    while (worst_relative_error() > accuracy.target)
    {
      if (n_passes == most_passes || model->n_dofs() > most_dofs)
      {
        std::ostringstream message;
        message << "the frequencies of the whole ring are known to " << worst_relative_error()
                << " (relative) after " << n_passes << " passes, the last one with "
                << model->n_dofs() << " degrees of freedom; Accuracy/Target = " << accuracy.target
                << " was not reached: choose a larger one";
        throw ComputationError(message.str());
      }
      refine();
      after_pass(compute(discretisation.degree));
    }
  }

  void RingSearch::make_mesh(const unsigned int new_level)
  {
    model.reset();
    level = new_level;
    // Its degree does not matter for the mesh.
    const BodyDiscretisation discretisation{scout.degree, level};
    mesh =
        whole_ring(mesh_of_body(parameters, discretisation, motor_model(parameters), MPI_COMM_SELF),
                   communicator);
  }

  Pass RingSearch::compute(const unsigned int degree)
  {
    const auto begin = std::chrono::steady_clock::now();
    model =
        std::make_unique<CyclicSector>(mesh,
                                       material_table(parameters.materials, parameters.modes.body,
                                                      motor_model(parameters).ceramic),
                                       degree);
    std::vector<Mode> modes;
    {
      RingSolver solver(*model);
      if (!shifts)
        shifts = solver.window_around(parameters.modes.n_modes, parameters.modes.frequency_target);
      modes  = solver.between(*shifts);
      missed = solver.n_counted() - solver.n_found();
    }
    const Sheets sheets(mesh);
    const std::vector<std::vector<double>> indicators = relative_indicators(*model, sheets, modes);
    const std::vector<RingContent> contents =
        ring_contents(*model, modes, parameters.motor.n_teeth / 2);
    sheet_error.assign(sheets.n_sheets(), 0.);
    found.clear();
    for (std::size_t i = 0; i < modes.size(); ++i)
    {
      for (unsigned int sheet = 0; sheet < sheets.n_sheets(); ++sheet)
        sheet_error[sheet] += indicators[i][sheet];
      const double indicator  = std::accumulate(indicators[i].begin(), indicators[i].end(), 0.);
      const double frequency  = modes[i].frequency();
      modes[i].nodal_diameter = contents[i].n_waves;
      found.push_back({std::move(modes[i]), contents[i],
                       frequency_estimate({degree, frequency, indicator}), frequency});
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    return {++n_passes, degree, level, mesh.n_cells(), model->n_dofs(), seconds.count()};
  }

  void RingSearch::refine()
  {
    const Sheets sheets(mesh);
    const std::vector<bool> chosen = sheets_with_most_error(mesh, sheets, sheet_error);
    model.reset();
    sheets.refine(mesh, chosen);
  }

  double RingSearch::worst_relative_error() const
  {
    double worst = 0.;
    for (const FoundRingMode &mode : found)
      worst = std::max(worst, mode.frequency.relative_error());
    return worst;
  }
} // namespace ringmotor
