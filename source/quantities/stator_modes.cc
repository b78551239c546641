// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/quantities/stator_modes.h>

#include <chrono>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr unsigned int most_passes = 12, most_dofs = 400000;

    MaterialTable material_table(const Materials &materials)
    {
      return {{ids::base, materials.stator_metal},
              {ids::tooth, materials.stator_metal},
              {ids::piezoceramic, materials.piezoceramic}};
    }

    /** The grading of the mesh on which stators like the reference one reach a target at once. */
    unsigned int level_for(const double target)
    {
      return target >= 8e-4     ? 1
             : target >= 3e-4   ? 2
             : target >= 1.6e-4 ? 3
             : target >= 8e-5   ? 4
                                : 5;
    }
  } // namespace

  StatorModes::StatorModes(const Parameters &parameters, MPI_Comm communicator)
      : parameters(parameters), communicator(communicator),
        mode_search(material_table(parameters.materials), parameters.modes)
  {
  }

  void StatorModes::find(const std::function<void(const Pass &)> &after_pass)
  {
    // A cheap first pass finds out where the modes lie and gives the error bars something to
    // compare with.
    if (parameters.accuracy.mode == AccuracyMode::fixed)
    {
      const unsigned int degree = parameters.accuracy.polynomial_degree;
      mesh                      = make_mesh(0);
      compute_pass(degree - 1, after_pass);
      mesh = make_mesh(parameters.accuracy.refinement);
      compute_pass(degree, after_pass);
      return;
    }

    const unsigned int degree = 3; // the cheapest one for errors from 1e-2 to 3e-5
    // Two passes of one degree narrow the error bars down; for a rough target that is not worth it.
    const unsigned int first_degree = parameters.accuracy.target > 5e-4 ? degree - 1 : degree;
    mesh                            = make_mesh(0);
    compute_pass(first_degree, after_pass);
    if (parameters.stator.mesh_file.empty())
    {
      mesh = make_mesh(level_for(parameters.accuracy.target));
      compute_pass(degree, after_pass);
    }
    while (n_passes < 2 || mode_search.worst_relative_error() > parameters.accuracy.target)
    {
      if (n_passes == most_passes || mode_search.sector().dofs().n_dofs() > most_dofs)
        give_up();
      mode_search.refine(mesh);
      compute_pass(degree, after_pass);
    }
  }

  SectorMesh StatorModes::make_mesh(const unsigned int level) const
  {
    if (parameters.stator.mesh_file.empty())
      return make_stator_sector(parameters.stator, parameters.motor.n_teeth, SectorForm::half,
                                SectorGrading::level(level), communicator);
    SectorMesh sector =
        read_sector(parameters.stator.mesh_file, parameters.motor.n_teeth, communicator);
    sector.triangulation->refine_global(level);
    return sector;
  }

  void StatorModes::compute_pass(const unsigned int degree,
                                 const std::function<void(const Pass &)> &after_pass)
  {
    const auto begin = std::chrono::steady_clock::now();
    mode_search.compute(mesh, degree);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    after_pass({++n_passes, degree, mesh.triangulation->n_active_cells(),
                mode_search.sector().dofs().n_dofs(), seconds.count()});
  }

  void StatorModes::give_up() const
  {
    std::ostringstream message;
    message << "the frequencies are known to " << mode_search.worst_relative_error()
            << " (relative) after " << n_passes << " passes, the last one with "
            << mode_search.sector().dofs().n_dofs()
            << " degrees of freedom; Accuracy/Target = " << parameters.accuracy.target
            << " was not reached: choose a larger one";
    throw ComputationError(message.str());
  }
} // namespace ringmotor
