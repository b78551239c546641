// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/motion_products.h>

#include <deal.II/base/mpi.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Motions = std::vector<const SectorMotion *>;

    /** The values of all motions at these degrees of freedom: real and imaginary part in turn. */
    std::vector<Vector<double>> values_at(const Motions &motions, ComplexField SectorMotion::*part,
                                          const std::vector<SectorNodes::Dof> &dofs)
    {
      std::vector<Vector<double>> values;
      for (const SectorMotion *motion : motions)
        for (const Vector<double> *field : {&(motion->*part).real, &(motion->*part).imaginary})
        {
          values.emplace_back(dofs.size());
          for (unsigned int i = 0; i < dofs.size(); ++i)
            values.back()[i] = (*field)[dofs[i]];
        }
      return values;
    }

    /** Degrees of freedom in the numbering of a part of the sector. */
    std::vector<SectorNodes::Dof> counted_from(const SectorNodes::Dof first,
                                               std::vector<SectorNodes::Dof> dofs)
    {
      for (SectorNodes::Dof &dof : dofs)
        dof -= first;
      return dofs;
    }

    /** The sums of the two products of each motion. */
    std::vector<double> by_motion(const std::vector<double> &products)
    {
      std::vector<double> sums;
      for (unsigned int i = 0; i < products.size(); i += 2)
        sums.push_back(products[i] + products[i + 1]);
      return sums;
    }

    template <typename Element>
    void add_masses(Element &element, const std::vector<Vector<double>> &values,
                    std::vector<MotionProducts> &products)
    {
      const std::vector<double> masses = by_motion(element.mass_products(values));
      for (unsigned int i = 0; i < masses.size(); ++i)
        products[i].mass += masses[i];
    }

    template <typename Element>
    void add_cell(const types::material_id material, Element &element,
                  const std::vector<Vector<double>> &values, std::vector<MotionProducts> &products)
    {
      const std::vector<double> stiffnesses = by_motion(element.stiffness_products(values));
      for (unsigned int i = 0; i < stiffnesses.size(); ++i)
        products[i].stiffness[material] += stiffnesses[i];
      add_masses(element, values, products);
    }

    void add_electric(SolidElement &element, const std::vector<Vector<double>> &values,
                      const std::vector<Vector<double>> &potentials,
                      std::vector<MotionProducts> &products)
    {
      const std::vector<ElectricProducts> of_parts = element.electric_products(values, potentials);
      for (unsigned int i = 0; i < of_parts.size(); ++i)
      {
        products[i / 2].electric.coupling += of_parts[i].coupling;
        products[i / 2].electric.dielectric += of_parts[i].dielectric;
      }
    }

    template <typename Element>
    void add_support(const types::boundary_id id, Element &element,
                     const std::vector<Vector<double>> &values,
                     std::vector<MotionProducts> &products)
    {
      const std::vector<double> stiffnesses = by_motion(element.stiffness_products(values));
      for (unsigned int i = 0; i < stiffnesses.size(); ++i)
        products[i].stiffness_of_supports[id] += stiffnesses[i];
    }

    void add_bars(const SectorElements &elements, const Motions &motions,
                  std::vector<MotionProducts> &products)
    {
      elements.for_each_owned_bar(
          [&](const auto &cell, const types::boundary_id id, BarElement &bar)
          {
            const std::vector<SectorNodes::Dof> cell_dofs = elements.dofs_of(cell);
            std::vector<SectorNodes::Dof> dofs;
            for (const unsigned int i : bar.local_dofs())
              dofs.push_back(cell_dofs[i]);
            const auto values = values_at(motions, &SectorMotion::solid, dofs);
            add_support(id, bar, values, products);
            add_masses(bar, values, products);
          });
    }
  } // namespace

  double MotionProducts::total_stiffness() const
  {
    double total = 0.;
    for (const auto &entry : stiffness)
      total += entry.second;
    for (const auto &entry : stiffness_of_supports)
      total += entry.second;
    return total + 2. * electric.coupling - electric.dielectric;
  }

  std::vector<MotionProducts> motion_products(const SectorElements &elements,
                                              const std::vector<const SectorMotion *> &motions)
  {
    MotionProducts none;
    for (const auto &entry : elements.material_table())
      none.stiffness[entry.first] = 0.;
    for (const auto &entry : elements.sector_mesh().bars)
      none.stiffness_of_supports[entry.first] = 0.;
    for (const auto &entry : elements.sector_mesh().foundations)
      none.stiffness_of_supports[entry.first] = 0.;
    std::vector<MotionProducts> products(motions.size(), none);

    elements.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          const auto values = values_at(motions, &SectorMotion::solid, elements.dofs_of(cell));
          add_cell(cell->material_id(), element, values, products);
          if (elements.has_potential(cell))
            add_electric(element, values,
                         values_at(motions, &SectorMotion::potential,
                                   counted_from(elements.nodes().first_potential_dof(),
                                                elements.potential_dofs_of(cell))),
                         products);
        });
    elements.for_each_owned_shell_cell(
        [&](const auto &cell, ShellElement &element)
        {
          add_cell(
              cell->material_id(), element,
              values_at(motions, &SectorMotion::shell,
                        counted_from(elements.nodes().first_shell_dof(), elements.dofs_of(cell))),
              products);
        });
    add_bars(elements, motions, products);
    elements.for_each_owned_foundation(
        [&](const auto &cell, const types::boundary_id id, FoundationElement &element)
        {
          add_support(id, element, values_at(motions, &SectorMotion::solid, elements.dofs_of(cell)),
                      products);
        });

    const MPI_Comm communicator = elements.communicator();
    for (MotionProducts &of_motion : products)
    {
      for (auto &entry : of_motion.stiffness)
        entry.second = Utilities::MPI::sum(entry.second, communicator);
      for (auto &entry : of_motion.stiffness_of_supports)
        entry.second = Utilities::MPI::sum(entry.second, communicator);
      for (double *number :
           {&of_motion.mass, &of_motion.electric.coupling, &of_motion.electric.dielectric})
        *number = Utilities::MPI::sum(*number, communicator);
    }
    return products;
  }
} // namespace ringmotor
