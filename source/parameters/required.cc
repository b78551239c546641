// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    const std::string constants_of_ceramic = "Piezoelectricity/", slot_width = "Stator/Slot width",
                      bar_stiffness = "Rotor/Radial bar stiffness";

    bool starts_with_one_of(const std::string &path, const std::vector<std::string> &starts)
    {
      return std::any_of(starts.begin(), starts.end(),
                         [&path](const std::string &start)
                         { return boost::algorithm::starts_with(path, start); });
    }

    /** Whether the motor has no part that the entry describes. */
    bool is_of_no_part(const std::string &path, const Parameters &parameters)
    {
      if (!parameters.stator.has_dimensions() && starts_with_one_of(path, {"Stator/"}))
        return path != slot_width || parameters.stator.slot_angle ||
               !parameters.stator.mesh_file.empty();
      if (!parameters.rotor.has_dimensions() && starts_with_one_of(path, {"Rotor/"}))
        return path != bar_stiffness;
      if (parameters.stator.piezoceramic_thickness == 0. &&
          starts_with_one_of(path, {"Materials/Piezoceramic/"}))
        return true;
      return parameters.rotor.radial_bar_stiffness == 0. && path == "Rotor/Radial bar height";
    }

    /** Whether stator, contact and losses need it, whatever the motor's parts. */
    bool is_always_needed(const std::string &path, const Parameters &parameters)
    {
      // Only a file tells whether it has teeth and a ceramic ring.
      if (!parameters.stator.has_dimensions() &&
          starts_with_one_of(path, {slot_width, "Materials/Piezoceramic/"}))
        return false;
      return !starts_with_one_of(path, {"Rotor/", "Loading/", "Friction/", "Materials/Rotor metal/",
                                        "Materials/Target plate/", "Materials/Lining/",
                                        "Materials/Adhesive/", constants_of_ceramic}) &&
             !boost::algorithm::ends_with(path, "/Loss factor");
    }

    /** Where the law has one coefficient, that of sticking nodes is the same. */
    void derive_static_coefficient(Parameters &parameters)
    {
      std::vector<std::string> &not_given = parameters.not_given;
      const auto missing =
          std::find(not_given.begin(), not_given.end(), "Friction/Static coefficient");
      if (parameters.friction.law.entry().has_static_coefficient || missing == not_given.end())
        return;
      parameters.friction.static_coefficient = parameters.friction.dynamic_coefficient;
      not_given.erase(missing);
    }

    /** The number of required entries that start with a text. */
    std::size_t n_required(const std::string &start)
    {
      Parameters none;
      ParameterHandler prm;
      none.declare(prm);
      none.not_given = required_but_not_set(prm);
      return missing_entries(none, {start}).size();
    }
  } // namespace

  std::vector<std::string> required_but_not_set(const ParameterHandler &prm)
  {
    std::vector<std::string> paths;
    for (std::string path : prm.get_entries_wrongly_not_set())
    {
      // deal.II's internal names have points for slashes and _20 for blanks
      boost::algorithm::replace_all(path, ".", "/");
      boost::algorithm::replace_all(path, "_20", " ");
      paths.push_back(path);
    }
    return paths;
  }

  void note_missing(Parameters &parameters, const ParameterHandler &prm, const std::string &name)
  {
    std::vector<std::string> missing;
    for (const std::string &path : required_but_not_set(prm))
      if (!is_of_no_part(path, parameters))
        (is_always_needed(path, parameters) ? missing : parameters.not_given).push_back(path);
    if (!missing.empty())
      throw UserError(name + ": missing " + some_of(missing) +
                      "; the motor has no default values, see --help for the required entries");
    derive_static_coefficient(parameters);
    for (const EffectEntry &entry : effect_entries())
      if (!entry.needs.empty() && parameters.effects[entry.name] == EffectChoice::automatic &&
          missing_entries(parameters, {entry.needs}).size() == n_required(entry.needs))
        parameters.effects[entry.name] = EffectChoice::off;
  }

  std::vector<std::string> missing_entries(const Parameters &parameters,
                                           const std::vector<std::string> &starts)
  {
    std::vector<std::string> missing;
    for (const std::string &path : parameters.not_given)
      if (starts_with_one_of(path, starts))
        missing.push_back(path);
    return missing;
  }

  void check_given(const Parameters &parameters, const std::string &reason,
                   const std::vector<std::string> &starts)
  {
    const std::vector<std::string> missing = missing_entries(parameters, starts);
    if (!missing.empty())
      throw UserError("missing " + some_of(missing) + "; " + reason +
                      "; these entries have no default values, see --help");
  }
} // namespace ringmotor
