// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/command_line.h>

#include <getopt.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <ostream>
#include <tuple>

namespace ringmotor
{
  namespace
  {
    /** Whether one of the programs has it. */
    template <typename Option>
    bool has(const Process &process, Option Program::*const option)
    {
      return std::any_of(process.programs.begin(), process.programs.end(),
                         [&](const Program &program)
                         { return static_cast<bool>(program.*option); });
    }

    bool has_several(const Process &process)
    {
      return process.programs.size() > 1;
    }

    /** A study measures one program. */
    bool has_study(const Process &process)
    {
      return !has_several(process) && has(process, &Program::study);
    }

    std::string names_after_the_first(const Process &process)
    {
      std::string names;
      for (auto program = process.programs.begin() + 1; program != process.programs.end();
           ++program)
        names += (names.empty() ? "" : " or ") + program->name;
      return names;
    }

    /** The options of a process, as shown in its usage. */
    std::string options_of(const Process &process)
    {
      return std::string(" [--output DIR] [--check[=json]]") +
             (has_several(process) ? " [--from PROGRAM]" : "") +
             (has_study(process) ? " [--study [--resume]]" : "") +
             (has(process, &Program::resume) ? " [--resume]" : "") +
             (has(process, &Program::sensitivities) ? " [--sensitivities]" : "") +
             (has(process, &Program::clear) ? " [--clear]" : "");
    }

    void check_from(const std::optional<std::string> &from, const Process &process)
    {
      if (!from)
        return;
      if (!has_several(process))
        throw UserError("--from is not available for the program " + process.name +
                        "; leave it out");
      if (std::none_of(process.programs.begin() + 1, process.programs.end(),
                       [&](const Program &program) { return program.name == *from; }))
        throw UserError("--from " + *from + ": expected " + names_after_the_first(process));
    }

    void check_options(const CommandLine &line, const Process &process)
    {
      const std::vector<std::tuple<std::string, bool, bool>> works{
          {"--resume", line.resume && !line.study && !line.sensitivities,
           has(process, &Program::resume)},
          {"--sensitivities", line.sensitivities, has(process, &Program::sensitivities)},
          {"--study", line.study, has_study(process)},
          {"--clear", line.clear, has(process, &Program::clear)},
          {"--check", line.check, true}};
      if (line.done && (line.check || !has_several(process)))
        throw UserError("--done is not available " +
                        (line.check ? "with --check" : "for the program " + process.name) +
                        "; leave it out");
      std::string first;
      for (const auto &[option, is_given, is_there] : works)
      {
        if (!is_given)
          continue;
        if (!is_there)
          throw UserError(option + " is not available for the program " + process.name +
                          "; leave it out");
        if (!first.empty())
          throw UserError(first + " cannot be combined with " + option + "; omit one of them");
        first = option;
      }
      check_from(line.from, process);
    }

    /** The form that stands behind the equals sign of an option, if any. */
    std::string form_of(const std::string &option, const std::vector<std::string> &forms)
    {
      if (optarg == nullptr)
        return "";
      if (std::find(forms.begin(), forms.end(), optarg) == forms.end())
        throw UserError(option + "=" + optarg + ": expected " + option + " or " + option + "=" +
                        boost::algorithm::join(forms, " or " + option + "="));
      return optarg;
    }

    const std::array<option, 12> options{{{"set", required_argument, nullptr, 's'},
                                          {"output", required_argument, nullptr, 'o'},
                                          {"from", required_argument, nullptr, 'f'},
                                          {"check", optional_argument, nullptr, 'k'},
                                          {"study", no_argument, nullptr, 't'},
                                          {"resume", no_argument, nullptr, 'r'},
                                          {"clear", no_argument, nullptr, 'c'},
                                          {"sensitivities", no_argument, nullptr, 'e'},
                                          {"help", optional_argument, nullptr, 'h'},
                                          {"version", no_argument, nullptr, 'v'},
                                          {"done", required_argument, nullptr, 'd'},
                                          {nullptr, 0, nullptr, 0}}};

    /** Takes an option that getopt_long() has @p found, with its value. @return whether it is one
     */
    bool take(const int found, CommandLine &line)
    {
      switch (found)
      {
      case 's':
        line.overrides.emplace_back(optarg);
        return true;
      case 'o':
        line.overrides.push_back("Output/Directory = " + std::string(optarg));
        return true;
      case 'f':
        line.from = optarg;
        return true;
      case 'k':
        line.check = true;
        line.form  = form_of("--check", {"json", "lines", "sections"});
        return true;
      case 't':
        line.study = true;
        return true;
      case 'r':
        line.resume = true;
        return true;
      case 'c':
        line.clear = true;
        return true;
      case 'e':
        line.sensitivities = true;
        return true;
      case 'h':
        line.help = true;
        line.form = form_of("--help", {"json"});
        return true;
      case 'v':
        line.version = true;
        return true;
      case 'd':
        line.done = optarg;
        return true;
      default:
        return false;
      }
    }
  } // namespace

  CommandLine read_command_line(int argc, char **argv, const Process &process)
  {
    const std::string usage = "; usage: " + process.name +
                              " FILE.prm [--set 'Section/Entry = value']..." + options_of(process) +
                              ", or " + process.name + " --help for all entries";
    CommandLine line;
    std::vector<std::string> files;
    opterr = 0;
    while (optind < argc)
    {
      // A cluster of letters, such as -np, is one word: optind passes it with its last letter.
      const std::string word = argv[optind];
      const int found        = getopt_long(argc, argv, "+:h", options.data(), nullptr);
      if (take(found, line))
        continue;
      if (found == ':')
        throw UserError("the option " + word + " needs a value" + usage);
      if (found != -1)
        throw UserError("unknown option " + word + usage);
      if (optind < argc) // no option, or "--" before one
        files.emplace_back(argv[optind++]);
    }
    if (line.help || line.version)
      return line;
    check_options(line, process);
    if (files.size() != 1)
      throw UserError(
          (files.empty() ? "no parameter file given" : "more than one parameter file given") +
          usage);
    line.file = files.front();
    return line;
  }

  void print_help(std::ostream &out, const Process &process)
  {
    out << "# " << process.name << " FILE.prm [--set 'Section/Sub/Entry = value']..."
        << options_of(process) << " [--help] [--version]\n# " << process.purpose
        << "\n# --check checks the parameters and computes nothing. For scripts, see doc/files.md: "
           "--check=json\n# prints what has been read; --check=lines reads lists of further "
           "entries, "
           "one a line, and\n# prints the identities of these motors; --check=sections prints the "
           "cross-sections;\n# --help=json prints what follows.";
    if (has_several(process))
      out << "\n# --from PROGRAM begins with " << names_after_the_first(process)
          << ", on what those before it have found in an earlier run."
          << "\n# --done FILE writes the names of the programs that have come to their end, as "
             "JSON.";
    if (has_study(process))
      out << "\n# --study measures the cost of accuracy: many settings of the discretisation, each "
             "with its\n# distance from the best one and its seconds; with --resume it goes on "
             "after an interruption.";
    if (has(process, &Program::resume))
      out << "\n# --resume continues after an interruption: finished operating points are not "
             "computed again.";
    if (has(process, &Program::sensitivities))
      out << "\n# --sensitivities also computes how much each entry of the motor changes its "
             "results, "
             "percent\n# per percent; with --resume after an interruption.";
    if (has(process, &Program::clear))
      out << "\n# --clear removes the files kept for later runs, and computes nothing.";
    out << "\n# A parameter file looks like this; the values are the defaults.\n\n";
    print_template(out);
  }
} // namespace ringmotor
