// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

namespace ringmotor
{
  namespace
  {
    /** Larger in its tangential and radial, but not in its axial motion. */
    const Variation larger_wave{"larger wave", nullptr,
                                [](MotorInUse &motor, const double wave_error)
                                {
                                  for (auto &motion : motor.wave.free_motion)
                                    for (const unsigned int c : {1u, 2u})
                                      motion[c] *= 1. + wave_error;
                                }};

    /** With all numbers of VoltageDrive off by their errors. */
    const Variation stronger_drive{"stronger drive", nullptr, nullptr, true};

    bool is_driven(const Parameters &parameters)
    {
      return parameters.wave.drive == Drive::voltage;
    }

    /** The stator's wave and the circuits that drive it, as the program `stator` estimates their
     * errors: those of the same mesh. */
    class ErrorOfWave : public ErrorCause
    {
    public:
      ErrorOfWave() : ErrorCause(causes::wave) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        std::vector<Discretisation> needed{scene.for_variations().with(larger_wave)};
        if (is_driven(scene.parameters))
          needed.push_back(scene.for_variations().with(stronger_drive));
        return needed;
      }

      PointError of(const PointRequest &request, const Discretisation &,
                    const ErrorScene &scene) const override
      {
        PointError error = scene.change_by(larger_wave, request);
        if (is_driven(scene.parameters))
          error += scene.change_by(stronger_drive, request);
        return error;
      }

      std::string remedy(const Parameters &parameters) const override
      {
        if (!is_driven(parameters))
          return "";
        return std::string(parameters.wave.frequency
                               ? "; close to the resonance the frequency must be known well"
                               : "") +
               ": run the program stator with a smaller Accuracy/Target first, or choose a larger "
               "Contact target";
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_wave()
  {
    return std::make_unique<const ErrorOfWave>();
  }
} // namespace ringmotor
