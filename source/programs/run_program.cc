// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/sections_file.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/case_lock.h>
#include <ringmotor/programs/command_line.h>
#include <ringmotor/programs/interruption.h>
#include <ringmotor/programs/launcher.h>
#include <ringmotor/programs/plan.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/programs/run_results.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

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
      else if (line.sensitivities && program.sensitivities)
        program.sensitivities(parameters, line.resume);
      else if (line.resume && program.resume)
        program.resume(parameters);
      else if (!line.clear)
        program.run(parameters);
      else if (program.clear)
        program.clear(parameters);
    }

    /** Does the work in the folder of the case, which nobody else uses meanwhile. */
    void work_in_folder(const Plan &plan, const CommandLine &line, Doing &doing)
    {
      const Parameters &parameters = plan.parameters;
      nlohmann::json done          = nlohmann::json::array();
      std::optional<CaseLock> lock;
      if (is_first_rank())
        lock.emplace(parameters.output.directory);
      for (const Program &program : plan.programs)
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
        done.push_back(program.name);
        if (line.done && is_first_rank())
          write_file(*line.done, done.dump() + "\n");
      }
    }

    void answer_check(const Plan &plan, const CommandLine &line, const Process &process)
    {
      if (line.form == "json")
        return print_as_json(std::cout, plan);
      if (line.form == "sections")
        return print_sections(std::cout, plan.parameters);
      std::cout << process.name << ": the parameters are valid; results would be written to "
                << (plan.programs.size() > 1
                        ? plan.parameters.output.directory + "/"
                        : results_folder(plan.programs.front().name, plan.parameters))
                << std::endl;
      for (const Program &program : plan.programs)
        for (const std::string &remark :
             program.remarks ? program.remarks(plan.parameters) : std::vector<std::string>())
          std::cout << program.name << ": " << remark << std::endl;
    }

    void work(const CommandLine &line, const Process &process, Doing &doing)
    {
      const Plan plan = make_plan(process, line, doing.name);
      if (!line.check)
        work_in_folder(plan, line, doing);
      else if (is_first_rank())
        answer_check(plan, line, process);
    }

    /** What asks for no motor. */
    void print_about(const CommandLine &line, const Process &process)
    {
      if (line.version)
        std::cout << process.name << " of " << this_version() << ", " << describe_blas() << '\n';
      else if (line.form == "json")
        print_declarations(std::cout);
      else
        print_help(std::cout, process);
    }

    void answer_or_work(int argc, char **argv, const Process &process, Doing &doing)
    {
      const CommandLine line = read_command_line(argc, argv, process);
      const bool is_about    = line.version || line.help;
      if (!is_about && line.form != "lines")
        work(line, process, doing);
      else if (is_about && is_first_rank())
        print_about(line, process);
      else if (is_first_rank())
        answer_lines(std::cin, std::cout, process, line);
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

    /** Ends one of several copies; the first one speaks, before a launcher ends it with the others.
     */
    int end_copy(const std::string &name, const std::string &complaint)
    {
      if (complaint.empty())
        std::this_thread::sleep_for(std::chrono::seconds(1));
      else
        std::cerr << name << ": " << complaint << std::endl;
      return 1;
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

  int run_program(int argc, char **argv, const Process &process)
  {
    restart_with_faster_blas_kernel(argv);
    spare_the_network_search();
    lock_no_hdf5_files();
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN); // a file grown too large must be an error that can be reported
    int n_words = 1; // PETSc takes the others for its own, and complains of them on stdout
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_words, argv, 1);
    Doing doing{process.name, {}};
    if (const std::optional<std::string> complaint = complaint_about_launcher())
      return end_copy(process.name, *complaint);
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
