// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

namespace ringmotor
{
  namespace
  {
    const Variation stronger_drive{"stronger drive", nullptr, nullptr, true};

    /** The circuits of the phases that drive a wave: the numbers of VoltageDrive. */
    class ErrorOfCircuits : public ErrorCause
    {
    public:
      ErrorOfCircuits() : ErrorCause(causes::circuits) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        if (scene.parameters.wave.drive != Drive::voltage)
          return {};
        return {scene.for_variations().with(stronger_drive)};
      }

      PointError of(const PointRequest &request, const Discretisation &,
                    const ErrorScene &scene) const override
      {
        if (scene.parameters.wave.drive != Drive::voltage)
          return {};
        return scene.change_by(stronger_drive, request);
      }

      std::string remedy(const Parameters &parameters) const override
      {
        return std::string(parameters.wave.frequency
                               ? "; close to the resonance the frequency must be known well"
                               : "") +
               ": run the program stator with a smaller Accuracy/Target first, or choose a larger "
               "Contact target";
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_circuits()
  {
    return std::make_unique<const ErrorOfCircuits>();
  }
} // namespace ringmotor
