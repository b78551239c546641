// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>
#include <ringmotor/parameters/short_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace ringmotor
{
  namespace
  {
    void check_wave(const Motor &motor)
    {
      if (2 * motor.n_waves >= motor.n_teeth)
        throw UserError(
            entry("Motor/Number of waves", motor.n_waves) + " is incompatible with " +
            entry("Motor/Number of teeth", motor.n_teeth) +
            ": on N teeth, waves n and N - n are the same and n = N/2 cannot travel; "
            "allowed: less than half the number of teeth; use fewer waves or more teeth");
    }

    void check_modes(const Parameters &parameters)
    {
      const Motor &motor = parameters.motor;
      if (parameters.modes.domain == Domain::ring && parameters.modes.body == Body::tooth)
        throw UserError("Modes/Domain = ring is incompatible with Modes/Body = tooth; allowed: "
                        "stator or rotor");
      if (parameters.modes.domain == Domain::ring && !parameters.modes.nodal_diameters.empty())
        throw UserError("Modes/Nodal diameters is given, but Modes/Domain = ring finds all waves "
                        "near Modes/Frequency target; allowed: wave, the default");
      const unsigned int largest = nodal_diameters_of(parameters).back();
      if (2 * largest > motor.n_teeth)
        throw UserError(entry("Modes/Nodal diameters", largest) + " is incompatible with " +
                        entry("Motor/Number of teeth", motor.n_teeth) +
                        ": on N teeth, n and N - n are the same wave; allowed: 0 to " +
                        std::to_string(motor.n_teeth / 2));
    }

    /** @throws UserError for a file that is named but not there */
    void check_mesh_file(const std::string &entry, const std::string &file)
    {
      if (file.empty())
        return;
      std::error_code no_throw;
      const std::string found = entry + " = " + in_quotes(file) + " ";
      if (!std::filesystem::exists(file, no_throw))
        throw UserError(
            found + "does not exist; a relative path is searched in the folder of the parameter "
                    "file first, then in the current directory; give a Gmsh file (.msh), or none "
                    "to build the mesh from the dimensions");
      if (std::filesystem::is_directory(file, no_throw))
        throw UserError(found + "is a folder; give a Gmsh file (.msh)");
      if (!std::ifstream(file))
        throw UserError(found + "cannot be read; check its permissions");
    }

    /** The files of a body, where there are any. @param geometry of the stator or the rotor */
    template <typename Geometry>
    void check_files(const std::string &body, const Geometry &geometry)
    {
      if (!geometry.mesh_file.empty() && !geometry.section_file.empty())
        throw UserError(body + "/Mesh file = " + in_quotes(geometry.mesh_file) + " and " + body +
                        "/Section file = " + in_quotes(geometry.section_file) +
                        " describe the same body; allowed: one of them");
      check_mesh_file(body + "/Mesh file", geometry.mesh_file);
      check_mesh_file(body + "/Section file", geometry.section_file);
    }

    void check_stator_files(const StatorGeometry &stator)
    {
      if (!stator.has_dimensions() && stator.piezoceramic_element == ElementKind::shell)
        throw UserError("Stator/Piezoceramic element = shell is incompatible with " +
                        stator.file_entry() +
                        ", which has the ceramic ring in its solid cells; allowed: solid");
      check_files("Stator", stator);
    }

    void check_dimensions(const StatorGeometry &stator, const Motor &motor, const Wave &wave)
    {
      check_cross_section(stator, motor.n_teeth);
      check_amplitude(wave, "Stator/Base thickness", stator.base_thickness);
    }

    /** The entries that describe the rotor of a motor. */
    std::vector<std::string> entries_of_rotor(const RotorGeometry &rotor)
    {
      const std::string metal = "Materials/Rotor metal/";
      return rotor.has_dimensions() ? std::vector<std::string>{"Rotor/", metal}
                                    : std::vector<std::string>{metal};
    }
  } // namespace

  void check_for_stator(const Parameters &parameters)
  {
    const StatorGeometry &stator = parameters.stator;
    check_wave(parameters.motor);
    check_modes(parameters);
    parameters.support.check();
    if (parameters.modes.body == Body::rotor)
    {
      check_files("Rotor", parameters.rotor);
      check_given(parameters, "Modes/Body = rotor needs a rotor",
                  entries_of_rotor(parameters.rotor));
      check_rotor(parameters.rotor);
      return;
    }
    if (!stator.has_dimensions())
    {
      check_stator_files(stator);
      return;
    }
    check_thin_parts(stator);
    check_dimensions(stator, parameters.motor, parameters.wave);
  }

  namespace
  {
    /** The wave must be among the modes that the program stator computes. */
    void check_modes_for_contact(const Parameters &parameters)
    {
      if (parameters.modes.domain == Domain::ring)
        throw UserError("Modes/Domain = ring has no wave for contact and losses; allowed: sector");
      const std::vector<unsigned int> all = nodal_diameters_of(parameters);
      if (std::find(all.begin(), all.end(), parameters.motor.n_waves) == all.end())
        throw UserError("Modes/Nodal diameters do not include the wave of the motor, " +
                        entry("Motor/Number of waves", parameters.motor.n_waves) +
                        ", which contact and losses need; allowed: wave, or a list with it");
    }

    void check_friction(const Friction &friction)
    {
      for (const auto &[name, value] :
           {std::make_pair("Dynamic coefficient", friction.dynamic_coefficient),
            std::make_pair("Static coefficient", friction.static_coefficient)})
        if (value <= 0.)
          throw UserError(std::string("Friction/") + name + " = " + short_text(value) +
                          "; allowed: a number above 0, as without friction the wave does not "
                          "drive the rotor, and its speed is not determined");
    }

    void check_springs(const Parameters &parameters)
    {
      const Contact &contact = parameters.contact;
      if (contact.formulation == ContactFormulation::penalty &&
          (!contact.normal_penalty || !contact.tangential_penalty))
        throw UserError("Contact/Formulation = penalty needs Contact/Normal penalty and "
                        "Contact/Tangential penalty; give both in N/m");
    }

    void check_time(const Parameters &parameters)
    {
      const Time &time  = parameters.time;
      const auto &first = time.average_from_step, &last = time.average_to_step, &n = time.n_steps;
      const auto shown = [](const std::string &path, const std::optional<unsigned int> &count)
      { return count ? entry(path, *count) : path + " = auto"; };
      if ((first || last || n) &&
          !(first >= 2u && first <= last && last <= n)) // auto compares less than any number
        throw UserError(shown("Time/Average from step", first) + " and " +
                        shown("Time/Average to step", last) + " are incompatible with " +
                        shown("Time/Number of steps", n) + "; allowed: all three auto, or " +
                        "2 <= Average from step <= Average to step <= Number of steps");
    }
  } // namespace

  std::vector<std::string> check_for_contact(const Parameters &parameters)
  {
    check_stator_files(parameters.stator);
    check_files("Rotor", parameters.rotor);
    std::vector<std::string> needed = entries_of_rotor(parameters.rotor);
    needed.insert(needed.end(), {"Loading/", "Friction/"});
    check_given(
        parameters,
        "contact and losses need a rotor, its preload and its friction; for the modes of the "
        "stator alone, run the program stator",
        needed);
    check_wave(parameters.motor);
    parameters.support.check();
    check_modes_for_contact(parameters);
    if (parameters.stator.has_dimensions())
      check_dimensions(parameters.stator, parameters.motor, parameters.wave);
    check_rotor(parameters.rotor);
    if (parameters.has_dimensions())
      check_clearance(parameters.stator, parameters.rotor);
    check_friction(parameters.friction);
    check_springs(parameters);
    check_time(parameters);
    std::vector<std::string> warnings;
    if (parameters.wave.drive == Drive::amplitude)
    {
      const std::string without = " has no effect with Wave/Drive = amplitude";
      if (parameters.wave.voltage)
        warnings.push_back(entry("Wave/Voltage", *parameters.wave.voltage) + without);
      if (!parameters.wave.response_torques.empty())
        warnings.push_back("Wave/Response torques" + without);
    }
    if (parameters.friction.dynamic_coefficient > parameters.friction.static_coefficient &&
        parameters.friction.law.entry().has_static_coefficient)
      warnings.push_back("Friction/Dynamic coefficient is above Friction/Static coefficient: "
                         "this is unusual; the values are used as given");
    return warnings;
  }

  std::vector<std::string> check_for_losses(const Parameters &parameters)
  {
    std::vector<std::string> warnings = check_for_contact(parameters);
    check_given(parameters, "losses needs the loss factor of each material, 0 for one without loss",
                {"Materials/Stator metal/Loss factor"});
    return warnings;
  }
} // namespace ringmotor
