// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/friction_law.h>
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/output/contact_files.h>
#include <ringmotor/output/contact_h5.h>
#include <ringmotor/output/contact_keep.h>
#include <ringmotor/output/contact_summary.h>
#include <ringmotor/output/contact_vtu.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/response_file.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/points/chosen_effects.h>
#include <ringmotor/points/contact_study.h>
#include <ringmotor/points/curve_search.h>
#include <ringmotor/points/frequency_response.h>
#include <ringmotor/programs/contact_progress.h>
#include <ringmotor/programs/interruption.h>
#include <ringmotor/programs/program.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/programs/run_sensitivities.h>
#include <ringmotor/programs/run_study.h>
#include <ringmotor/programs/time_limit.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double rpm = numbers::PI / 30.;

    /**
     * The program `contact`: presses the rotor on the teeth of the stator, which carry the wave
     * that the program `stator` has found, and finds speed, torque and losses with stick and slip.
     */
    class ContactProgram
    {
    public:
      explicit ContactProgram(const Parameters &parameters);
      /** @param resumes whether operating points that an earlier run has found are reused
       * @param with_sensitivities whether those of the results are found, too */
      void run(const bool resumes, const bool with_sensitivities = false);
      /** @param resumes whether settings that an earlier study has computed are reused */
      void study(const bool resumes);

    private:
      /** Switches effects that are `auto` on or off, by their influence. */
      ChosenEffects choose_effects();

      void report(CurveSearch &search);
      void report_static_friction(CurveSearch &search);
      void report_effects(const CurveSearch &search);
      void warn_of_long_steps(const CurveSearch &search);
      void warn_of_weak_waves(const CurveSearch &search);
      /** Those for `Wave/Response torques`, by one rank alone. */
      void find_responses(const CurveSearch &search);
      void find_sensitivities(const CurveSearch &search);
      /** That of motors which are only compared with each other. */
      Discretisation coarse_discretisation(const CurveSearch &search) const;

      void write_results(const CurveSearch &search);
      void write_tables(const CurveSearch &search);
      /** Collective. */
      void write_fields(const CurveSearch &search);
      Summary make_summary(const CurveSearch &search) const;

      std::unique_ptr<TimeLimit> time_limit; ///< until results are written
      const Parameters &given;
      const std::string folder; ///< of the results, ends in a slash
      const bool is_root_rank;
      Log log;
      Phases phases;
      const ModesFile modes; ///< of the program stator
      const StatorWave wave;
      ChosenEffects effects;
      const Parameters &parameters; ///< no effect of the contact is `auto`
      std::vector<FrequencyResponse> responses;
    };

    /** @throws UserError if steps are so long that the contact of a tooth can be missed */
    void check_time_step(const Parameters &parameters, const StatorWave &wave)
    {
      const double half_period = numbers::PI / wave.angular_frequency;
      if (is_marched(parameters) && parameters.time.time_step > half_period)
        throw UserError("Time/Time step = " + scientific(parameters.time.time_step) +
                        " s is longer than half a period of the wave, in which a tooth makes and "
                        "loses contact; allowed: up to " +
                        scientific(half_period) + " s, and a tenth of that for good results");
    }

    ContactProgram::ContactProgram(const Parameters &parameters)
        : time_limit(std::make_unique<TimeLimit>(
              "contact", parameters,
              "the operating points found so far are kept: choose a larger limit and continue with "
              "--resume, or a larger Accuracy/Contact target")),
          given(parameters), folder(results_folder("contact", parameters)),
          is_root_rank(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0), log(is_root_rank),
          modes(parameters), wave(read_stator_wave(modes, parameters)), effects(choose_effects()),
          parameters(effects.parameters())
    {
      for (const std::string &warning : check_for_contact(parameters))
        log.line("warning: " + warning);
      check_time_step(parameters, wave);
      if (is_root_rank)
        prepare_directory(folder);
    }

    ChosenEffects ContactProgram::choose_effects()
    {
      const auto scope = phases.measure("choice of effects");
      ChosenEffects chosen(given, wave);
      if (chosen.lip)
      {
        std::string line =
            "dynamic over static compliance of the lip, at the harmonics of the wave:";
        for (unsigned int m = 1; m <= chosen.lip->n_harmonics(); ++m)
          line += " " + text(chosen.lip->at(m, m * wave.angular_frequency), 2);
        log.line(line);
      }
      for (const EffectRow &row : chosen.rows)
        if (row.is_automatic && row.indicator && *row.indicator != 0.)
          log.line(describe(row));
      return chosen;
    }

    void ContactProgram::run(const bool resumes, const bool with_sensitivities)
    {
      if (with_sensitivities)
        check_for_sensitivities(parameters);
      ContactKeep keep(folder, parameters, wave, resumes, log, MPI_COMM_WORLD);
      if (is_root_rank)
        tell_when_interrupted(
            "contact: interrupted; the operating points found so far are kept in " + folder +
            "kept: continue with --resume");
      ContactProgress progress(log, phases);
      ComputedPoints source(parameters, wave, effects.vibration(), keep, progress, MPI_COMM_WORLD);
      CurveSearch search(parameters, wave, source, progress, effects.left_out());
      search.find();
      report(search);
      find_responses(search);
      time_limit.reset();
      write_results(search);
      keep.report();
      if (with_sensitivities)
        find_sensitivities(search);
    }

    Discretisation ContactProgram::coarse_discretisation(const CurveSearch &search) const
    {
      constexpr unsigned int finest_level = 2;
      constexpr double n_steps            = 180.; // in a period: nodes stick and slip as a whole
      Discretisation coarse               = search.discretisation();
      coarse.level                        = std::min(coarse.level, finest_level);
      coarse.modes_level = std::min(coarse.modes_level, RotorVibration::usual_level);
      if (!motor_model(parameters).has_inertia())
        coarse.steps = StepChoice(parameters, search.motor().period()).at_least(n_steps);
      return coarse;
    }

    void ContactProgram::find_sensitivities(const CurveSearch &search)
    {
      if (search.rotor_sticks())
        log.line("no sensitivities, as the wave does not turn the rotor");
      else
        run_sensitivities(folder, parameters, coarse_discretisation(search), log);
    }

    void ContactProgram::study(const bool resumes)
    {
      ContactStudy study(parameters, wave, effects.vibration());
      run_study(folder, "contact", given, study, resumes, log);
    }

    void ContactProgram::report(CurveSearch &search)
    {
      for (const CurvePoint &point : search.points())
        log.line(describe(point));
      if (search.rotor_sticks())
        log.line(
            "warning: the wave does not turn the rotor: nearly all contact nodes stick, because "
            "the preload is too large for the amplitude; the torques above are at most a quarter "
            "of the limit of sliding friction");
      for (const CurvePoint &point : search.points())
        if (!point.remark.empty())
          log.line("note: at " + text(1e3 * point.result.torque, 2) + " mN m: " + point.remark);
      log.line(describe_faces(search.motor().gap, parameters));
      report_static_friction(search);
      warn_of_weak_waves(search);
      warn_of_long_steps(search);
      report_effects(search);
    }

    void ContactProgram::report_static_friction(CurveSearch &search)
    {
      if (search.rotor_sticks() || !has_static_excess(motor_model(parameters).friction))
        return;
      // Static friction above dynamic friction has no fracture energy unless the law has a length
      // or a velocity: how much of its effect is left depends on mesh and step.
      const CurveSearch::StaticFrictionEffect effect = search.static_friction_effect();
      const bool of_torque = effect.middle.request.control == Control::torque;
      const auto change    = [&](const double value)
      { return of_torque ? text(value / rpm, 3) + " rpm" : text(1e3 * value, 3) + " mN m"; };
      log.line("static friction: at " + text(1e3 * effect.middle.result.torque, 1) +
               " mN m the dynamic coefficient alone changes the result by " +
               change(effect.dynamic_alone) + (effect.is_step_longer ? ", twice" : ", half") +
               " the step by " + change(effect.other_step) + ", the finer mesh by " +
               change(effect.finer_mesh));
    }

    void ContactProgram::find_responses(const CurveSearch &search)
    {
      if (!is_root_rank || !wave.drive)
        return;
      const auto scope = phases.measure("frequency response");
      for (const double torque : parameters.wave.response_torques)
      {
        responses.push_back(frequency_response(parameters, *wave.drive, search.motor(),
                                               search.compared_motor(), search.discretisation(),
                                               torque));
        log.line(describe(responses.back()));
      }
    }

    void ContactProgram::report_effects(const CurveSearch &search)
    {
      add_costs(search.motor(), effects.rows);
      for (const EffectRow &row : effects.rows)
        if (row.choice == "off" && !row.is_automatic && row.indicator && *row.indicator > 0.)
          log.line(describe(row));
    }

    void ContactProgram::warn_of_weak_waves(const CurveSearch &search)
    {
      if (!wave.drive)
        return;
      double least = std::numeric_limits<double>::infinity(), largest = 0.;
      for (const CurvePoint &point : search.points())
      {
        const OperatingPoint &result = point.result;
        least                        = std::min(least, result.amplitude);
        largest                      = std::max(largest, result.amplitude);
        if (result.speed < 0. && result.torque > 0.)
          log.line("warning: at " + text(1e3 * result.torque, 2) +
                   " mN m the load turns the rotor backwards, as the wave of " +
                   text(1e6 * result.amplitude, 3) + " um is too weak");
      }
      constexpr double far = 2.;
      if (least * far < wave.amplitude || largest > far * wave.amplitude)
        log.line("note: effects set to auto were chosen, and those left out estimated, with "
                 "Wave/Amplitude = " +
                 text(1e6 * wave.amplitude, 2) + " um; the wave has " + text(1e6 * least, 2) +
                 " to " + text(1e6 * largest, 2) + " um");
    }

    void ContactProgram::warn_of_long_steps(const CurveSearch &search)
    {
      const CondensedMotor &motor = search.motor();
      double shortest             = std::numeric_limits<double>::infinity();
      for (const CurvePoint &point : search.points())
        shortest = std::min(shortest, point.result.teeth_in_contact * motor.n_waves /
                                          motor.n_teeth * motor.period());
      const double step = search.points().front().fields.time_step;
      if (step > 0.5 * shortest)
        log.line("warning: the time step of " + scientific(step) +
                 " s is not small compared to the time for which a tooth is in contact, " +
                 scientific(shortest) +
                 " s; choose a smaller Time/Time step (marching) or more "
                 "Time/Snapshots (steady)");
    }

    void ContactProgram::write_results(const CurveSearch &search)
    {
      require_certified(make_summary(search));
      if (is_root_rank)
        write_tables(search);
      if (parameters.output.vtu)
        write_fields(search);
      if (!is_root_rank)
        return;
      write_summary(folder + "summary.json", make_summary(search));
      log.line("results in " + folder);
    }

    void ContactProgram::write_tables(const CurveSearch &search)
    {
      const auto scope = phases.measure("output");
      prepare_results(
          folder, "(used|fixed)\\.prm|torque_speed\\.csv|sensitivities\\.csv|response\\.csv|"
                  "lip\\.csv|history\\."
                  "csv|contact\\.h5|"
                  "summary\\.json|(contact|motor)\\.pvd|(contact|rotor|teeth|base)_[0-9]+\\.vtu");
      write_used_prm(folder + "used.prm", "contact", given);
      write_used_prm(folder + "fixed.prm", "contact", search.frozen());
      write_torque_speed(folder + "torque_speed.csv", search.points());
      write_history(folder + "history.csv", search.motor(), search.points(),
                    !is_marched(parameters), parameters.output.history_points);
      if (std::any_of(responses.begin(), responses.end(),
                      [](const FrequencyResponse &response) { return !response.points.empty(); }))
        write_responses(folder + "response.csv", responses);
      if (effects.lip)
        write_lip(folder + "lip.csv", *effects.lip, wave.angular_frequency);
      write_contact_h5(folder + "contact.h5", given, wave, search.motor(), search.points());
    }

    void ContactProgram::write_fields(const CurveSearch &search)
    {
      const auto scope    = phases.measure("fields for ParaView");
      const MPI_Comm all  = MPI_COMM_WORLD;
      const double height = stator_shape(parameters)->contact_line().highest;
      MPI_Barrier(all); // files of an earlier run have been removed
      write_contact_surfaces(folder, search.motor(), search.points(), height, all);
      constexpr unsigned int n_subdivisions = 1;
      const MotorBodies bodies(parameters, wave,
                               ContactDiscretisation::level(search.discretisation().level),
                               n_subdivisions, all);
      const StatorAtWave stator{modes.body(), wave.amplitude, motor_model(parameters).warp};
      write_motor_bodies(folder, search.motor(), bodies, effects.vibration().rotor, stator,
                         search.points(), height, all);
      MPI_Barrier(all); // all files are complete
    }

    Summary ContactProgram::make_summary(const CurveSearch &search) const
    {
      Summary summary             = begin_summary("contact", given, phases);
      const CondensedMotor &motor = search.motor();
      summary.dofs                = motor.n_dofs;
      add_points(summary, search.points());
      add_quantities(summary, effects.lip_quantities, 0.);
      if (given.has_dimensions())
        add_quantities(
            summary, {{"clearance", units::length, Estimate(clearance(given.stator, given.rotor))}},
            0.);
      summary.effects = effects.rows;
      if (parameters.accuracy.mode == AccuracyMode::adaptive)
        summary.certificate.push_back(
            {"largest relative error of " + parameters.accuracy.names_of_quantities(),
             search.worst_error(), parameters.accuracy.contact_target});
      return summary;
    }
  } // namespace

  Program contact_program()
  {
    return {"contact",
            "Computes speed, torque and friction loss of the motor with stick and slip.",
            [](const Parameters &parameters)
            {
              check_for_contact(parameters);
              check_bodies_in_contact(parameters);
              law_of(parameters.friction).check(parameters.friction);
              check_effects(parameters, EffectStage::contact);
            },
            [](const Parameters &parameters) { ContactProgram(parameters).run(false); },
            [](const Parameters &parameters, const bool resumes)
            { ContactProgram(parameters).study(resumes); },
            [](const Parameters &parameters) { ContactProgram(parameters).run(true); },
            [](const Parameters &parameters)
            { ContactKeep::clear(results_folder("contact", parameters)); },
            [](const Parameters &parameters) {
              return std::vector<std::string>{
                  describe_faces(rough_rest_gap(parameters), parameters)};
            },
            [](const Parameters &parameters, const bool resumes)
            { ContactProgram(parameters).run(resumes, true); }};
  }
} // namespace ringmotor
