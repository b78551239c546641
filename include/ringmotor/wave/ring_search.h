// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/ring_solver.h>
#include <ringmotor/wave/body_modes.h>
#include <ringmotor/wave/ring_content.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ringmotor
{
  /** An elastic mode of a whole ring with the error bar of its frequency. */
  struct FoundRingMode
  {
    Mode mode;
    RingContent content;
    Estimate frequency; ///< Hz
    double computed;    ///< Hz, on the mesh: an upper bound, with which pairs are compared
  };

  /**
   * Modes of a whole ring (`Modes/Domain = ring`) without any symmetry, those nearest to
   * `Modes/Frequency target`: of copies of the sector, or of a mesh file of the whole ring. The
   * mesh is refined until the frequencies meet `Accuracy/Target`, or as `Accuracy/Mode = fixed`
   * says. Its cells are divided over the ranks by METIS. Effects that are `auto` are included, as
   * they cost next to nothing here.
   */
  class RingSearch
  {
  public:
    RingSearch(const Parameters &parameters, MPI_Comm communicator);

    /**
     * Finds them; @p after_pass is called after each pass, when modes() are those of its mesh.
     * @throws UserError for an unsuitable mesh file
     * @throws ComputationError if a target is out of reach or modes are missing
     */
    void find(const std::function<void(const Pass &)> &after_pass);

    /** Sorted by frequency. */
    const std::vector<FoundRingMode> &modes() const { return found; }
    const CyclicSector &ring() const { return *model; }
    double worst_relative_error() const;
    /** Modes that the factorisations count, but the eigensolver did not find. */
    unsigned int n_missed() const { return missed; }

  private:
    void make_mesh(const unsigned int level);
    Pass compute(const unsigned int degree);
    void refine();

    const Parameters parameters;
    const MPI_Comm communicator;
    SectorMesh mesh;
    std::unique_ptr<CyclicSector> model;
    std::optional<ShiftWindow> shifts; ///< once the modes are located
    std::vector<FoundRingMode> found;
    std::vector<double> sheet_error; ///< by sheet of the last mesh, summed over the modes
    unsigned int missed = 0, n_passes = 0, level = 0;
  };
} // namespace ringmotor
