// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/causes/list.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <array>

namespace ringmotor
{
  namespace
  {
    /** What meshes of a level were found to be off by where they agree with the next coarser one by
     * chance, see accuracy_and_cost.md: the coarsest ones are far from the regime of convergence,
     * only from level 3 on a change shows the division around the teeth, and the share of sticking
     * nodes changes with every layer of cells. The fewer teeth touch, the more a node counts. */
    PointError least_error(const unsigned int level, const CurvePoint &point,
                           const double crest_speed)
    {
      constexpr std::array<double, ContactDiscretisation::finest_level + 1> of_speed{
          {5e-3, 5e-3, 2.5e-3, 0., 0.}},
          of_loss{{2e-2, 2e-2, 1e-2, 0., 0.}};
      constexpr double of_sticking = 0.06, usual_teeth = 3.;
      PointError least        = shares_of(point, crest_speed, of_speed[level], of_loss[level]);
      least["stick_fraction"] = of_sticking;
      const double teeth      = std::max(1., point.result.teeth_in_contact);
      return std::max(1., usual_teeth / teeth) * least;
    }

    /** Meshes of bodies and interface: from the change from the next coarser ones, with a margin,
     * as convergence is not regular at the edge of contact. */
    class ErrorOfMeshes : public ErrorCause
    {
    public:
      ErrorOfMeshes() : ErrorCause(causes::meshes, Cure::meshes) {}

      std::vector<Discretisation> needs(const ErrorScene &scene) const override
      {
        return {scene.plain(), scene.plain(ErrorScene::compared_with(scene.level))};
      }

      PointError of(const PointRequest &request, const Discretisation &,
                    const ErrorScene &scene) const override
      {
        const unsigned int coarser_level = ErrorScene::compared_with(scene.level);
        const CurvePoint &point          = scene.table.at(scene.plain(), request),
                         &coarser        = scene.table.at(scene.plain(coarser_level), request);
        const bool is_coarse             = coarser_level == 0 || coarser_level > scene.level;
        // From level 1 on, each step of the sequence divides errors by about four: what remains is
        // a third of the last change, seldom three quarters of it, and the last change is a quarter
        // of the one before unless it happens to be small. With inertia impacts scatter on every
        // mesh.
        const double margin = is_coarse           ? 2.
                              : scene.has_inertia ? 1.25
                                                  : 0.75,
                     ratio  = scene.has_inertia ? 3. : 4.;
        PointError error    = margin * change(coarser, point);
        if (!is_coarse)
          if (const CurvePoint *const before =
                  scene.table.find(scene.plain(coarser_level - 1), request))
            error.raise(margin / ratio * change(*before, coarser));
        error.raise(least_of(point, scene));
        return error.raise(least_of_power(point, error));
      }

      PointError least_of(const CurvePoint &point, const ErrorScene &scene) const override
      {
        return least_error(scene.level, point, scene.crest_speed(point));
      }
    };
  } // namespace

  std::unique_ptr<const ErrorCause> causes::of_meshes()
  {
    return std::make_unique<const ErrorOfMeshes>();
  }
} // namespace ringmotor
