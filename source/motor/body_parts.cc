// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/body_parts.h>

#include <algorithm>
#include <array>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr std::array<types::boundary_id, 2> felt_ids{{ids::bottom, ids::skin}};
  } // namespace

  MaterialTable material_table(const Materials &materials, const Body body,
                               const std::optional<PiezoelectricLaw> &ceramic)
  {
    if (body == Body::rotor)
      return {{ids::rotor, materials.rotor_metal},
              {ids::lip_shell, materials.rotor_metal},
              {ids::lining, materials.lining},
              {ids::adhesive, materials.adhesive}};
    if (body == Body::tooth)
      return {{ids::tooth, materials.stator_metal}};
    MaterialTable table{{ids::base, materials.stator_metal},
                        {ids::tooth, materials.stator_metal},
                        {ids::piezoceramic, materials.piezoceramic}};
    table[ids::piezoceramic].law = ceramic;
    return table;
  }

  std::map<types::material_id, double>
  loss_factor_by_part(const MaterialTable &materials,
                      const std::map<types::material_id, double> &energies)
  {
    double stored = 0.;
    std::map<types::material_id, double> by_part;
    for (const auto &[part, energy] : energies)
      if (const auto material = materials.find(part); material != materials.end())
      {
        stored += energy;
        by_part[part] = energy * material->second.loss_factor;
      }
    if (stored <= 0.)
      return {};
    for (auto &[part, loss_factor] : by_part)
      loss_factor /= stored;
    return by_part;
  }

  bool is_on_felt(const types::boundary_id id)
  {
    return std::find(felt_ids.begin(), felt_ids.end(), id) != felt_ids.end();
  }

  void add_to_stator(const MotorModel &model, SectorMesh &mesh)
  {
    if (model.target_plates)
      mesh.bars[ids::target_plate] = *model.target_plates;
    if (model.felt_stiffness > 0.)
      for (const types::boundary_id id : felt_ids)
        mesh.foundations[id] = model.felt_stiffness;
  }
} // namespace ringmotor
