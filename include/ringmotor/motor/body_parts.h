// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/structure/potential_dofs.h>

#include <optional>

namespace ringmotor
{
  /** The materials of the parts of a body; the ceramic of a stator has a potential if it has a law.
   */
  MaterialTable material_table(const Materials &materials, const Body body,
                               const std::optional<PiezoelectricLaw> &ceramic = {});

  /** Lower faces of the stator's solids, bare or with the ceramic ring as a shell. */
  bool is_on_felt(const dealii::types::boundary_id id);

  /** Adds what @p model adds to the stator, target plates and felt, to its mesh. */
  void add_to_stator(const MotorModel &model, SectorMesh &mesh);
} // namespace ringmotor
