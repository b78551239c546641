// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/warp.h>
#include <ringmotor/output/lattice_output.h>
#include <ringmotor/pictures/sector_field.h>

#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * Writes one sector as a VTU file of Lagrange cells. Point fields: `displacement_real`,
   * `displacement_imaginary` (Cartesian vectors, m; the motion is real cos(omega t) - imaginary
   * sin(omega t)), `amplitude_radial`, `amplitude_tangential`, `amplitude_axial` (zero-to-peak, m;
   * three scalars, as the components of a vector would be called X, Y, Z on the screen),
   * `strain_energy` (per volume, J/m^3, the mean over a period), `material` (see mesh/ids.h).
   *
   * @throw UserError if writing fails
   */
  void write_sector(const std::string &path, const SectorField &field);

  /**
   * Writes the travelling wave on the whole ring over one period: @p n_frames files
   * `<path>_00.vtu`, ... of Lagrange cells, frame k at the time k T / n_frames, and finally
   * `<path>.pvd` with the times in seconds. Point fields: `displacement` (Cartesian vector, m;
   * for "Warp By Vector") and `material`. Cells of the same material share their points.
   *
   * @throw UserError if writing fails; then there is no PVD file
   */
  void write_ring_animation(const std::string &path, const SectorField &field,
                            unsigned int n_frames);

  /** Writes the whole ring at a time (s) as one of these files, on a warp at rest. */
  void write_ring_at(const std::string &path, const SectorField &field, const double time,
                     const Warp &warp);

  /**
   * Writes the whole ring with a scalar that is the same in all sectors and `material`, as a VTU
   * file of Lagrange cells.
   *
   * @param values by cell of the sector, then by point of the cell
   * @throw UserError if writing fails
   */
  void write_ring_scalar(const std::string &path, const SectorField &field, const FieldName &name,
                         const std::vector<std::vector<double>> &values);

  /** Writes a list of VTU files, each with its time (or whatever ParaView's time stands for).
   * Consecutive files with the same time are parts of one picture. */
  void write_pvd(const std::string &path,
                 const std::vector<std::pair<double, std::string>> &times_and_names);
} // namespace ringmotor
