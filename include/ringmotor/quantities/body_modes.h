// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>
#include <ringmotor/quantities/mode_search.h>

#include <functional>

namespace ringmotor
{
  /** What the parts of a body are made of. */
  MaterialTable material_table(const Materials &materials, const Body body);

  /** One computation on the way to the wanted accuracy. */
  struct Pass
  {
    unsigned int number = 0; ///< from 1
    unsigned int degree = 0; ///< of the finite elements
    unsigned int level  = 0; ///< of the mesh, as Accuracy/Refinement, before sheets were cut
    std::size_t n_cells = 0;
    unsigned int n_dofs = 0;
    double seconds      = 0.; ///< wall clock
  };

  /**
   * The modes of a body of the motor (`Modes/Body`), from a mesh of its sector that is refined
   * until the frequencies are as accurate as `Accuracy/Target` asks for (or, `Accuracy/Mode =
   * fixed`, from the mesh asked for).
   */
  class BodyModes
  {
  public:
    BodyModes(const Parameters &parameters, MPI_Comm communicator);

    /**
     * Computes them; @p after_pass is called after each pass, when search() holds its results.
     * @throws UserError for a mesh file that is not fit
     * @throws ComputationError if the target is out of reach
     */
    void find(const std::function<void(const Pass &)> &after_pass);

    /**
     * Computes them on a ladder of meshes and degrees, whatever the accuracy asked for; for
     * find()'s @p after_pass.
     */
    void climb(const std::function<void(const Pass &)> &after_pass);

    const ModeSearch &search() const { return mode_search; }

  private:
    bool is_generated() const;
    void make_mesh(const unsigned int new_level);
    void make_stator_mesh();
    void compute_pass(const unsigned int degree,
                      const std::function<void(const Pass &)> &after_pass);
    [[noreturn]] void give_up() const;

    const Parameters &parameters;
    const MPI_Comm communicator;
    SectorMesh mesh;
    ModeSearch mode_search;
    unsigned int n_passes = 0, level = 0;
  };
} // namespace ringmotor
