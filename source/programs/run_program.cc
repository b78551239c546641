// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/version.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <getopt.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

namespace ringmotor
{
  namespace
  {
    struct CommandLine
    {
      std::string file;
      std::vector<std::string> overrides;
      bool study = false, resume = false, help = false, version = false;
    };

    CommandLine read_command_line(int argc, char **argv, const std::string &name,
                                  const bool can_resume)
    {
      const option options[] = {{"set", required_argument, nullptr, 's'},
                                {"output", required_argument, nullptr, 'o'},
                                {"study", no_argument, nullptr, 't'},
                                {"resume", no_argument, nullptr, 'r'},
                                {"help", no_argument, nullptr, 'h'},
                                {"version", no_argument, nullptr, 'v'},
                                {nullptr, 0, nullptr, 0}};
      const std::string usage =
          "; usage: " + name +
          " FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--study]" +
          (can_resume ? " [--resume]" : "") + ", or " + name + " --help for all entries";
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
        case 't':
          line.study = true;
          break;
        case 'r':
          line.resume = true;
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
      if (line.resume && !can_resume)
        throw UserError("--resume is not available for the program " + name +
                        ", which has nothing to go on from; leave it out");
      if (line.resume && line.study)
        throw UserError("--resume does not go with --study; leave one of them out");
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

    void work(int argc, char **argv, const std::string &name, const std::string &purpose,
              const std::function<void(const Parameters &)> &check,
              const std::function<void(const Parameters &)> &run,
              const std::function<void(const Parameters &)> &study,
              const std::function<void(const Parameters &)> &resume)
    {
      const CommandLine line = read_command_line(argc, argv, name, static_cast<bool>(resume));
      const bool speaks      = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      if (line.version)
      {
        if (speaks)
          std::cout << name << " of ringmotor " << version << " (" << git_revision << "), "
                    << describe_blas() << '\n';
      }
      else if (line.help)
      {
        if (speaks)
        {
          std::cout << "# " << name
                    << " FILE.prm [--set 'Section/Sub/Entry = value']... [--output DIR] [--study] "
                    << (resume ? "[--resume] " : "") << "[--help] [--version]\n# " << purpose
                    << "\n# --study shows what accuracy costs: a ladder of settings, each with its "
                       "errors and seconds."
                    << (resume ? "\n# --resume goes on after an interruption: finished operating "
                                 "points are not computed again."
                               : "")
                    << "\n# A parameter file looks like this; the values are those of the "
                       "reference motor.\n\n";
          print_parameters(std::cout, Parameters());
        }
      }
      else
      {
        const Parameters parameters = read_parameters(line.file, line.overrides);
        check(parameters);
        (line.study ? study : line.resume ? resume : run)(parameters);
      }
    }

    /** Prints once and ends all ranks: a rank that fails alone would leave the others waiting. */
    int fail(const std::string &name, const std::string &message, const int status)
    {
      const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const bool alone        = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
      if (rank != 0) // most errors happen on all ranks: let rank 0 speak
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
  }

  int run_program(int argc, char **argv, const std::string &name, const std::string &purpose,
                  const std::function<void(const Parameters &)> &check,
                  const std::function<void(const Parameters &)> &run,
                  const std::function<void(const Parameters &)> &study,
                  const std::function<void(const Parameters &)> &resume)
  {
    restart_with_faster_blas_kernel(argv);
    spare_the_network_search();
    std::signal(SIGXFSZ, SIG_IGN); // a file grown too large shall be an error that can be told
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    try
    {
      work(argc, argv, name, purpose, check, run, study, resume);
      return 0;
    }
    catch (const UserError &error)
    {
      return fail(name, error.what(), 1);
    }
    catch (const ComputationError &error)
    {
      return fail(name, error.what(), 2);
    }
    catch (const std::bad_alloc &)
    {
      return fail(
          name, "out of memory; choose a larger Accuracy/Target or a smaller Modes/Nodal diameters",
          2);
    }
    catch (const dealii::ExceptionBase &error)
    {
      // what() carries a stack trace, of use to programmers only
      std::ostringstream message;
      error.print_info(message);
      return fail(name, "internal error: " + message.str(), 2);
    }
    catch (const std::exception &error)
    {
      return fail(name, std::string("internal error: ") + error.what(), 2);
    }
  }
} // namespace ringmotor
