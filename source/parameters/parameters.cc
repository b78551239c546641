// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/parameters/assign.h>
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/declared_entries.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
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

    /** Replaces the values that stand for something else. */
    void resolve(Parameters &parameters, const std::filesystem::path &file)
    {
      if (parameters.output.directory == "auto")
        parameters.output.directory = "output/" + file.stem().string();
      for (std::string *const mesh_file :
           {&parameters.stator.mesh_file, &parameters.rotor.mesh_file})
        *mesh_file = resolve_mesh_file(*mesh_file, file.parent_path());
      check_found("Output/Directory", parameters.output.directory);
      check_found("Stator/Mesh file", parameters.stator.mesh_file);
      check_found("Rotor/Mesh file", parameters.rotor.mesh_file);
    }
  } // namespace

  Parameters read_parameters_from_text(const std::string &text, const std::string &name,
                                       const std::vector<std::string> &overrides)
  {
    Parameters parameters;
    ParameterHandler prm;
    parameters.declare(prm);
    const DeclaredEntries declared(prm);

    const PrmFile file = parse_prm(text, name);
    for (const PrmFile::Section &section : file.sections)
      if (!declared.has_section(section.path))
        throw UserError(section.place + ": unknown subsection " + in_quotes(section.path) + "; " +
                        declared.advice_for_section(section.path));
    assign_all(file.assignments, declared, prm);

    std::vector<PrmFile::Assignment> assignments;
    for (const std::string &override_text : overrides)
      assignments.push_back(parse_override(override_text));
    assign_all(assignments, declared, prm);
    if (!parameters.motor.accepts_unusual_values)
    {
      check_plausible(file.assignments, declared);
      check_plausible(assignments, declared);
    }

    note_missing(parameters, prm, name);
    resolve(parameters, name);
    return parameters;
  }

  Parameters read_parameters(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::error_code no_throw;
    if (!std::filesystem::exists(file, no_throw))
      throw UserError(file + ": no such parameter file; examples are in the folder prm");
    if (std::filesystem::is_directory(file, no_throw))
      throw UserError(file + ": is a folder; give a parameter file (.prm)");
    std::ifstream stream(file);
    const std::string text((std::istreambuf_iterator<char>(stream)),
                           std::istreambuf_iterator<char>());
    if (!stream.is_open() || stream.bad())
      throw UserError(file + ": cannot be read; check its permissions");
    return read_parameters_from_text(text, file, overrides);
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

  bool is_warped(const Parameters &parameters)
  {
    return parameters.initial_deformation.amplitude > 0. &&
           parameters.effects.initial_deformation != EffectChoice::off;
  }

  bool is_marched(const Parameters &parameters)
  {
    if (parameters.time.scheme != TimeScheme::automatic)
      return parameters.time.scheme == TimeScheme::marching;
    return is_warped(parameters);
  }
} // namespace ringmotor
