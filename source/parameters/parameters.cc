// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/parameters/assign.h>
#include <ringmotor/parameters/base_file.h>
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  void Parameters::declare(ParameterHandler &prm)
  {
    const auto declare_section = [&prm](const std::string &name, auto &section)
    {
      prm.enter_subsection(name);
      section.declare(prm);
      prm.leave_subsection();
    };
    declare_section("Motor", motor);
    declare_section("Stator", stator);
    declare_section("Rotor", rotor);
    declare_section("Materials", materials);
    declare_section("Piezoelectricity", piezoelectricity);
    declare_section("Electrodes", electrodes);
    declare_section("Modes", modes);
    declare_section("Wave", wave);
    declare_section("Loading", loading);
    declare_section("Friction", friction);
    declare_section("Initial deformation", initial_deformation);
    declare_section("Support", support);
    declare_section("Contact", contact);
    declare_section("Time", time);
    declare_section("Accuracy", accuracy);
    declare_section("Uncertainty", uncertainty);
    declare_section("Effects", effects);
    declare_section("Output", output);
  }

  std::vector<std::pair<std::string, std::string *>> Parameters::mesh_files()
  {
    return {{"Stator/Section file", &stator.section_file},
            {"Stator/Mesh file", &stator.mesh_file},
            {"Rotor/Section file", &rotor.section_file},
            {"Rotor/Mesh file", &rotor.mesh_file}};
  }

  namespace
  {
    /** The path of a mesh file in a form that can be opened from any directory. */
    std::string resolve_mesh_file(const std::string &mesh_file, const std::filesystem::path &folder)
    {
      if (mesh_file.empty())
        return mesh_file;
      std::error_code no_throw;
      std::filesystem::path path = folder / mesh_file;
      if (!std::filesystem::exists(path, no_throw) && std::filesystem::exists(mesh_file, no_throw))
        path = mesh_file;
      return std::filesystem::absolute(path).lexically_normal().string();
    }

    /** Paths that the programs make of others stand in used.prm as well.
     * @throws UserError for one that is refused there */
    void check_found(const std::string &entry, const std::string &path)
    {
      const std::string problem = path.empty() ? "" : problem_of_path(path);
      if (!problem.empty())
        throw UserError(entry + ": the path " + in_quotes(path) + " " + problem +
                        "; rename the file or folder, or choose another one");
    }

    /** Makes the paths absolute that are relative to the folder of a parameter file. */
    void resolve_mesh_files(Parameters &parameters, const std::string &file)
    {
      for (const auto &[entry, mesh_file] : parameters.mesh_files())
        *mesh_file = resolve_mesh_file(*mesh_file, std::filesystem::path(file).parent_path());
    }

    /** Replaces the values that stand for something else. */
    void resolve(Parameters &parameters, const std::string &file)
    {
      if (parameters.output.directory == "auto")
        parameters.output.directory = "output/" + std::filesystem::path(file).stem().string();
      resolve_mesh_files(parameters, file);
      check_found("Output/Directory", parameters.output.directory);
      for (const auto &[entry, mesh_file] : parameters.mesh_files())
        check_found(entry, *mesh_file);
    }

    void assign_file(const PrmFile &file, const DeclaredEntries &declared, ParameterHandler &prm)
    {
      for (const PrmFile::Section &section : file.sections)
        if (!declared.has_section(section.path))
          throw UserError(section.place + ": unknown subsection " + in_quotes(section.path) + "; " +
                          declared.advice_for_section(section.path));
      assign_all(file.assignments, declared, prm);
    }

    /** What has been assigned so far, without the entries that are still missing. */
    Entries entries_so_far(Parameters parameters, const ParameterHandler &prm)
    {
      parameters.not_given = required_but_not_set(prm);
      return entries_of(parameters);
    }

    /** The differences of two sets of entries, but for the folder of the results. */
    std::vector<Parameters::Variant::Difference> differences(const Entries &base,
                                                             const Entries &entries)
    {
      std::map<std::string, std::string> value_of_base(base.begin(), base.end());
      std::vector<Parameters::Variant::Difference> differing;
      for (const auto &[entry, value] : entries)
        if (value != value_of_base[entry] && entry != "Output/Directory")
          differing.push_back({entry, value, value_of_base[entry]});
      return differing;
    }
  } // namespace

  Parameters read_parameters_from_text(const std::string &text, const std::string &name,
                                       const std::vector<std::string> &overrides)
  {
    Parameters parameters;
    ParameterHandler prm;
    parameters.declare(prm);
    const DeclaredEntries declared(prm);

    const std::vector<PrmFile> files = with_bases(parse_prm(text, name));
    Entries of_base;
    for (const PrmFile &file : files)
    {
      parameters.output.directory = Output().directory;
      assign_file(file, declared, prm);
      resolve_mesh_files(parameters, file.name);
      if (files.size() > 1 && of_base.empty())
        of_base = entries_so_far(parameters, prm);
    }

    std::vector<PrmFile::Assignment> assignments;
    for (const std::string &override_text : overrides)
      assignments.push_back(parse_override(override_text));
    assign_all(assignments, declared, prm);
    if (!parameters.motor.accepts_unusual_values)
    {
      for (const PrmFile &file : files)
        check_plausible(file.assignments, declared);
      check_plausible(assignments, declared);
    }
    if (files.size() > 1)
      parameters.variant = {files.front().name,
                            differences(of_base, entries_so_far(parameters, prm))};

    note_missing(parameters, prm, name);
    resolve(parameters, name);
    return parameters;
  }

  Parameters read_parameters(const std::string &file, const std::vector<std::string> &overrides)
  {
    return read_parameters_from_text(text_of_prm(file), file, overrides);
  }

  void print_parameters(std::ostream &out, const Parameters &parameters)
  {
    Parameters copy = parameters;
    ParameterHandler prm;
    copy.declare(prm);
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    const std::vector<std::string> &left_out = parameters.not_given;
    std::set<unsigned int> lines_left_out;
    for (const PrmFile::Assignment &assignment : parse_prm(text.str(), "").assignments)
      if (std::find(left_out.begin(), left_out.end(), assignment.path) != left_out.end())
        lines_left_out.insert(assignment.line);
    unsigned int number = 0;
    for (std::string line; std::getline(text, line);)
      if (lines_left_out.count(++number) == 0)
        out << line << '\n';
  }

  std::vector<unsigned int> nodal_diameters_of(const Parameters &parameters)
  {
    const std::vector<unsigned int> &listed = parameters.modes.nodal_diameters;
    if (listed.empty())
      return {parameters.motor.n_waves};
    if (listed.front() != Modes::all_nodal_diameters)
      return listed;
    std::vector<unsigned int> all(parameters.motor.n_teeth / 2 + 1);
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
} // namespace ringmotor
