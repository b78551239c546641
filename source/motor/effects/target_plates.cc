// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/effects/list.h>
#include <ringmotor/parameters/check_geometry.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/parameters/required.h>

#include <sstream>

namespace ringmotor::effects
{
  namespace
  {
    /** Thin plates bonded to the tooth edges as targets of an optical measurement. */
    class TargetPlates : public Effect
    {
    public:
      TargetPlates()
          : Effect({"Target plates",
                    "Thin plates bonded to the tooth edges as targets of an optical measurement, "
                    "given by Stator/Target plate cross-section and Materials/Target plate.",
                    EffectChoice::off, false},
                   EffectStage::stator)
      {
      }

      void check(const Parameters &parameters) const override
      {
        const StatorGeometry &stator = parameters.stator;
        if (!stator.has_dimensions())
          throw UserError(given(parameters) + " is incompatible with " + stator.file_entry() +
                          ", where the size of the teeth is not known; allowed: off");
        if (!stator.target_plate_area)
          throw UserError(given(parameters) +
                          " needs Stator/Target plate cross-section, found none; "
                          "give it in m^2");
        check_given(parameters, given(parameters) + " needs their material", {material});
        const double largest = 0.1 * stator.tooth_height * stator.tooth_height;
        if (*stator.target_plate_area <= largest)
          return;
        std::ostringstream text;
        text << "Stator/Target plate cross-section = " << *stator.target_plate_area
             << " m^2 is too large for a thin plate on teeth of "
             << ringmotor::entry("Stator/Tooth height", stator.tooth_height)
             << "; allowed: up to a tenth of the height's square, " << largest << " m^2";
        throw UserError(text.str());
      }

      void enter(const Parameters &parameters, MotorModel &model) const override
      {
        const Material &metal = parameters.materials.target_plate;
        const double area     = *parameters.stator.target_plate_area;
        model.target_plates   = {area * metal.young_modulus, area * metal.density};
      }

      void forget(Parameters &parameters) const override
      {
        const Parameters defaults;
        parameters.stator.target_plate_area = defaults.stator.target_plate_area;
        parameters.materials.target_plate   = defaults.materials.target_plate;
      }

      /** None where they are not given. */
      std::optional<double> indicator(const Scene &scene) const override
      {
        const Parameters &parameters = scene.parameters;
        const bool are_given =
            parameters.stator.target_plate_area && missing_entries(parameters, {material}).empty();
        return are_given ? measured_in(scene) : std::nullopt;
      }

    private:
      const std::string material = "Materials/Target plate/";
    };
  } // namespace

  EffectPointer target_plates()
  {
    return std::make_unique<const TargetPlates>();
  }
} // namespace ringmotor::effects
