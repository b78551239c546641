// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/modes.h>
#include <ringmotor/wave/frequency_error.h>
#include <ringmotor/wave/mode_content.h>

#include <map>
#include <memory>

namespace ringmotor
{
  /** An elastic mode with its kind and the error bar of its frequency. */
  struct FoundMode
  {
    Mode mode;
    ModeContent content;
    std::vector<FrequencySample> samples; ///< one for each pass, the last one on this mesh
    Estimate frequency;                   ///< Hz
  };

  /**
   * Finds the requested modes on a sequence of meshes until their error bars are small enough:
   * compute(), check worst_relative_error(), refine() the mesh, and so on.
   */
  class ModeSearch
  {
  public:
    /** @param ranks share the nodal diameters, if they all call compute() and each has the whole
     * mesh */
    ModeSearch(const MaterialTable &materials, const Modes &request,
               MPI_Comm ranks = MPI_COMM_SELF);

    /**
     * Computes all requested modes on @p mesh with elements of @p degree. The first call, on a
     * coarse mesh, also locates them in the spectrum. The mesh must outlive the use of sector().
     * With linear elements, which have no part of highest degree to judge the error by, error bars
     * are zero: they serve comparisons only.
     * @throws ComputationError if the spectrum cannot be proven complete.
     */
    void compute(const SectorMesh &mesh, const unsigned int degree);

    /** The largest relative error bar of a frequency. */
    double worst_relative_error() const;

    /**
     * Cuts the sheets of @p mesh, the one of the last compute(), that carry most of the error for
     * their number of cells. sector() and the modes' displacements are invalid afterwards.
     */
    void refine(SectorMesh &mesh);

    const std::vector<FoundMode> &modes() const { return found; }
    const CyclicSector &sector() const { return *model; }

    /** The motor's mode: out of plane, without nodal circle, of nodal diameter @p n_waves; null if
     * it was not requested. */
    const FoundMode *working_mode(const unsigned int n_waves) const;

    /** Number of modes that the factorisations of the last compute() count, but the eigensolver did
     * not find. */
    unsigned int n_missed() const { return missed; }

  private:
    std::vector<Mode> requested_modes(ModeSolver &solver);
    std::vector<Mode> modes_below_shift(ModeSolver &solver, const unsigned int k) const;
    std::vector<FrequencySample> earlier_samples(const Mode &mode, const Family family,
                                                 const unsigned int rank) const;

    const MaterialTable materials;
    const Modes request;
    const MPI_Comm ranks;
    std::map<unsigned int, double> shifts; ///< by nodal diameter, rad^2/s^2
    std::unique_ptr<CyclicSector> model;
    std::vector<FoundMode> found;
    std::vector<double> sheet_error; ///< by sheet of the last mesh, summed over the modes
    unsigned int missed = 0;
  };
} // namespace ringmotor
