// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/programs/plan.h>
#include <ringmotor/programs/run_results.h>
#include <ringmotor/programs/run_sensitivities.h>
#include <ringmotor/version.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <istream>
#include <ostream>

namespace ringmotor
{
  namespace
  {
    // Keeps the keys in the order in which they are written here.
    using Json = nlohmann::ordered_json;

    std::vector<Program> programs_to_run(const Process &process, const CommandLine &line,
                                         const Parameters &parameters)
    {
      std::vector<Program> programs = process.programs;
      if (line.from)
        programs.erase(programs.begin(), std::find_if(programs.begin(), programs.end(),
                                                      [&](const Program &program)
                                                      { return program.name == *line.from; }));
      if (!parameters.modes.can_have_wave())
        programs.resize(1, programs.front());
      return programs;
    }

    Json json_of(const Identity &identity)
    {
      return {{"wave", identity.wave}, {"motor", identity.motor}};
    }

    Json json_of(const Plan &plan)
    {
      const Parameters &parameters = plan.parameters;
      Json programs = Json::array(), files = Json::array(), entries = Json::object();
      for (const Program &program : plan.programs)
        programs.push_back(
            {{"name", program.name}, {"folder", results_folder(program.name, parameters)}});
      for (const std::string &file : files_named_by(parameters))
        files.push_back(file);
      for (const auto &[name, text] : entries_of(parameters))
        entries[name] = text;
      return {{"version", version},
              {"git", git_revision},
              {"ranks", dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)},
              {"folder", parameters.output.directory},
              {"programs", programs},
              {"files", files},
              {"identity", json_of(identity_of(parameters, this_version()))},
              {"entries", entries},
              {"missing", parameters.not_given}};
    }

    /** @throws UserError unless it is a list of texts */
    std::vector<std::string> read_overrides(const std::string &line)
    {
      try
      {
        return nlohmann::json::parse(line);
      }
      catch (const nlohmann::json::exception &)
      {
        throw UserError("cannot understand " + in_quotes(line) +
                        ": expected a JSON list of texts \"Section/Entry = value\"");
      }
    }

    Json identity_or_mistake(const Process &process, const CommandLine &line,
                             const std::string &overrides)
    {
      std::string speaker = process.name;
      try
      {
        const Plan plan = make_plan(process, line, speaker, read_overrides(overrides));
        return {{"identity", json_of(identity_of(plan.parameters, this_version()))}};
      }
      catch (const UserError &error)
      {
        return {{"program", speaker}, {"error", error.what()}};
      }
    }

    /** @param indent of nested lines; -1 for a single line. A user's texts may hold bytes that are
     * not UTF-8. */
    void print(std::ostream &out, const Json &json, const int indent)
    {
      out << json.dump(indent, ' ', false, Json::error_handler_t::replace) << std::endl;
    }
  } // namespace

  Plan make_plan(const Process &process, const CommandLine &line, std::string &speaker,
                 const std::vector<std::string> &further)
  {
    speaker                            = process.name;
    std::vector<std::string> overrides = line.overrides;
    overrides.insert(overrides.end(), further.begin(), further.end());
    const Parameters parameters = read_parameters(line.file, overrides);
    Plan plan{parameters, programs_to_run(process, line, parameters)};
    for (const Program &program : plan.programs)
    {
      speaker = program.name;
      program.check(parameters);
    }
    if (line.sensitivities)
    {
      speaker = "contact";
      check_for_sensitivities(parameters);
    }
    speaker = process.name;
    return plan;
  }

  void print_as_json(std::ostream &out, const Plan &plan)
  {
    print(out, json_of(plan), 1);
  }

  void answer_lines(std::istream &in, std::ostream &out, const Process &process,
                    const CommandLine &line)
  {
    for (std::string overrides; std::getline(in, overrides);)
      print(out, identity_or_mistake(process, line, overrides), -1);
  }
} // namespace ringmotor
