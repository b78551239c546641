// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/case_lock.h>
#include <ringmotor/programs/interruption.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/version.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <getopt.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <thread>
#include <tuple>
#include <vector>

namespace ringmotor
{
  namespace
  {
    bool is_first_rank()
    {
      return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }

    using Work = std::function<void(const Parameters &)>;

    struct CommandLine
    {
      std::string file;
      std::vector<std::string> overrides;
      bool check = false, study = false, resume = false, clear = false, help = false,
           version = false;
    };

    /** The options of a program, as shown in its usage. */
    std::string options_of(const Program &program)
    {
      return std::string(" [--output DIR] [--check]") +
             (program.study ? " [--study [--resume]]" : "") +
             (program.resume ? " [--resume]" : "") + (program.clear ? " [--clear]" : "");
    }

    void check_options(const CommandLine &line, const Program &program)
    {
      const std::vector<std::tuple<std::string, bool, bool>> works{
          {"--resume", line.resume && !line.study, static_cast<bool>(program.resume)},
          {"--study", line.study, static_cast<bool>(program.study)},
          {"--clear", line.clear, static_cast<bool>(program.clear)},
          {"--check", line.check, true}};
      std::string first;
      for (const auto &[option, is_given, is_there] : works)
      {
        if (!is_given)
          continue;
        if (!is_there)
          throw UserError(option + " is not available for the program " + program.name +
                          "; leave it out");
        if (!first.empty())
          throw UserError(first + " cannot be combined with " + option + "; omit one of them");
        first = option;
      }
    }

    CommandLine read_command_line(int argc, char **argv, const Program &program)
    {
      const option options[] = {{"set", required_argument, nullptr, 's'},
                                {"output", required_argument, nullptr, 'o'},
                                {"check", no_argument, nullptr, 'k'},
                                {"study", no_argument, nullptr, 't'},
                                {"resume", no_argument, nullptr, 'r'},
                                {"clear", no_argument, nullptr, 'c'},
                                {"help", no_argument, nullptr, 'h'},
                                {"version", no_argument, nullptr, 'v'},
                                {nullptr, 0, nullptr, 0}};
      const std::string usage =
          "; usage: " + program.name + " FILE.prm [--set 'Section/Entry = value']..." +
          options_of(program) + ", or " + program.name + " --help for all entries";
      CommandLine line;
      opterr = 0;
      for (int found; (found = getopt_long(argc, argv, ":h", options, nullptr)) != -1;)
        switch (found)
        {
        case 's':
          line.overrides.emplace_back(optarg);
          break;
        case 'o':
          line.overrides.push_back("Output/Directory = " + std::string(optarg));
          break;
        case 'k':
          line.check = true;
          break;
        case 't':
          line.study = true;
          break;
        case 'r':
          line.resume = true;
          break;
        case 'c':
          line.clear = true;
          break;
        case 'h':
          line.help = true;
          break;
        case 'v':
          line.version = true;
          break;
        case ':':
          throw UserError("the option " + std::string(argv[optind - 1]) + " needs a value" + usage);
        default:
          throw UserError("unknown option " + std::string(argv[optind - 1]) + usage);
        }
      if (line.help || line.version)
        return line;
      check_options(line, program);
      if (argc - optind != 1)
        throw UserError(
            (optind == argc ? "no parameter file given" : "more than one parameter file given") +
            usage);
      line.file = argv[optind];
      return line;
    }

    std::string describe_blas()
    {
      const std::string kernel = blas_kernel();
      return kernel.empty() ? "a BLAS other than OpenBLAS" : "BLAS kernel " + kernel;
    }

