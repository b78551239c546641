// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/sector_mesh.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/structure/potential_dofs.h>

#include <map>
#include <optional>

namespace ringmotor
{
  /** The materials of the parts of a body; the ceramic of a stator has a potential if it has a law.
   */
  MaterialTable material_table(const Materials &materials, const Body body,
                               const std::optional<PiezoelectricLaw> &ceramic = {});

  /** The loss factor of a body as a sum over its parts: that of each material, weighted with the
   * share that its part has of their elastic energies. Empty if none stores any.
   * @param energies by part, in any unit; those of parts without material do not count */
  std::map<dealii::types::material_id, double>
  loss_factor_by_part(const MaterialTable &materials,
                      const std::map<dealii::types::material_id, double> &energies);

  /** Lower faces of the stator's solids, bare or with the ceramic ring as a shell. */
  bool is_on_felt(const dealii::types::boundary_id id);

  /** Adds what @p model adds to the stator, target plates and felt, to its mesh. */
  void add_to_stator(const MotorModel &model, SectorMesh &mesh);
} // namespace ringmotor
