// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * A complex displacement amplitude on one whole sector, sampled on a lattice in every cell: what
   * output needs to plot the sector or, by rotation, the whole ring. The motion is
   * Re(displacement * exp(i omega t)); sector j has exp(-i n j alpha) R(j alpha) displacement at
   * the positions R(j alpha) points, alpha = 2 pi / n_sectors.
   */
  struct SectorField
  {
    struct Cell
    {
      /** (order + 1)^3 lattice positions in m, first index fastest, right-handed. */
      std::vector<dealii::Point<3>> points;
      /** Cartesian complex displacement amplitudes in m at these positions. */
      std::vector<std::array<std::complex<double>, 3>> displacement;
      /** Strain energy per volume in J/m^3 there, the mean over a period. In a shell it is that of
       * the whole cell. */
      std::vector<double> strain_energy;
      /** Material of the cell, see mesh/ids.h. */
      dealii::types::material_id material;
      /** Complex amplitude of the electric potential in V there, at short circuit; empty in a cell
       * without one. */
      std::vector<std::complex<double>> potential = {};
    };

    unsigned int order = 1;           ///< subdivisions of a cell per direction
    std::vector<Cell> cells;          ///< all cells of one sector
    unsigned int n_sectors      = 1;  ///< N, number of teeth
    unsigned int nodal_diameter = 0;  ///< n, number of waves around the ring
    double angular_frequency    = 0.; ///< omega in rad/s
  };

  /** Samples @p mode on @p order subdivisions per cell; a half sector is completed by its mirror
   * image. */
  SectorField sample_sector(const CyclicSector &sector, const Mode &mode, const unsigned int order);
} // namespace ringmotor