    void print_help(const Program &program)
    {
      std::cout << "# " << program.name << " FILE.prm [--set 'Section/Sub/Entry = value']..."
                << options_of(program) << " [--help] [--version]\n# " << program.purpose
                << "\n# --check checks the parameters and computes nothing.";
      if (program.study)
        std::cout
            << "\n# --study measures the cost of accuracy: many settings of the discretisation, "
               "each "
               "with its\n# distance from the best one and its seconds; with --resume it goes on "
               "after an interruption.";
      if (program.resume)
        std::cout << "\n# --resume continues after an interruption: finished operating points are "
                     "not computed again.";
      if (program.clear)
        std::cout << "\n# --clear removes the files kept for later runs, and computes nothing.";
      std::cout << "\n# A parameter file looks like this; the values are those of the reference "
                   "motor.\n\n";
      print_parameters(std::cout, Parameters());
    }

    Work work_of(const CommandLine &line, const Program &program)
    {
      if (line.study)
        return [&](const Parameters &parameters) { program.study(parameters, line.resume); };
      return line.resume ? program.resume : line.clear ? program.clear : program.run;
    }

    /** Does the work in the folder of the case, which nobody else uses meanwhile.
     * @param noted_in where the message of an error is kept, empty before the work begins */
    void work_in_folder(const Program &program, const Work &do_it, const Parameters &parameters,
                        std::string &noted_in)
    {
      std::optional<CaseLock> lock;
      if (is_first_rank())
      {
        lock.emplace(parameters.output.directory);
        tell_when_interrupted(program.name +
                              ": interrupted; no results of this run are kept: start it again");
        noted_in = failure_file(program.name, parameters);
        std::remove(noted_in.c_str());
      }
      do_it(parameters);
    }

    void work(int argc, char **argv, const Program &program, std::string &noted_in)
    {
      const CommandLine line = read_command_line(argc, argv, program);
      if (line.version && is_first_rank())
        std::cout << program.name << " of ringmotor " << version << " (" << git_revision << "), "
                  << describe_blas() << '\n';
      else if (line.help && is_first_rank())
        print_help(program);
      if (line.version || line.help)
        return;
      const Parameters parameters = read_parameters(line.file, line.overrides);
      program.check(parameters);
      if (!line.check)
        work_in_folder(program, work_of(line, program), parameters, noted_in);
      else if (is_first_rank())
        std::cout << program.name << ": the parameters are valid; results would be written to "
                  << results_folder(program.name, parameters) << std::endl;
    }

    /** Prints once and ends all ranks: a rank that fails alone would leave the others waiting. */
    int fail(const std::string &name, const std::string &message, const int status)
    {
      const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const bool alone        = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
      if (rank != 0) // most errors happen on all ranks: let rank 0 report them
        std::this_thread::sleep_for(std::chrono::seconds(2));
      std::cerr << name << (rank == 0 ? "" : " (rank " + std::to_string(rank) + ")") << ": "
                << message << std::endl;
      if (!alone)
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

  int run_program(int argc, char **argv, const Program &program)
  {
    restart_with_faster_blas_kernel(argv);
    spare_the_network_search();
    std::signal(SIGXFSZ, SIG_IGN); // a file grown too large must be an error that can be reported
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    std::string noted_in;
    const auto failed = [&](const std::string &message, const int status)
    {
      note_failure(noted_in, message);
      return fail(program.name, message, status);
    };
    try
    {
      reserve_blas_memory();
      work(argc, argv, program, noted_in);
      return 0;
    }
    catch (const UserError &error)
    {
      return failed(error.what(), 1);
    }
    catch (const ComputationError &error)
    {
      return failed(error.what(), 2);
    }
    catch (const std::bad_alloc &)
    {
      return failed("out of memory; choose a larger Accuracy/Target or Accuracy/Contact target, "
                    "fewer Modes/Nodal diameters, or a machine with more",
                    2);
    }
    catch (const dealii::ExceptionBase &error)
    {
      // what() carries a stack trace, of use to programmers only
      std::ostringstream message;
      error.print_info(message);
      return failed("internal error: " + message.str(), 2);
    }
    catch (const std::exception &error)
    {
      return failed(std::string("internal error: ") + error.what(), 2);
    }
  }
} // namespace ringmotor
