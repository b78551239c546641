// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/fingerprint.h>
#include <ringmotor/parameters/prm_file.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Gives some materials the loss factors that they have in @p from. */
    void set_loss_factors(Parameters &parameters, const Materials &from,
                          const std::vector<Material Materials::*> &materials)
    {
      for (Material Materials::*material : materials)
        (parameters.materials.*material).loss_factor = (from.*material).loss_factor;
    }

    /** Only the program losses reads them, and the circuits that stator prints. */
    void reset_loss_factors(Parameters &parameters)
    {
      const Piezoelectricity of_ceramic;
      parameters.piezoelectricity.dielectric_loss_factor    = of_ceramic.dielectric_loss_factor;
      parameters.piezoelectricity.piezoelectric_loss_factor = of_ceramic.piezoelectric_loss_factor;
      set_loss_factors(parameters, Materials(),
                       {&Materials::stator_metal, &Materials::piezoceramic, &Materials::rotor_metal,
                        &Materials::target_plate, &Materials::lining, &Materials::adhesive});
    }

    /** Whatever drives a wave, its motion at a given amplitude is the same. */
    void forget_drive(Parameters &parameters)
    {
      parameters.wave.drive   = Drive::amplitude;
      parameters.wave.voltage = {};
    }

    /** Resets the entries that affect no number in any file. */
    void forget_the_run(Parameters &parameters)
    {
      const Parameters defaults;
      parameters.motor.name                   = defaults.motor.name;
      parameters.motor.accepts_unusual_values = defaults.motor.accepts_unusual_values;
      parameters.uncertainty                  = defaults.uncertainty;
      parameters.accuracy.time_limit          = defaults.accuracy.time_limit;
      parameters.output.directory             = defaults.output.directory;
      parameters.output.figures               = defaults.output.figures;
    }

    /** Resets the materials of lining and adhesive. */
    void forget_layers(Parameters &parameters)
    {
      const Materials defaults;
      parameters.materials.lining   = defaults.lining;
      parameters.materials.adhesive = defaults.adhesive;
    }

    /** Restores the loss factors of the rotor's parts. */
    void keep_loss_of_rotor(Parameters &parameters, const Materials &given)
    {
      set_loss_factors(parameters, given, {&Materials::rotor_metal});
      if (!parameters.rotor.has_dimensions())
        set_loss_factors(parameters, given, {&Materials::lining, &Materials::adhesive});
    }

    /** Restores those of the stator's materials. */
    void keep_loss_of_stator(Parameters &parameters, const Materials &given)
    {
      set_loss_factors(
          parameters, given,
          {&Materials::stator_metal, &Materials::piezoceramic, &Materials::target_plate});
    }

    /** Resets the entries that only the programs contact and losses read. */
    void forget_after_the_wave(Parameters &parameters)
    {
      const Parameters defaults;
      parameters.rotor                 = defaults.rotor;
      parameters.materials.rotor_metal = defaults.materials.rotor_metal;
      forget_layers(parameters);
      parameters.loading             = defaults.loading;
      parameters.friction            = defaults.friction;
      parameters.initial_deformation = defaults.initial_deformation;
      parameters.contact             = defaults.contact;
      parameters.time                = defaults.time;
      forget_drive(parameters);
      parameters.wave.response_torques.clear();
      for (const auto &effect : all_effects())
        if (effect->stage != EffectStage::stator)
          parameters.effects[effect->name] = defaults.effects[effect->name];
    }

    /** Resets the entries that affect neither the wave nor any operating point. */
    void forget_what_never_matters(Parameters &parameters)
    {
      const Parameters defaults;
      forget_the_run(parameters);
      parameters.modes  = defaults.modes;
      parameters.output = defaults.output;
      reset_loss_factors(parameters);
      parameters.wave.response_torques.clear();
      if (parameters.rotor.has_dimensions())
      {
        forget_layers(parameters);
        parameters.rotor.shell_thickness = defaults.rotor.shell_thickness;
      }
      if (parameters.stator.section_file.empty())
        parameters.stator.slot_angle = defaults.stator.slot_angle;
      if (parameters.wave.drive == Drive::amplitude)
        parameters.wave.voltage = defaults.wave.voltage;
      for (const auto &effect : all_effects())
        if (effect->choice(parameters) == EffectChoice::off)
          effect->forget(parameters);
    }
  } // namespace

  Parameters relevant_for_points(Parameters relevant)
  {
    const Parameters defaults;
    const bool marched              = is_marched(relevant),
               needs_modes          = motor_model(relevant).rotor_needs_modes();
    const Materials materials       = relevant.materials;
    relevant.loading.control        = defaults.loading.control;
    relevant.loading.values         = defaults.loading.values;
    relevant.loading.n_curve_points = defaults.loading.n_curve_points;
    if (!marched) // marching continues until changes are small against the target
    {
      relevant.accuracy.contact_target = defaults.accuracy.contact_target;
      relevant.accuracy.quantities     = defaults.accuracy.quantities;
    }
    relevant.accuracy.time_limit           = defaults.accuracy.time_limit;
    relevant.accuracy.mode                 = defaults.accuracy.mode;
    relevant.accuracy.interface_refinement = defaults.accuracy.interface_refinement;
    relevant.accuracy.rotor_modes          = defaults.accuracy.rotor_modes;
    const bool stator_gives_way            = motor_model(relevant).stator_gives_way;
    if (!stator_gives_way)
      relevant.support = defaults.support;
    relevant.electrodes = defaults.electrodes;
    forget_what_never_matters(relevant);
    if (needs_modes)
      keep_loss_of_rotor(relevant, materials);
    if (stator_gives_way)
      keep_loss_of_stator(relevant, materials);
    return relevant;
  }

  Parameters relevant_for_condensation(const Parameters &parameters)
  {
    const Parameters defaults;
    Parameters relevant              = relevant_for_points(parameters);
    const Friction friction          = relevant.friction;
    relevant.loading                 = defaults.loading;
    relevant.accuracy.contact_target = defaults.accuracy.contact_target;
    relevant.accuracy.quantities     = defaults.accuracy.quantities;
    relevant.friction                = defaults.friction;
    relevant.time                    = defaults.time;
    relevant.initial_deformation     = defaults.initial_deformation;
    forget_drive(relevant);
    // The condensed bodies include the lining, but do not depend on the friction law.
    relevant.friction.lining_normal_stiffness     = friction.lining_normal_stiffness;
    relevant.friction.lining_tangential_stiffness = friction.lining_tangential_stiffness;
    const MotorModel model                        = motor_model(parameters);
    if (model.has_inertia())
      relevant.time.spectral_radius = parameters.time.spectral_radius;
    if (model.rotor_moves_as_whole)
      relevant.time.scheme = TimeScheme::marching;
    return relevant;
  }

  Parameters relevant_for_wave(const Parameters &parameters)
  {
    Parameters relevant = parameters;
    forget_after_the_wave(relevant);
    relevant.accuracy = Accuracy();
    forget_what_never_matters(relevant);
    return relevant;
  }

  Parameters relevant_for_stator(const Parameters &parameters)
  {
    Parameters relevant = relevant_for_motor(parameters);
    if (parameters.modes.body != Body::stator) // an entry of the rotor may matter
      return relevant;
    forget_after_the_wave(relevant);
    relevant.output.history_points = Output().history_points;
    return relevant;
  }

  Parameters relevant_for_motor(const Parameters &parameters)
  {
    Parameters relevant = parameters;
    forget_the_run(relevant);
    return relevant;
  }

  std::vector<std::string> files_named_by(const Parameters &parameters)
  {
    Parameters copy = parameters; // which the names point into
    std::vector<std::string> files;
    for (const auto &[entry, file] : copy.mesh_files())
      if (!file->empty())
        files.push_back(*file);
    return files;
  }

  std::string text_of(const Parameters &parameters)
  {
    Parameters copy = parameters;
    for (const auto &[entry, mesh_file] : copy.mesh_files())
      if (!mesh_file->empty())
        *mesh_file = "content " + fingerprint_of_file(*mesh_file);
    ParameterHandler prm;
    copy.declare(prm);
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
    return text.str();
  }

  Identity identity_of(const Parameters &parameters, const std::string &programs)
  {
    return {fingerprint(programs + "\nstator\n" + text_of(relevant_for_stator(parameters))),
            fingerprint(programs + "\nmotor\n" + text_of(relevant_for_motor(parameters)))};
  }

  std::string difference(const std::string &text, const Parameters &parameters)
  {
    const std::vector<PrmFile::Assignment> there = parse_prm(text, "stored").assignments,
                                           here =
                                               parse_prm(text_of(parameters), "given").assignments;
    std::string first, first_effect; // an effect explains the entries that it reads
    for (unsigned int i = 0; i < std::max(there.size(), here.size()); ++i)
    {
      if (i >= there.size() || i >= here.size() || there[i].path != here[i].path)
        return "other entries there than here";
      if (there[i].value == here[i].value)
        continue;
      std::string &found =
          boost::algorithm::starts_with(here[i].path, "Effects/") ? first_effect : first;
      if (found.empty())
        found = here[i].path + " = " + there[i].value + " there, " + here[i].value + " here";
    }
    return first_effect.empty() ? first : first_effect;
  }
} // namespace ringmotor
