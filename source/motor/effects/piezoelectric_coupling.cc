// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/motor/electrode_layout.h>
#include <ringmotor/parameters/errors.h>

namespace ringmotor::effects
{
  namespace
  {
    /** The ceramic with its electric potential. */
    class PiezoelectricCoupling : public Effect
    {
    public:
      PiezoelectricCoupling()
          : Effect("Piezoelectric coupling", &Effects::piezoelectric_coupling, EffectStage::stator)
      {
      }

      void check(const Parameters &parameters) const override
      {
        if (parameters.stator.piezoceramic_element == ElementKind::shell)
          throw UserError(given(parameters) +
                          " is incompatible with Stator/Piezoceramic element = shell, which has no "
                          "potential; allowed: off, or Stator/Piezoceramic element = solid");
        if (parameters.stator.mesh_file.empty() && parameters.stator.piezoceramic_thickness == 0.)
          throw UserError(given(parameters) +
                          " needs a ceramic, but Stator/Piezoceramic thickness = 0; allowed: off, "
                          "or a thickness above 0");
        parameters.piezoelectricity.check();
        ElectrodeLayout(parameters.electrodes, parameters.motor, parameters.stator);
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
