// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/ring_files.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/output/text.h>
#include <ringmotor/programs/ring.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/programs/time_limit.h>
#include <ringmotor/wave/ring_search.h>

#include <deal.II/base/mpi.h>

#include <memory>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** `f(n = 7, out-of-plane) = 30.00238 +- 0.00222 kHz, antinode at 3.2 degrees` */
    std::string describe(const FoundRingMode &found)
    {
      const RingContent &wave = found.content;
      return "f(n = " + std::to_string(wave.n_waves) + ", " + to_string(wave.content.family()) +
             ") = " + text(1e-3 * found.frequency.value, 5) + " +- " +
             text(1e-3 * found.frequency.error(), 5) + " kHz, " + text(100. * wave.share, 1) +
             " % in this wave" +
             (wave.n_waves > 0
                  ? ", antinode at " + text(wave.antinode * 180. / numbers::PI, 2) + " degrees"
                  : "");
    }

    /** The program `stator` on a whole ring: its modes near a frequency. */
    class RingProgram
    {
    public:
      explicit RingProgram(const Parameters &parameters);
      void run();

    private:
      void after_pass(const Pass &pass);
      void write_results();
      Summary make_summary() const;

      std::unique_ptr<TimeLimit> time_limit; ///< until results are written
      const Parameters &parameters;
      const std::string folder; ///< of the results, ends in a slash
      const bool is_root_rank;
      Log log;
      RingSearch search;
      std::vector<std::pair<std::string, double>> pass_seconds;
      Phases phases; ///< what comes after the passes
    };

    RingProgram::RingProgram(const Parameters &parameters)
        : time_limit(std::make_unique<TimeLimit>("stator", parameters,
                                                 "choose a larger limit or Accuracy/Target")),
          parameters(parameters), folder(results_folder("stator", parameters)),
          is_root_rank(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0), log(is_root_rank),
          search(parameters, MPI_COMM_WORLD)
    {
    }

    void RingProgram::run()
    {
      if (is_root_rank)
        prepare_results(folder, "used\\.prm|frequencies\\.csv|summary\\.json|modes\\.vtu");
      search.find([&](const Pass &pass) { after_pass(pass); });
      for (const FoundRingMode &found : search.modes())
        log.line(describe(found));
      write_results();
    }

    void RingProgram::after_pass(const Pass &pass)
    {
      pass_seconds.emplace_back("modes, pass " + std::to_string(pass.number), pass.seconds);
      log.line("pass " + std::to_string(pass.number) + ": whole ring, degree " +
               std::to_string(pass.degree) + ", " + std::to_string(pass.n_cells) + " cells, " +
               std::to_string(pass.n_dofs) + " dofs: " + std::to_string(search.modes().size()) +
               " modes, largest relative error " + scientific(search.worst_relative_error()) +
               ", " + text(pass.seconds, 2) + " s");
    }

    void RingProgram::write_results()
    {
      require_certified(make_summary());
      time_limit.reset();
      if (is_root_rank)
      {
        {
          const auto scope = phases.measure("output");
          write_used_prm(folder + "used.prm", "stator", parameters);
          write_frequencies(folder + "frequencies.csv", search.modes());
          if (parameters.output.vtu)
            write_ring_modes(folder + "modes.vtu", search.ring(), search.modes(),
                             parameters.wave.amplitude);
        }
        write_summary(folder + "summary.json", make_summary());
      }
      log.line("results in " + folder);
    }

    Summary RingProgram::make_summary() const
    {
      Summary summary = begin_summary("stator", parameters, phases);
      summary.seconds.insert(summary.seconds.begin(), pass_seconds.begin(), pass_seconds.end());
      summary.dofs   = search.ring().n_dofs();
      double seconds = 0.;
      for (const auto &pass : pass_seconds)
        seconds += pass.second;
      unsigned int number = 0;
      for (const FoundRingMode &found : search.modes())
        add_quantities(summary, {{"frequency", units::hertz, found.frequency}}, seconds,
                       {{"mode", ++number},
                        {"n", found.content.n_waves},
                        {"family", to_string(found.content.content.family())}});
      summary.certificate.push_back(
          {"modes counted (Sturm) but not found", static_cast<double>(search.n_missed()), 0.});
      if (parameters.accuracy.mode == AccuracyMode::adaptive)
        summary.certificate.push_back({"largest relative error bar of a frequency",
                                       search.worst_relative_error(), parameters.accuracy.target});
      return summary;
    }
  } // namespace

  void run_on_whole_ring(const Parameters &parameters)
  {
    RingProgram(parameters).run();
  }
} // namespace ringmotor
