// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

namespace ringmotor
{
  namespace
  {
    /** Effects that `auto` has left out. */
    class ErrorOfEffects : public ErrorCause
    {
    public:
      ErrorOfEffects() : ErrorCause("effects left out") {}

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        return scene.left_out.of(scene.table.at(own, request));
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_effects()
  {
    return std::make_unique<const ErrorOfEffects>();
  }
} // namespace ringmotor
