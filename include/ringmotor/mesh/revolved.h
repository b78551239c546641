// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/section.h>
#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/mesh/slots.h>

#include <vector>

namespace ringmotor
{
  /** Which cells of a body are meshed. */
  enum class SectorParts
  {
    all,
    tooth ///< those of one tooth alone; its foot has the id ids::tooth_foot
  };

  /** How a section is revolved. */
  struct Revolution
  {
    SectorForm form   = SectorForm::half;
    SectorParts parts = SectorParts::all;
    /** Places from the tooth's centre, 0, to its side, 1, and on to the cut, 2, in ascending order
     * with these three; without teeth, from 0 to the cut, 1. */
    std::vector<double> lines;
    unsigned int n_layers = 0;   ///< of cells that shrink towards the roots of the slots
    double ratio          = 0.2; ///< of the distances of successive layers
  };

  /**
   * Revolves a section to the mesh of a sector. Cells of the part ids::tooth end at the sides of
   * the slots. At the roots of the slots, layers of cells are nested as in with_layers(); as they
   * must not end inside a body, they continue along the row of cells at the roots. Where rows would
   * cross, as where a slot ends at a wall across it, there are no such layers.
   */
  SectorMesh revolve(const Section &section, const Slots &slots, const Revolution &revolution,
                     MPI_Comm communicator);

  /** Where teeth meet what is below them. */
  std::vector<Section::Edge> feet_of_teeth(const Section &section);

  /** The slots of a section, for these walls, see Slots. */
  Slots slots_of(const Section &section, const unsigned int n_teeth, const double width,
                 const std::optional<double> &angle = {});

  /** Edges at the roots of the slots: for each cell the corner at which its edge begins, see
   * Section::edge(). */
  struct RootEdges
  {
    static constexpr unsigned int none = 4;
    std::vector<unsigned int> of_cells;
    bool cross = false; ///< a cell has two of them
  };

  /** Those where a tooth meets what is below it, and where the row of cells at them continues. */
  RootEdges root_edges(const Section &section);
} // namespace ringmotor
