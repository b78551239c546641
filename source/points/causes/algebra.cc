// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

namespace ringmotor
{
  namespace
  {
    /** The residual of the laws of contact and friction, and what the search for amplitude and
     * frequency of the wave leaves open: where the state jumps with these, it does so by one
     * contact node and one step. */
    class ErrorOfAlgebra : public ErrorCause
    {
    public:
      ErrorOfAlgebra() : ErrorCause("algebra", Cure::steps) {}

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        const CurvePoint &point = scene.table.at(own, request);
        PointError error        = point.largest_violation * sizes_of(point) + point.unsettled;
        if (scene.parameters.wave.drive != Drive::voltage)
          error["amplitude"] = 0.; // it is given
        return error;
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_algebra()
  {
    return std::make_unique<const ErrorOfAlgebra>();
  }
} // namespace ringmotor
