// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/version.h>

#include <filesystem>
#include <regex>
#include <sstream>

namespace ringmotor
{
  std::string this_version()
  {
    return std::string("ringmotor ") + version + " (" + git_revision + ")";
  }

  std::string results_folder(const std::string &program, const Parameters &parameters)
  {
    const Modes &modes     = parameters.modes;
    const std::string name = program != "stator"              ? program
                             : modes.domain == Domain::sector ? to_string(modes.body)
                                                              : "ring_of_" + to_string(modes.body);
    return parameters.output.directory + "/" + name + "/";
  }

  std::string failure_file(const std::string &program, const Parameters &parameters)
  {
    return parameters.output.directory + "/" + program + "_failed.txt";
  }

  void note_failure(const std::string &path, const std::string &message)
  {
    try
    {
      if (!path.empty())
        write_file(path, message + "\n");
    }
    catch (const UserError &) // cannot be written; the message is printed in any case
    {
    }
  }

  void prepare_results(const std::string &folder, const std::string &ours)
  {
    prepare_directory(folder);
    const std::regex name(ours);
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      if (std::regex_match(entry.path().filename().string(), name))
        std::filesystem::remove(entry.path());
  }

  void write_used_prm(const std::string &path, const std::string &program,
                      const Parameters &parameters)
  {
    write_file(path,
               [&](std::ostream &out)
               {
                 out << "# used by " << program << " of " << this_version() << "\n";
                 print_parameters(out, parameters);
               });
  }

  void require_certified(const Summary &summary)
  {
    for (const Summary::Check &check : summary.certificate)
      if (!check.holds())
        throw ComputationError("the results are not certified and not written: " + check.name +
                               " is " + scientific(check.value) + ", allowed: at most " +
                               scientific(check.limit) +
                               (check.remedy.empty() ? "" : "; " + check.remedy));
  }

  Summary begin_summary(const std::string &program, const Parameters &parameters,
                        const Phases &phases)
  {
    Summary summary;
    summary.program     = program;
    summary.version     = version;
    summary.git         = git_revision;
    summary.blas_kernel = blas_kernel();
    std::ostringstream prm;
    print_parameters(prm, parameters);
    summary.prm            = prm.str();
    summary.entries        = entries_of(parameters);
    summary.variant        = parameters.variant;
    summary.identity       = identity_of(parameters, this_version());
    summary.seconds        = phases.seconds();
    summary.peak_memory_MB = peak_memory_MB();
    summary.ranks          = SharedSeconds::so_far();
    return summary;
  }
} // namespace ringmotor
