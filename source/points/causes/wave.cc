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

    /** The stator's wave, as the program `stator` estimates its error. */
    class ErrorOfWave : public ErrorCause
    {
    public:
      ErrorOfWave() : ErrorCause(causes::wave) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        return {scene.for_variations().with(larger_wave)};
      }

      PointError of(const PointRequest &request, const Discretisation &,
                    const ErrorScene &scene) const override
      {
        return scene.change_by(larger_wave, request);
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_wave()
  {
    return std::make_unique<const ErrorOfWave>();
  }
} // namespace ringmotor
