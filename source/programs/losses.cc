// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/output/contact_h5.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/losses_files.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/text.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/program.h>
#include <ringmotor/programs/run_results.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * The program `losses`: from the stator's wave and the operating points that `stator` and
     * `contact` have found, where the power goes: friction, inside stator, rotor and felt, and out
     * of the motor.
     */
    class LossesProgram
    {
    public:
      explicit LossesProgram(const Parameters &parameters);
      void run();

    private:
      void find_losses();
      /** The wave with its electrodes; none if they cannot drive it. */
      std::optional<DrivenWave> driven_wave(const ModesFile &modes);
      void report();
      void write_results();

      const Parameters &parameters;
      const std::string folder; ///< of the results, ends in a slash
      const bool is_root_rank;
      Log log;
      Phases phases;
      WaveEnergies wave;
      SectorField body; ///< distribution of its strain energy, for ParaView
      std::vector<PointLosses> points;
    };

    LossesProgram::LossesProgram(const Parameters &parameters)
        : parameters(parameters), folder(results_folder("losses", parameters)),
          is_root_rank(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0), log(is_root_rank)
    {
      for (const std::string &warning : check_for_losses(parameters))
        log.line("warning: " + warning);
      for (const std::string &warning : check_bodies_for_losses(parameters))
        log.line("warning: " + warning);
    }

    void LossesProgram::run()
    {
      find_losses();
      report();
      write_results();
    }

    void LossesProgram::find_losses()
    {
      const auto scope = phases.measure("losses");
      const ModesFile modes(parameters);
      wave = modes.energies();
      if (is_root_rank && parameters.output.vtu)
        body = modes.body();
      const StatorWave of_now = read_stator_wave(modes, parameters);
      const auto driven       = driven_wave(modes);
      const auto of_rotor     = rotor_loss_by_part(parameters);
      for (const CurvePoint &point : read_contact_points(
               parameters.output.directory + "/contact/contact.h5", parameters, of_now))
      {
        PointLosses losses{
            point, loss_budget(point, wave, parameters.materials, of_rotor, parameters.support)};
        if (driven)
          losses.drive = drive_point(point, losses.budget, *driven);
        points.push_back(std::move(losses));
      }
    }

    std::optional<DrivenWave> LossesProgram::driven_wave(const ModesFile &modes)
    {
      auto driven = modes.driven_wave();
      if (!driven)
        return {};
      if (driven->standing_part > DrivenWave::negligible)
      {
        log.line(
            "warning: with Electrodes/Distance of phases = " +
            text(parameters.electrodes.phase_distance, 3) +
            " voltages a quarter of a period apart do not drive a travelling wave, but one with " +
            text(100. * driven->standing_part, 0) +
            " % of a standing one: no voltages are computed");
        return {};
      }
      if (difference_of_phases(*driven) > DrivenWave::negligible)
        log.line("warning: the force factors of the phases differ by " +
                 text(100. * difference_of_phases(*driven), 1) +
                 " %, so that equal voltages drive a wave that is partly standing; voltages are "
                 "those for the mean");
      return driven;
    }

    void LossesProgram::report()
    {
      for (const PointLosses &losses : points)
        log.line(describe(losses));
      const auto best =
          std::max_element(points.begin(), points.end(),
                           [](const PointLosses &a, const PointLosses &b)
                           { return a.budget.efficiency().value < b.budget.efficiency().value; });
      log.line("best: " + describe(*best));
    }

    void LossesProgram::write_results()
    {
      if (!is_root_rank)
        return;
      Summary summary = begin_summary("losses", parameters, phases);
      add_losses(summary, points, phases.seconds().front().second / points.size());
      require_certified(summary);
      prepare_results(folder, "used\\.prm|losses\\.csv|efficiency\\.csv|drive\\.csv|"
                              "loss_density\\.vtu|summary\\.json");
      write_used_prm(folder + "used.prm", "losses", parameters);
      write_losses(folder + "losses.csv", points);
      write_efficiency(folder + "efficiency.csv", points);
      if (points.front().drive)
        write_drive(folder + "drive.csv", points);
      if (parameters.output.vtu)
        write_ring_scalar(folder + "loss_density.vtu", body, {"loss_density", 1, "W/m^3"},
                          loss_density(body, parameters.materials));
      write_summary(folder + "summary.json", summary);
      log.line("results in " + folder);
    }
  } // namespace

  Program losses_program()
  {
    return {"losses", "Computes losses and efficiency of the motor at its operating points.",
            [](const Parameters &parameters)
            {
              check_for_losses(parameters);
              check_bodies_for_losses(parameters);
              law_of(parameters.friction).check(parameters.friction);
              check_effects(parameters, EffectStage::contact);
            },
            [](const Parameters &parameters) { LossesProgram(parameters).run(); }};
  }
} // namespace ringmotor
