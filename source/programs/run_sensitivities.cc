// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/output/sensitivity_files.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/run_sensitivities.h>

namespace ringmotor
{
  void check_for_sensitivities(const Parameters &parameters)
  {
    if (certain_model(parameters).is_marched)
      throw UserError(
          "--sensitivities needs the steady state of a uniform ring, but Time/Scheme or "
          "Initial deformation/Amplitude asks for marching; allowed: Time/Scheme = "
          "steady or auto, and Initial deformation/Amplitude = 0");
    if (parameters.wave.drive == Drive::voltage)
      throw UserError("Wave/Drive = voltage is not available with --sensitivities; allowed: "
                      "Wave/Drive = amplitude");
  }

  void run_sensitivities(const std::string &folder, const Parameters &parameters,
                         const Discretisation &common, Log &log)
  {
    constexpr unsigned int n_shown = 15;
    // Nodes that stick or slip as a whole make results jump a little, and impacts make them scatter
    // by half a percent.
    const double step = motor_model(parameters).has_inertia() ? 0.03 : 0.02;
    const NearbyStators stators(parameters);
    const auto on = [&](const Discretisation &discretisation)
    {
      const NearbyMotors motors(stators, discretisation);
      return sensitivities(motors, step, MPI_COMM_WORLD,
                           [&](const double part)
                           { log.progress("sensitivities, " + discretisation.text(), part); });
    };
    Discretisation other = common;
    other.level          = common.level == 0 ? 1 : common.level - 1;
    auto all             = on(common);
    add_differences(all, on(other));
    log.line("sensitivities, by changes of entries of " + text(100. * step, 0) + " % on " +
             common.text());
    for (const std::string &line : describe(all, n_shown))
      log.line(line);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      write_sensitivities(folder + "sensitivities.csv", all);
    log.line("sensitivities in " + folder + "sensitivities.csv");
  }
} // namespace ringmotor
