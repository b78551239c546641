// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/motor/electrode_layout.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/required.h>

namespace ringmotor::effects
{
  namespace
  {
    /** The ceramic with its electric potential. */
    class PiezoelectricCoupling : public Effect
    {
    public:
      PiezoelectricCoupling()
          : Effect({"Piezoelectric coupling",
                    "Electric potential of the ceramic, with the constants of the section "
                    "Piezoelectricity instead of an isotropic ceramic; needed for voltages and "
                    "currents. \"auto\" means off without these constants.",
                    EffectChoice::automatic, true, "Piezoelectricity/"},
                   EffectStage::stator)
      {
      }

      void check(const Parameters &parameters) const override
      {
        if (parameters.stator.piezoceramic_element == ElementKind::shell)
          throw UserError(given(parameters) +
                          " is incompatible with Stator/Piezoceramic element = shell, which has no "
                          "potential; allowed: off, or Stator/Piezoceramic element = solid");
        if (parameters.stator.has_dimensions() && parameters.stator.piezoceramic_thickness == 0.)
          throw UserError(given(parameters) +
                          " needs a ceramic, but Stator/Piezoceramic thickness = 0; allowed: off, "
                          "or a thickness above 0");
        check_given(parameters,
                    given(parameters) + " needs the constants of the ceramic and the loss factors "
                                        "of the stator",
                    {"Piezoelectricity/", "Materials/Stator metal/Loss factor",
                     "Materials/Piezoceramic/Loss factor"});
        parameters.piezoelectricity.check();
        const Materials &materials = parameters.materials;
        if (materials.stator_metal.loss_factor == 0. && materials.piezoceramic.loss_factor == 0. &&
            parameters.piezoelectricity.dielectric_loss_factor == 0.)
          throw UserError(
              given(parameters) +
              " needs a loss: Materials/Stator metal/Loss factor, Materials/Piezoceramic/"
              "Loss factor and Piezoelectricity/Dielectric loss factor are all 0; "
              "allowed: one of them above 0");
        const double thickness = parameters.stator.piezoceramic_thickness;
        if (parameters.stator.has_dimensions() && parameters.electrodes.arc_gap < 0.5 * thickness)
          throw UserError(
              ringmotor::entry("Electrodes/Gap between arcs", parameters.electrodes.arc_gap) +
              " is less than half of " +
              ringmotor::entry("Stator/Piezoceramic thickness", thickness) +
              ", so narrow that the fields there are not resolved; allowed: at least half "
              "of it");
        ElectrodeLayout(parameters.electrodes, parameters.motor,
                        mean_radius_of_ceramic(parameters));
      }

      std::vector<std::string> warnings(const Parameters &parameters) const override
      {
        return parameters.piezoelectricity.warnings();
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        model.ceramic = parameters.piezoelectricity.law();
      }

      void forget(Parameters &parameters) const override
      {
        parameters.piezoelectricity = {};
        parameters.electrodes       = {};
      }

      /** The change of the frequency against an isotropic ceramic. As modes are computed for it,
       * only where it decides. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        if (choice(scene.parameters) != EffectChoice::automatic)
          return {};
        return measured_in(scene);
      }
    };
  } // namespace

  EffectPointer piezoelectric_coupling()
  {
    return std::make_unique<const PiezoelectricCoupling>();
  }
} // namespace ringmotor::effects
