// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

namespace ringmotor
{
  namespace
  {
    const Variation settled_means{"settled means", [](Parameters &parameters)
                                  {
                                    parameters.time.n_steps           = {};
                                    parameters.time.average_from_step = {};
                                    parameters.time.average_to_step   = {};
                                  }};

    bool has_window(const ErrorScene &scene)
    {
      return is_marched(scene.parameters) && scene.parameters.time.n_steps;
    }

    /** The averages of a marched motor: those of the window that a user has given against those of
     * the settled motion, and how far that has settled. */
    class ErrorOfWindow : public ErrorCause
    {
    public:
      ErrorOfWindow() : ErrorCause("averaging window") {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        if (!has_window(scene))
          return {};
        return {scene.for_variations(), scene.for_variations().with(settled_means)};
      }

      PointError of(const PointRequest &request, const Discretisation &own,
                    const ErrorScene &scene) const override
      {
        if (!has_window(scene))
          return scene.table.at(own, request).unsettled_means;
        // What a window misses hardly depends on mesh and steps.
        return scene.change_by(settled_means, request) +
               scene.table.at(scene.for_variations().with(settled_means), request).unsettled_means;
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_window()
  {
    return std::make_unique<const ErrorOfWindow>();
  }
} // namespace ringmotor
