// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Reads what a user or a damaged disk may give the programs, one file after the other, and says how
// each ended: "read" or "refused", or "not in words" for an error that is not meant for users. It
// ends at a crash, or if one file takes more than half a minute.
//
// Usage: readers MOTOR.prm MODES.h5 < names of files, one per line; their endings say what they are

#include <ringmotor/contact/friction_law.h>
#include <ringmotor/mesh/check_contact.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/motor/effect.h>
#include <ringmotor/output/contact_h5.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/launcher.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <unistd.h>

using namespace ringmotor;

namespace
{
  constexpr unsigned int longest = 30; ///< s, that one file may take

  /** All that the three programs check before they compute. */
  void read_parameter_file(const std::string &path)
  {
    const Parameters parameters = read_parameters(path, {});
    check_for_stator(parameters);
    check_effects(parameters, EffectStage::stator);
    check_for_contact(parameters);
    check_bodies_in_contact(parameters);
    law_of(parameters.friction).check(parameters.friction);
    check_effects(parameters, EffectStage::contact);
    check_for_losses(parameters);
    check_bodies_for_losses(parameters);
  }

  /** Numbers that are not finite must have been refused. */
  void use(const StatorWave &wave)
  {
    const dealii::Point<3> place(0.033, 0.0001, 0.00637);
    for (const WaveMotion &motion : {wave.foot, wave.top})
      for (unsigned int c = 0; c < 3; ++c)
        if (!std::isfinite(std::abs(motion(place)[c])))
          throw std::runtime_error("the wave has motions that are not finite");
  }

  void read_results(const std::string &path, const Parameters &parameters, const StatorWave &wave)
  {
    if (std::filesystem::path(path).filename().string().find("modes") == std::string::npos)
      read_contact_points(path, parameters, wave);
    else
    {
      use(read_stator_wave(ModesFile(path, parameters), parameters));
      ModesFile(path, parameters).energies();
      ModesFile(path, parameters).body();
    }
  }

  /** The small meshes of older versions are of a ring with six teeth. */
  unsigned int n_teeth_of(const std::string &mesh_file, const Parameters &parameters)
  {
    return mesh_file.find("version_") != std::string::npos ? 6 : parameters.motor.n_teeth;
  }

  void read(const std::string &path, const Parameters &parameters, const StatorWave &wave)
  {
    const std::string ending = std::filesystem::path(path).extension();
    if (ending == ".prm")
      read_parameter_file(path);
    else if (ending == ".msh")
      read_sector(path, n_teeth_of(path, parameters), MPI_COMM_SELF);
    else if (ending == ".h5")
      read_results(path, parameters, wave);
    else if (!read_kept_file(path, "a key").bytes)
      throw UserError("nothing was kept");
  }

  std::string outcome_of(const std::function<void()> &action)
  {
    try
    {
      action();
      return "read";
    }
    catch (const UserError &error)
    {
      const std::string message = error.what();
      return message.find('\n') == std::string::npos ? "refused: " + message
                                                     : "not in words: several lines";
    }
    catch (const std::exception &error)
    {
      return std::string("not in words: ") + error.what();
    }
  }
} // namespace

int main(int argc, char **argv)
{
  spare_the_network_search();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Parameters parameters = read_parameters(argv[1], {});
  const StatorWave wave       = ModesFile(argv[2], parameters).wave();
  for (std::string path; std::getline(std::cin, path);)
  {
    alarm(longest);
    std::string outcome = outcome_of([&]() { read(path, parameters, wave); });
    std::replace(outcome.begin(), outcome.end(), '\n', ' ');
    std::cout << outcome << std::endl;
  }
}
