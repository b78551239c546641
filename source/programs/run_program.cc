// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/case_lock.h>
#include <ringmotor/programs/command_line.h>
#include <ringmotor/programs/interruption.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/version.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <malloc.h>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

namespace ringmotor
{
  namespace
  {
    bool is_first_rank()
    {
      return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }

    std::string describe_blas()
    {
      const std::string kernel = blas_kernel();
      return kernel.empty() ? "a BLAS other than OpenBLAS" : "BLAS kernel " + kernel;
    }

    /** What happens at the moment, for the message of an error. */
    struct Doing
    {
      std::string name;     ///< of the program
      std::string noted_in; ///< file that keeps the message, empty before the work begins
    };

    void do_work(const Program &program, const CommandLine &line, const Parameters &parameters)
    {
      if (line.study)
        program.study(parameters, line.resume);
      else if (line.resume && program.resume)
        program.resume(parameters);
      else if (!line.clear)
        program.run(parameters);
      else if (program.clear)
        program.clear(parameters);
    }

    /** Does the work in the folder of the case, which nobody else uses meanwhile. */
    void work_in_folder(const std::vector<Program> &programs, const CommandLine &line,
                        const Parameters &parameters, Doing &doing)
    {
      std::optional<CaseLock> lock;
      if (is_first_rank())
        lock.emplace(parameters.output.directory);
      for (const Program &program : programs)
      {
        doing.name     = program.name;
        doing.noted_in = failure_file(program.name, parameters);
        if (is_first_rank())
        {
          std::remove(doing.noted_in.c_str());
          be_silent_after_failure(doing.noted_in);
          tell_when_interrupted(program.name +
                                ": interrupted; no results of this run are kept: start it again");
        }
        forget_peak_memory();
        do_work(program, line, parameters);
        MPI_Barrier(MPI_COMM_WORLD); // the next one reads what rank 0 has written
      }
    }

    /** The programs to run: those from the first one asked for, and where the modes of the rotor or
     * of a tooth are asked for, which have no wave for the others, that one alone. */
    std::vector<Program> programs_to_run(const Process &process, const CommandLine &line,
                                         const Parameters &parameters)
    {
      std::vector<Program> programs = process.programs;
      if (line.from)
        programs.erase(programs.begin(), std::find_if(programs.begin(), programs.end(),
                                                      [&](const Program &program)
                                                      { return program.name == *line.from; }));
      if (parameters.modes.body != Body::stator)
        programs.resize(1, programs.front());
      return programs;
    }

    void work(const CommandLine &line, const Process &process, Doing &doing)
    {
      const Parameters parameters         = read_parameters(line.file, line.overrides);
      const std::vector<Program> programs = programs_to_run(process, line, parameters);
      for (const Program &program : programs)
        program.check(parameters);
      if (!line.check)
        work_in_folder(programs, line, parameters, doing);
      else if (is_first_rank())
        std::cout << process.name << ": the parameters are valid; results would be written to "
                  << (programs.size() > 1 ? parameters.output.directory + "/"
                                          : results_folder(programs.front().name, parameters))
                  << std::endl;
    }

    void answer_or_work(int argc, char **argv, const Process &process, Doing &doing)
    {
      const CommandLine line = read_command_line(argc, argv, process);
      if (!line.version && !line.help)
        work(line, process, doing);
      else if (line.version && is_first_rank())
        std::cout << process.name << " of ringmotor " << version << " (" << git_revision << "), "
                  << describe_blas() << '\n';
      else if (is_first_rank())
        print_help(std::cout, process);
    }

    /** Large matrices come and go all the time: getting their memory from the system, page by page,
     * would take longer than what is done with some of them. */
    void keep_freed_memory()
    {
      constexpr int megabyte = 1 << 20;
      mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
      mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
    }

    /** The folder of a case is locked (see CaseLock), and HDF5 opens no file where the file system
     * has no locks. To be called before the first one is opened. */
    void lock_no_hdf5_files()
    {
      setenv("HDF5_USE_FILE_LOCKING", "FALSE", /*overwrite =*/1);
    }

    /** Reports once and ends all ranks: a rank that fails alone would leave the others waiting. */
    int fail(const Doing &doing, const std::string &message, const int status)
    {
      if (!is_first_rank()) // most errors happen on all ranks: let the first one report them
        std::this_thread::sleep_for(std::chrono::seconds(2));
      note_failure(doing.noted_in, message);
      std::cerr << doing.name << ": " << message << std::endl;
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, status);
      return status;
    }
  } // namespace

  void spare_the_network_search()
  {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
      return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", /*overwrite =*/0);
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    // All programs started alone would share one folder, and fail if another one removes it while
    // they create theirs in it.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  }

  int run_program(int argc, char **argv, const Process &process)
  {
    restart_with_faster_blas_kernel(argv);
    spare_the_network_search();
    lock_no_hdf5_files();
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN); // a file grown too large must be an error that can be reported
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    Doing doing{process.name, {}};
    try
    {
      reserve_blas_memory();
      answer_or_work(argc, argv, process, doing);
      return 0;
    }
    catch (const UserError &error)
    {
      return fail(doing, error.what(), 1);
    }
    catch (const ComputationError &error)
    {
      return fail(doing, error.what(), 2);
    }
    catch (const std::bad_alloc &)
    {
      return fail(doing,
                  "out of memory; choose a larger Accuracy/Target or Accuracy/Contact target, "
                  "fewer Modes/Nodal diameters, or a machine with more",
                  2);
    }
    catch (const dealii::ExceptionBase &error)
    {
      // what() carries a stack trace, of use to programmers only
      std::ostringstream message;
      error.print_info(message);
      return fail(doing, "internal error: " + message.str(), 2);
    }
    catch (const std::exception &error)
    {
      return fail(doing, std::string("internal error: ") + error.what(), 2);
    }
  }
} // namespace ringmotor
