// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/output/circuit_files.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/sections_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/output/text.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/parameters/accuracy_budget.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/program.h>
#include <ringmotor/programs/ring.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/programs/run_study.h>
#include <ringmotor/programs/time_limit.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/body_study.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /**
     * The program `stator`: natural modes of the stator and its travelling wave, or the modes of
     * the rotor or of a tooth, from a mesh that is refined until the frequencies are as accurate as
     * requested.
     */
    class StatorProgram
    {
    public:
      explicit StatorProgram(const Parameters &parameters);
      void run();
      /** @param resumes whether settings that an earlier study has computed are reused */
      void study(const bool resumes);

    private:
      void after_pass(const Pass &pass);
      /** The motor's wave or, if it was not requested, the first mode. */
      const FoundMode &shown() const;
      void report();
      void report_wave(const WaveResult &wave);
      void report_circuits(const MotorCircuits &circuits);
      void report_excitation(const ElectrodeLayout &electrodes);
      void report_inertia();
      /** (omega/omega_1)^2, omega_1 the lowest mode of the tooth or, with the waves of the motor,
       * of the rotor: how much its inertia would matter. None if that mode or omega is not known.
       */
      std::optional<double> inertia_ratio() const;
      /** The mode, scaled to the largest displacement Wave/Amplitude. */
      Mode scaled(Mode mode) const;
      void write_results();
      void write_circuit_files(const MotorCircuits &circuits);
      void write_fields();
      /** @param plate_shift relative, of the frequency by target plates */
      Summary make_summary(const std::vector<EffectRow> &effects) const;
      void add_wave_quantities(Summary &summary, const WaveResult &wave,
                               const double seconds) const;

      std::unique_ptr<TimeLimit> time_limit; ///< until results are written
      const Parameters &parameters;
      const bool of_stator;     ///< else of the rotor or a tooth
      const std::string folder; ///< of the results, ends in a slash
      const bool is_root_rank;
      Log log;
      BodyModes body;
      std::vector<std::pair<std::string, double>> pass_seconds;
      Phases phases; ///< what comes after the passes
    };

    /** `f(n = 7, out-of-plane) = 30.00238 +- 0.00222 kHz` */
    std::string describe(const FoundMode &found, const Body body)
    {
      return "f(" +
             (body == Body::tooth ? "tooth" : "n = " + std::to_string(found.mode.nodal_diameter)) +
             ", " + to_string(found.content.family()) +
             ") = " + text(1e-3 * found.frequency.value, 5) + " +- " +
             text(1e-3 * found.frequency.error(), 5) + " kHz";
    }

    StatorProgram::StatorProgram(const Parameters &parameters)
        : time_limit(std::make_unique<TimeLimit>(
              "stator", parameters,
              "choose a larger limit, or a larger Accuracy/Target or Accuracy/Contact target")),
          parameters(parameters), of_stator(parameters.modes.body == Body::stator),
          folder(results_folder("stator", parameters)),
          is_root_rank(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0), log(is_root_rank),
          body(parameters, MPI_COMM_WORLD)
    {
    }

    void StatorProgram::run()
    {
      if (is_root_rank)
      {
        prepare_results(folder, "used\\.prm|frequencies\\.csv|ellipses\\.csv|modes\\.h5|"
                                "circuits\\.csv|admittance\\.csv|electrodes\\.csv|excitation\\.csv|"
                                "summary\\.json|sector\\.vtu|ring\\.pvd|ring_[0-9]+\\.vtu");
      }
      if (of_stator)
        for (const std::string &warning : warnings_of_effects(parameters, EffectStage::stator))
          log.line("warning: " + warning);
      body.find([&](const Pass &pass) { after_pass(pass); });
      report();
      write_results();
    }

    void StatorProgram::study(const bool resumes)
    {
      BodyStudy study(parameters, MPI_COMM_WORLD);
      run_study(folder, "stator", parameters, study, resumes, log);
    }

    const FoundMode &StatorProgram::shown() const
    {
      return body.wave() != nullptr ? body.wave()->found : body.search().modes().front();
    }

    void StatorProgram::after_pass(const Pass &pass)
    {
      pass_seconds.emplace_back("modes, pass " + std::to_string(pass.number), pass.seconds);
      const ModeSearch &search = body.search();
      const WaveResult *wave   = body.wave();
      std::ostringstream line;
      line << "pass " << pass.number << ": degree " << pass.degree << ", " << pass.n_cells
           << " cells, " << pass.n_dofs << " dofs: " << describe(shown(), parameters.modes.body)
           << ", largest relative error " << scientific(search.worst_relative_error()) << ", ";
      if (wave != nullptr && !wave->shape.empty())
        line << "of the wave " << scientific(wave->relative_error()) << ", ";
      line << std::fixed << std::setprecision(2) << pass.seconds << " s";
      log.line(line.str());
    }

    void StatorProgram::report()
    {
      for (const FoundMode &found : body.search().modes())
        log.line(describe(found, parameters.modes.body));
      if (body.wave() != nullptr)
      {
        report_wave(*body.wave());
        if (body.circuits() != nullptr)
          report_circuits(*body.circuits());
      }
      else if (!of_stator)
        report_inertia();
      else
        log.line("the motor's wave (n = " + std::to_string(parameters.motor.n_waves) +
                 ", out-of-plane) is not among the requested modes: no ellipses, no wave for the "
                 "contact");
    }

    void StatorProgram::report_wave(const WaveResult &wave)
    {
      if (wave.shape.empty())
        throw ComputationError(
            "the motor's wave was identified on the last mesh only, so that the error of its "
            "shape cannot be estimated; choose a finer mesh");
      log.line("motor's wave: A_t/A_n = " + text(wave.shape.front().value(), 4) +
               " at the outer edge of the tooth top" +
               (wave.gap_above > 0.
                    ? ", next mode of n = " + std::to_string(parameters.motor.n_waves) + " " +
                          text(100. * wave.gap_above, 1) + " % above"
                    : ""));
      log.line("relative error of the wave, for the contact: " + scientific(wave.relative_error()) +
               (body.last_refined_for().empty()
                    ? ""
                    : "; the last mesh was made for " + body.last_refined_for()));
    }

    void StatorProgram::report_circuits(const MotorCircuits &circuits)
    {

      for (const Phase of : both_phases)
      {
        const PhaseCircuit circuit = circuits.circuit(of);
        const std::string phase    = "phase " + name_of(of) + ": ";
        log.line(
            phase + "open-circuit frequency " + text(1e-3 * circuit.open_circuit_frequency(), 4) +
            " kHz, k_eff^2 = " + text(circuit.coupling_squared(), 5) +
            ", capacitance C0 = " + text(circuit.parallel.at_resonance, units::capacitance, 3) +
            ", clamped " + text(circuit.parallel.clamped, units::capacitance, 3) + ", free " +
            text(circuit.parallel.free, units::capacitance, 3));
        log.line(phase + "Lm = " + text(circuit.branch.inductance, units::inductance, 4) +
                 ", Cm = " + text(circuit.branch.capacitance, units::motional_capacitance, 2) +
                 ", Rm = " + text(circuit.branch.resistance, units::resistance, 2) +
                 ", Q = " + text(circuit.branch.quality, 0) + ", force factor " +
                 text(circuit.branch.force_factor, units::force_factor, 4));
      }
      report_excitation(circuits.electrodes());
    }

    void StatorProgram::report_excitation(const ElectrodeLayout &electrodes)
    {
      constexpr double least     = 0.1; // of what the wave gets
      const unsigned int n_waves = parameters.motor.n_waves;
      const auto share           = [&](const unsigned int n)
      {
        return (electrodes.excitation(Phase::a, n) + electrodes.excitation(Phase::b, n)) /
               (electrodes.excitation(Phase::a, n_waves) +
                electrodes.excitation(Phase::b, n_waves));
      };
      std::string others;
      for (unsigned int n = 0; n <= parameters.motor.n_teeth / 2; ++n)
        if (n != n_waves && share(n) > least)
          others += (others.empty() ? "" : ", ") + std::to_string(n) + " (" +
                    text(100. * share(n), 0) + " %)";
      if (!others.empty())
        log.line("the phases also drive other nodal diameters, in percent of n = " +
                 std::to_string(n_waves) + ": " + others);
    }

    void StatorProgram::report_inertia()
    {
      const bool of_tooth = parameters.modes.body == Body::tooth;
      const std::string n = std::to_string(parameters.motor.n_waves);
      if (const std::optional<double> ratio = inertia_ratio())
        log.line("inertia of the " + to_string(parameters.modes.body) +
                 ": (omega/omega_1)^2 = " + text(*ratio, 3) + (of_tooth ? "" : " for n = " + n));
      else
        log.line(
            "give Wave/Frequency in Hz" + (of_tooth ? "" : " and Modes/Nodal diameters with " + n) +
            " to see how much the inertia of the " + to_string(parameters.modes.body) + " matters");
    }

    std::optional<double> StatorProgram::inertia_ratio() const
    {
      std::optional<double> ratio;
      for (const FoundMode &found : body.search().modes())
        if (parameters.wave.frequency && (parameters.modes.body == Body::tooth ||
                                          found.mode.nodal_diameter == parameters.motor.n_waves))
          ratio = std::max(ratio.value_or(0.),
                           std::pow(*parameters.wave.frequency / found.frequency.value, 2));
      return ratio;
    }

    Mode StatorProgram::scaled(Mode mode) const
    {
      double largest = 0.;
      for (const SectorField::Cell &cell : sample_sector(body.search().sector(), mode, 1).cells)
        for (const auto &u : cell.displacement)
          largest =
              std::max(largest, std::sqrt(std::norm(u[0]) + std::norm(u[1]) + std::norm(u[2])));
      mode.motion *= parameters.wave.amplitude / largest;
      return mode;
    }

    void StatorProgram::write_results()
    {
      const std::vector<EffectRow> effects = body.effects(); // all ranks take part
      for (const EffectRow &row : effects)
        log.line(describe(row));
      require_certified(make_summary(effects));
      time_limit.reset();
      if (is_root_rank)
      {
        const auto scope       = phases.measure("output");
        const WaveResult *wave = body.wave();
        write_used_prm(folder + "used.prm", "stator", parameters);
        write_frequencies(folder + "frequencies.csv", body.search().modes());
        if (of_stator)
        {
          write_sections(folder + "sections.json", parameters);
          write_modes_h5(folder + "modes.h5", parameters, body.search().sector(),
                         body.search().modes(), wave, body.circuits());
        }
        if (wave != nullptr)
          write_ellipses(folder + "ellipses.csv", *wave);
        if (body.circuits() != nullptr)
          write_circuit_files(*body.circuits());
      }
      if (is_root_rank && parameters.output.vtu && (body.wave() != nullptr || !of_stator))
        write_fields();
      if (is_root_rank)
        write_summary(folder + "summary.json", make_summary(effects));
      log.line("results in " + folder);
    }

    void StatorProgram::write_circuit_files(const MotorCircuits &circuits)
    {
      write_circuits(folder + "circuits.csv", circuits);
      write_admittance(folder + "admittance.csv", circuits);
      write_electrodes(folder + "electrodes.csv", circuits.electrodes());
      write_excitation(folder + "excitation.csv", circuits.electrodes(),
                       parameters.motor.n_teeth / 2);
    }

    void StatorProgram::write_fields()
    {
      const auto scope           = phases.measure("output for ParaView");
      const CyclicSector &sector = body.search().sector();
      const WaveResult *wave     = body.wave();
      write_sector(folder + "sector.vtu",
                   sample_sector(sector, wave != nullptr ? wave->found.mode : scaled(shown().mode),
                                 sector.dofs().get_fe().degree));
      if (wave == nullptr)
        return;
      // Many frames of all sectors: where cells are small already, straight ones suffice.
      const bool fine = sector.sector_mesh().n_cells() > 50;
      write_ring_animation(folder + "ring", sample_sector(sector, wave->found.mode, fine ? 1 : 2),
                           parameters.output.frames_per_period);
    }

    Summary StatorProgram::make_summary(const std::vector<EffectRow> &effects) const
    {
      Summary summary = begin_summary("stator", parameters, phases);
      summary.seconds.insert(summary.seconds.begin(), pass_seconds.begin(), pass_seconds.end());
      summary.dofs   = body.search().sector().n_dofs();
      double seconds = 0.;
      for (const auto &pass : pass_seconds)
        seconds += pass.second;
      for (const FoundMode &found : body.search().modes())
        add_quantities(
            summary, {{"frequency", units::hertz, found.frequency}}, seconds,
            {{"n", found.mode.nodal_diameter}, {"family", to_string(found.content.family())}});
      if (body.wave() != nullptr)
        add_wave_quantities(summary, *body.wave(), seconds);
      if (body.circuits() != nullptr)
        for (const Phase phase : both_phases)
          add_quantities(summary, body.circuits()->quantities(phase), seconds,
                         {{"phase", name_of(phase)}});
      if (const auto ratio = of_stator ? std::nullopt : inertia_ratio())
        add_quantities(
            summary,
            {{"(omega/omega_1)^2", units::one,
              Estimate(*ratio, 2. * *ratio * body.search().worst_relative_error(), by_body_mesh)}},
            seconds);
      summary.effects = effects;
      summary.certificate.push_back({"modes counted (Sturm) but not found",
                                     static_cast<double>(body.search().n_missed()), 0.});
      if (body.wave() != nullptr)
        summary.certificate.push_back(
            {"eigenvalue of the wave: eigensolver against energies, relative difference",
             body.wave()->found.mode.algebra_error, 1e-7});
      if (parameters.accuracy.mode == AccuracyMode::adaptive)
        summary.certificate.push_back({"largest relative error bar of a frequency",
                                       body.search().worst_relative_error(),
                                       parameters.accuracy.target});
      if (parameters.accuracy.mode == AccuracyMode::adaptive && body.wave() != nullptr)
        summary.certificate.push_back({"relative error of the wave, for the contact",
                                       body.wave()->relative_error(),
                                       AccuracyBudget(parameters.accuracy).wave()});
      return summary;
    }

    void StatorProgram::add_wave_quantities(Summary &summary, const WaveResult &wave,
                                            const double seconds) const
    {
      add_quantities(summary, wave.shape, seconds);
      const double gap_error = 2. * body.search().worst_relative_error();
      for (const auto &[name, gap] : {std::make_pair("gap_above", wave.gap_above),
                                      std::make_pair("gap_below", wave.gap_below)})
        if (gap > 0.)
          add_quantities(summary, {{name, units::one, Estimate(gap, gap_error, by_body_mesh)}},
                         seconds);
    }
  } // namespace

  Program stator_program()
  {
    return {"stator", "Computes natural modes of the stator and its travelling wave.",
            [](const Parameters &parameters)
            {
              check_for_stator(parameters);
              check_bodies(parameters);
              if (parameters.modes.body == Body::stator)
                check_effects(parameters, EffectStage::stator);
            },
            [](const Parameters &parameters)
            {
              if (parameters.modes.domain == Domain::ring)
                run_on_whole_ring(parameters);
              else
                StatorProgram(parameters).run();
            },
            [](const Parameters &parameters, const bool resumes)
            {
              if (parameters.modes.domain == Domain::ring)
                throw UserError("Modes/Domain = ring has no study of accuracy; allowed: sector");
              StatorProgram(parameters).study(resumes);
            }};
  }
} // namespace ringmotor
