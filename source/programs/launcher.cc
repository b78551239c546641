// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/programs/launcher.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>

namespace ringmotor
{
  namespace
  {
    /** How a launcher tells a process the number of processes and its own among them. */
    struct Launcher
    {
      const char *size, *rank;
    };

    /** The first one that is found counts: those that others may have been started by come last. */
    constexpr Launcher launchers[] = {
        Launcher{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, // Open MPI
        Launcher{"PMI_SIZE", "PMI_RANK"},                         // MPICH, Intel MPI
        Launcher{"MPI_LOCALNRANKS", "MPI_LOCALRANKID"},           // Hydra
        Launcher{"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"},   // MVAPICH
        Launcher{"JSM_NAMESPACE_SIZE", "JSM_NAMESPACE_RANK"},     // jsrun
        Launcher{"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"},         // srun
        Launcher{"SLURM_NTASKS", "SLURM_PROCID"}};                // srun, or a job's script

    std::string value_of(const char *const variable)
    {
      const char *const found = std::getenv(variable);
      return found != nullptr ? found : "";
    }

    /** Slurm tells the script of a job, which runs once, as much as the processes of srun. */
    bool is_script_of_a_job(const Launcher &launcher)
    {
      return launcher.size == std::string("SLURM_NTASKS") && value_of("ENVIRONMENT") == "BATCH";
    }

    /** `Open MPI v4.1.4`. */
    std::string name_of_mpi()
    {
      std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
      int length = 0;
      MPI_Get_library_version(text.data(), &length);
      const std::string name(text.data(), length);
      return name.substr(0, name.find_first_of(",\n"));
    }
  } // namespace

  void spare_the_network_search()
  {
    // srun starts processes of Open MPI with PMIX alone.
    if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_RANK") != nullptr)
    {
      // On one computer. Open MPI 5 complains of each network that does not lead back to it; that
      // of libfabric (ofi) sleeps for a second before it ends, and UCX takes a quarter to start.
      const std::string size = value_of("OMPI_COMM_WORLD_SIZE");
      if (!size.empty() && size == value_of("OMPI_COMM_WORLD_LOCAL_SIZE"))
      {
        setenv("OMPI_MCA_pml", "ob1", 0);
        setenv("OMPI_MCA_osc", "^ucx", 0);
        setenv("OMPI_MCA_btl", "^tcp,ofi", 0);
      }
      return;
    }
    setenv("OMPI_MCA_ess_singleton_isolated", "1", /*overwrite =*/0);
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    // All programs started alone would share one folder, and fail if another one removes it while
    // they create theirs in it.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  }

  std::optional<std::string> complaint_about_launcher()
  {
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      return {};
    const auto launcher =
        std::find_if(std::begin(launchers), std::end(launchers),
                     [](const Launcher &one)
                     { return !value_of(one.size).empty() && !value_of(one.rank).empty(); });
    if (launcher == std::end(launchers) || is_script_of_a_job(*launcher) ||
        std::atoi(value_of(launcher->size).c_str()) < 2)
      return {};
    if (std::atoi(value_of(launcher->rank).c_str()) > 0)
      return "";
    return "started " + value_of(launcher->size) + " times (" + launcher->size +
           ") by an mpirun "
           "or srun that does not belong to " +
           name_of_mpi() +
           ", with which this program is "
           "built, so that the processes do not find each other; use the mpirun of that MPI, or "
           "start one process, without " +
           launcher->size;
  }
} // namespace ringmotor
