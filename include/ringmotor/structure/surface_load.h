// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <array>
#include <complex>
#include <functional>

namespace ringmotor
{
  /** Complex Cartesian traction (N/m^2) at a point of a surface. */
  using Traction = std::function<std::array<std::complex<double>, 3>(const dealii::Point<3> &)>;

  /** Forces of a @p traction on the faces of solids with this boundary id, for
   * CyclicSector::loads_of(). */
  SectorMotion face_load(const SectorElements &sector, const dealii::types::boundary_id faces,
                         const Traction &traction);

  /** Forces and moments of a @p traction on the lower faces of the shell's cells with this material
   * id. */
  SectorMotion lower_face_load(const SectorElements &sector, const dealii::types::material_id cells,
                               const Traction &traction);
} // namespace ringmotor
