// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/materials.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <vector>

namespace ringmotor
{
  /** The material of the cells of each material id. */
  using MaterialTable = std::map<dealii::types::material_id, Material>;

  /**
   * The degrees of freedom of the electric potential (V): FE_Q on the cells whose material has a
   * piezoelectric law, numbered from 0, and the two faces of their flat layer that are electrodes.
   */
  class PotentialDofs
  {
  public:
    using Dof  = dealii::types::global_dof_index;
    using Cell = dealii::Triangulation<3>::active_cell_iterator;

    PotentialDofs() = default;

    /**
     * @p triangulation must outlive this object.
     * @throws UserError if no faces of the cells lie in the lowest or in the highest plane of the
     * layer
     */
    void reinit(const dealii::Triangulation<3> &triangulation, const MaterialTable &materials,
                const unsigned int degree);

    /** Zero where no material is piezoelectric. */
    unsigned int size() const { return places.size(); }

    /** Whether a cell has a potential. */
    bool are_on(const Cell &cell) const;

    /** Those of such a cell, in the order of FE_Q. */
    std::vector<Dof> of(const Cell &cell) const;

    /** Those on a face of such a cell. */
    std::vector<Dof> on_face(const Cell &cell, const unsigned int face) const;

    /** Where one of a cell's has its node, on the unit cell. */
    const dealii::Point<3> &unit_point(const unsigned int i) const
    {
      return dof_handler.get_fe().get_unit_support_points()[i];
    }

    enum class Place
    {
      inside,
      lower_electrode, ///< the lower face of the layer, with the arcs of the phases
      upper_electrode  ///< the upper one, grounded
    };
    Place place(const Dof dof) const { return places[dof]; }

    /** Hanging nodes among those that are not on electrodes. */
    dealii::AffineConstraints<double> hanging_nodes() const;

    /** Those that this rank owns. */
    std::vector<Dof> owned() const;

  private:
    template <typename Visit>
    void for_each_cell(const Visit &visit) const;
    void find_electrodes();
    dealii::DoFHandler<3>::active_cell_iterator with_dofs(const Cell &cell) const;

    std::vector<bool> is_piezoelectric; ///< by material id
    dealii::DoFHandler<3> dof_handler;
    std::vector<unsigned int> number; ///< by degree of freedom of the whole mesh
    std::vector<Place> places;
  };
} // namespace ringmotor
