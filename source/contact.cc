// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/contact_files.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/output/text.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/quantities/torque_speed.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double rpm = numbers::PI / 30.;

    /** The same points on one discretisation of bodies and time. */
    struct Curve
    {
      CondensedMotor motor;
      std::vector<CurvePoint> points;
    };

    /**
     * The program `contact`: presses the rotor on the teeth of the stator, which carry the wave
     * that the program `stator` has found, and finds speed, torque and losses with stick and slip.
     */
    class ContactProgram
    {
    public:
      explicit ContactProgram(const Parameters &parameters);
      void run();
      void study();

    private:
      Curve compute(const unsigned int level);
      void find_all(Curve &curve);
      /** Goes to a smaller step or a finer mesh, whichever has more of the error. */
      void refine(unsigned int &level, Curve &coarse, Curve &curve);
      /** After so many teeth all repeats itself. */
      unsigned int teeth_that_differ() const;
      void find_requests(const CondensedMotor &motor);
      void estimate_errors(Curve &fine, const Curve &coarse);
      std::vector<CurvePoint> points_with_half_the_step(const CondensedMotor &motor) const;
      double worst_error(const Curve &curve, const bool of_mesh = true,
                         const bool of_time = true) const;
      void report(const Curve &curve, const Curve &coarse);
      void report_static_friction(const Curve &curve, const Curve &coarse);
      void warn_of_long_steps(const Curve &curve);
      void write_results(const Curve &curve);
      void write_summary_file(const Curve &curve);
      void add_quantities(Summary &summary, const Curve &curve) const;

      const Parameters &parameters;
      const std::string folder; ///< of the results, ends in a slash
      const bool speaks;
      Log log;
      Phases phases;
      StatorWave wave;
      unsigned int n_moments;   ///< of the steady state
      double stall_torque = 0.; ///< N m; of the first motor that was computed
      std::vector<PointRequest> requests;
      std::vector<CurvePoint> half_step_points; ///< on the coarser mesh
    };

    /** `50.0 mN m: 82.45 +- 0.52 rpm` */
    std::string describe(const CurvePoint &point)
    {
      const bool of_torque = point.request.control == Control::torque;
      const std::string torque =
                            text(1e3 * (of_torque ? point.request.value : point.result.torque), 2),
                        speed = text(point.result.speed / rpm, 2);
      return (of_torque
                  ? torque + " mN m: " + speed + " +- " +
                        text((point.mesh_error.speed + point.time_error.speed) / rpm, 2) + " rpm"
                  : speed + " rpm: " + torque + " +- " +
                        text(1e3 * (point.mesh_error.torque + point.time_error.torque), 2) +
                        " mN m") +
             ", friction loss " + text(1e3 * point.result.friction_loss(), 1) + " +- " +
             text(1e3 * (point.mesh_error.loss + point.time_error.loss), 1) + " mW (" +
             text(1e3 * point.result.tangential_loss, 1) + " along, " +
             text(1e3 * point.result.radial_loss, 1) + " across the ring), " +
             text(point.result.teeth_in_contact, 2) + " teeth per wave";
    }

    ContactProgram::ContactProgram(const Parameters &parameters)
        : parameters(parameters), folder(parameters.output.directory + "/contact/"),
          speaks(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0), log(speaks),
          n_moments(parameters.time.n_snapshots)
    {
    }

    void ContactProgram::run()
    {
      for (const std::string &warning : check_for_contact(parameters))
        log.line("warning: " + warning);
      wave = read_stator_wave(parameters.output.directory + "/stator/modes.h5", parameters);
      if (speaks)
        prepare_directory(folder);
      const bool is_fixed = parameters.accuracy.mode == AccuracyMode::fixed;
      unsigned int level  = is_fixed ? parameters.accuracy.interface_refinement : 1;
      if (!is_fixed) // a period in ninety steps or more
        n_moments = std::max(n_moments, (89 + teeth_that_differ()) / teeth_that_differ());
      Curve coarse = compute(level == 0 ? 1 : level - 1);
      Curve curve  = compute(level);
      estimate_errors(curve, coarse);
      while (!is_fixed && worst_error(curve) > parameters.accuracy.contact_target)
      {
        refine(level, coarse, curve);
        estimate_errors(curve, coarse);
      }
      report(curve, coarse);
      write_results(curve);
    }

    void ContactProgram::refine(unsigned int &level, Curve &coarse, Curve &curve)
    {
      constexpr unsigned int finest = 3, most_moments = 16;
      if (worst_error(curve, false, true) > worst_error(curve, true, false) &&
          !is_marched(parameters) && n_moments < most_moments)
      {
        n_moments *= 2;
        coarse.points = std::move(half_step_points);
        find_all(curve);
      }
      else if (level < finest)
      {
        coarse = std::move(curve);
        curve  = compute(++level);
      }
      else
        throw ComputationError(
            "speeds and torques are known to " + scientific(worst_error(curve)) +
            " (relative) on the finest interface mesh, but Accuracy/Contact target = " +
            scientific(parameters.accuracy.contact_target) + "; choose a larger one" +
            (is_marched(parameters) ? ", or a smaller Time/Time step" : ""));
    }

    void ContactProgram::study()
    {
      throw UserError("--study is not available for the program contact in this version; leave it "
                      "out");
    }

    Curve ContactProgram::compute(const unsigned int level)
    {
      Curve curve;
      {
        const auto scope = phases.measure("condensation, interface mesh " + std::to_string(level));
        const ContactDiscretisation discretisation = ContactDiscretisation::level(level);
        curve.motor = condense_motor(parameters, wave, discretisation);
      }
      log.line("interface mesh " + std::to_string(level) + ": " +
               std::to_string(curve.motor.nodes.size()) + " contact points on a tooth, " +
               std::to_string(curve.motor.n_dofs) + " dofs condensed");
      find_all(curve);
      return curve;
    }

    unsigned int ContactProgram::teeth_that_differ() const
    {
      return parameters.motor.n_teeth /
             std::gcd(parameters.motor.n_waves, parameters.motor.n_teeth);
    }

    void ContactProgram::find_all(Curve &curve)
    {
      const auto scope = phases.measure("operating points");
      if (requests.empty())
        find_requests(curve.motor);
      unsigned int n_found = 0;
      curve.points         = find_points(
                  parameters, curve.motor, n_moments, requests, MPI_COMM_WORLD,
                  [&](const CurvePoint &)
                  { log.progress("operating points", std::min(1., ++n_found / (1. * requests.size()))); });
    }

    void ContactProgram::find_requests(const CondensedMotor &motor)
    {
      OperatingPointFinder finder(parameters, motor, n_moments);
      stall_torque = finder.find({Control::speed, 0.}).result.torque;
      log.line("stall torque " + text(1e3 * stall_torque, 2) + " mN m");
      if (parameters.loading.control == Control::torque)
        for (const double torque : parameters.loading.values)
          if (torque >= stall_torque)
            throw UserError("Loading/Values = " + text(torque, 4) +
                            " N m is beyond the stall of the motor, which is at " +
                            text(stall_torque, 4) +
                            " N m; allowed: less than that, or Loading/Control = speed");
      requests = requested_points(parameters.loading, stall_torque);
    }

    std::vector<CurvePoint>
    ContactProgram::points_with_half_the_step(const CondensedMotor &motor) const
    {
      Parameters half = parameters;
      half.time.time_step *= 0.5;
      half.time.n_steps *= 2;
      half.time.average_from_step = 2 * half.time.average_from_step - 1;
      half.time.average_to_step *= 2;
      return find_points(half, motor, 2 * n_moments, requests, MPI_COMM_WORLD,
                         [](const CurvePoint &) {});
    }

    void ContactProgram::estimate_errors(Curve &fine, const Curve &coarse)
    {
      const auto scope = phases.measure("error estimate");
      // Meshes: the change from the next coarser one, with a margin, as convergence is not regular
      // at the edge of contact. Time: first order, the change by halving the step is half the
      // error.
      constexpr double mesh_factor = 1.25, time_factor = 2.;
      const std::vector<PointError> by_mesh =
          errors_by_change(coarse.points, fine.points, mesh_factor);
      half_step_points = points_with_half_the_step(coarse.motor);
      const std::vector<PointError> by_time =
          errors_by_change(coarse.points, half_step_points, time_factor);
      for (unsigned int i = 0; i < fine.points.size(); ++i)
      {
        fine.points[i].mesh_error = by_mesh[i];
        fine.points[i].time_error = by_time[i];
      }
    }

    /** The larger one of the relative errors of speeds and torques. */
    double ContactProgram::worst_error(const Curve &curve, const bool of_mesh,
                                       const bool of_time) const
    {
      double fastest = 0.;
      for (const CurvePoint &point : curve.points)
        fastest = std::max(fastest, std::abs(point.result.speed));
      double worst = 0.;
      for (const CurvePoint &point : curve.points)
      {
        const PointError zero, &mesh = of_mesh ? point.mesh_error : zero,
                               &time = of_time ? point.time_error : zero;
        worst                        = std::max({worst, (mesh.speed + time.speed) / fastest,
                                                 (mesh.torque + time.torque) / stall_torque});
      }
      return worst;
    }

    void ContactProgram::report(const Curve &curve, const Curve &coarse)
    {
      for (const CurvePoint &point : curve.points)
        log.line(describe(point));
      for (const CurvePoint &point : curve.points)
        if (!point.remark.empty())
          log.line("note: at " + text(1e3 * point.result.torque, 2) +
                   " mN m Newton's method needed help: " + point.remark);
      report_static_friction(curve, coarse);
      warn_of_long_steps(curve);
      log.line("effects left out: inertia of the teeth would change their tangential motion by " +
               text(100. * curve.motor.tooth_inertia_indicator, 1) + " %");
    }

    void ContactProgram::report_static_friction(const Curve &curve, const Curve &coarse)
    {
      const Friction &friction = parameters.friction;
      if (effective_friction(parameters).law == FrictionLaw::coulomb ||
          friction.static_coefficient == friction.dynamic_coefficient)
        return;
      // Static friction above dynamic friction has no fracture energy unless the law has a length
      // or a velocity: how much of it is left depends on mesh and step.
      const unsigned int middle = (curve.points.size() - 1) / 2;
      Parameters plain          = parameters;
      plain.friction.law        = FrictionLaw::coulomb;
      const CurvePoint dynamic =
          OperatingPointFinder(plain, curve.motor, n_moments).find(requests[middle]);
      const bool of_torque = requests[middle].control == Control::torque;
      const auto change    = [&](const CurvePoint &from, const CurvePoint &to)
      {
        return of_torque ? text((to.result.speed - from.result.speed) / rpm, 3) + " rpm"
                         : text(1e3 * (to.result.torque - from.result.torque), 3) + " mN m";
      };
      log.line("static friction: at " + text(1e3 * curve.points[middle].result.torque, 1) +
               " mN m the dynamic coefficient alone changes the result by " +
               change(curve.points[middle], dynamic) + ", half the step by " +
               change(coarse.points[middle], half_step_points[middle]) + ", the finer mesh by " +
               change(coarse.points[middle], curve.points[middle]));
    }

    void ContactProgram::warn_of_long_steps(const Curve &curve)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const CurvePoint &point : curve.points)
        shortest = std::min(shortest, point.result.teeth_in_contact * curve.motor.n_waves /
                                          curve.motor.n_teeth * curve.motor.period());
      const double step = curve.points.front().fields.time_step;
      if (step > 0.5 * shortest)
        log.line("warning: the time step of " + scientific(step) +
                 " s is not short against the time for which a tooth is in contact, " +
                 scientific(shortest) +
                 " s; choose a smaller Time/Time step (marching) or more "
                 "Time/Snapshots (steady)");
    }

    void ContactProgram::write_results(const Curve &curve)
    {
      if (!speaks)
        return;
      {
        const auto scope = phases.measure("output");
        prepare_results(folder, "used\\.prm|torque_speed\\.csv|history\\.csv|contact\\.h5|"
                                "summary\\.json|contact\\.pvd|contact_[0-9]+\\.vtu");
        write_used_prm(folder + "used.prm", "contact", parameters);
        write_torque_speed(folder + "torque_speed.csv", curve.points);
        write_history(folder + "history.csv", curve.motor, curve.points);
        write_contact_h5(folder + "contact.h5", parameters, curve.motor, curve.points);
        if (parameters.output.vtu)
        {
          std::vector<std::pair<double, std::string>> frames;
          for (unsigned int i = 0; i < curve.points.size(); ++i)
          {
            const std::string name = "contact_" + Utilities::int_to_string(i, 3) + ".vtu";
            write_contact_vtu(folder + name, curve.motor, curve.points[i],
                              curve.points[i].fields.times.size() - 1,
                              parameters.stator.base_thickness + parameters.stator.tooth_height);
            frames.emplace_back(std::round(1e6 * curve.points[i].result.torque) * 1e-3 + 0., name);
          }
          write_pvd(folder + "contact.pvd", frames);
        }
      }
      write_summary_file(curve);
      log.line("results in " + folder);
    }

    void ContactProgram::write_summary_file(const Curve &curve)
    {
      Summary summary = begin_summary("contact", parameters, phases);
      summary.dofs    = curve.motor.n_dofs;
      add_quantities(summary, curve);
      summary.effects.push_back(
          {"Tooth inertia", curve.motor.tooth_inertia_indicator, "off", 0., 0});
      summary.effects.push_back(
          {"Spin convection",
           curve.motor.n_waves * curve.points.front().result.speed / curve.motor.angular_frequency,
           "off", 0., 0});
      double violation = 0., imbalance = 0.;
      for (const CurvePoint &point : curve.points)
      {
        violation = std::max(violation, point.largest_violation);
        imbalance = std::max(imbalance, std::abs(point.result.closing_work) /
                                            std::max(1e-300, std::abs(point.result.input_power)));
      }
      summary.certificate.push_back(
          {"largest violation of the laws of contact and friction and of the balances of forces",
           violation, ContactCertificate::limit});
      summary.certificate.push_back({"power put in against power out and friction loss, relative",
                                     imbalance, parameters.accuracy.contact_target});
      if (parameters.accuracy.mode == AccuracyMode::adaptive)
        summary.certificate.push_back({"largest relative error of speeds and torques",
                                       worst_error(curve), parameters.accuracy.contact_target});
      write_summary(folder + "summary.json", summary);
    }

    void ContactProgram::add_quantities(Summary &summary, const Curve &curve) const
    {
      for (const CurvePoint &point : curve.points)
      {
        const bool of_torque = point.request.control == Control::torque;
        const auto add = [&](const std::string &name, const double value, const std::string &unit,
                             const double mesh, const double time)
        {
          summary.quantities.push_back(
              {name,
               value,
               unit,
               mesh + time,
               {{"meshes of bodies and interface", mesh}, {"time step", time}},
               point.seconds,
               {{of_torque ? "torque_Nm" : "speed_rad_per_s", point.request.value}}});
        };
        const PointError &mesh = point.mesh_error, &time = point.time_error;
        if (of_torque)
          add(point.request.value == 0. ? "no_load_speed" : "speed", point.result.speed, "rad/s",
              mesh.speed, time.speed);
        else
          add(point.request.value == 0. ? "stall_torque" : "torque", point.result.torque, "N m",
              mesh.torque, time.torque);
        add("friction_loss", point.result.friction_loss(), "W", mesh.loss, time.loss);
        add("friction_loss_tangential", point.result.tangential_loss, "W", mesh.loss, time.loss);
        add("friction_loss_radial", point.result.radial_loss, "W", mesh.loss, time.loss);
      }
    }
  } // namespace
} // namespace ringmotor

int main(int argc, char **argv)
{
  using namespace ringmotor;
  return run_program(
      argc, argv, "contact",
      "Computes speed, torque and friction loss of the motor with stick and slip.",
      [](const Parameters &parameters) { check_for_contact(parameters); },
      [](const Parameters &parameters) { ContactProgram(parameters).run(); },
      [](const Parameters &parameters) { ContactProgram(parameters).study(); });
}
