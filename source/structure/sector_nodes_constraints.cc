// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/sector_nodes.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  AffineConstraints<double>
  SectorNodes::scalar_hanging_node_constraints(const DoFHandler<3> &solid,
                                               const PotentialDofs &potentials) const
  {
    AffineConstraints<double> cartesian;
    if (solid.has_active_dofs())
      DoFTools::make_hanging_node_constraints(solid, cartesian);
    cartesian.close();

    AffineConstraints<double> constraints;
    for (const auto &line : cartesian.get_lines())
      if (place[line.index].component == 0)
      {
        constraints.add_line(place[line.index].node);
        for (const auto &[dof, weight] : line.entries)
          constraints.add_entry(place[line.index].node, place[dof].node, weight);
      }
    for (const auto &line : potentials.hanging_nodes().get_lines())
    {
      const unsigned int slave = place[n_mechanical_dofs + line.index].node;
      constraints.add_line(slave);
      for (const auto &[dof, weight] : line.entries)
        constraints.add_entry(slave, place[n_mechanical_dofs + dof].node, weight);
    }
    constraints.close();
    return constraints;
  }

  std::vector<SlaveNode>
  SectorNodes::slaves_of(const AffineConstraints<double> &scalar_hanging_nodes)
  {
    std::vector<SlaveNode> slaves;
    for (const auto &line : scalar_hanging_nodes.get_lines())
    {
      SlaveNode slave{static_cast<unsigned int>(line.index), {}, {}};
      for (const auto &[node, weight] : line.entries)
        slave.masters.emplace_back(node, weight * unit_symmetric_tensor<3>());
      slaves.push_back(std::move(slave));
    }
    return slaves;
  }

  AffineConstraints<double> SectorNodes::constraints(const std::vector<SlaveNode> &slaves) const
  {
    AffineConstraints<double> constraints;
    for (const SlaveNode &slave : slaves)
      if (nodes[slave.node].kind == Kind::potential)
      {
        constraints.add_line(nodes[slave.node].dofs[0]);
        for (const auto &[node, weight] : slave.masters)
          constraints.add_entry(nodes[slave.node].dofs[0], nodes[node].dofs[0], weight[0][0]);
      }
      else
        add_constraints(slave, constraints);
    constraints.close();
    return constraints;
  }

  void SectorNodes::add_constraints(const SlaveNode &slave,
                                    AffineConstraints<double> &constraints) const
  {
    // Where one direction n is free, the component nearest to it is: value = given + lambda n.
    const Tensor<1, 3> &n         = slave.free_direction;
    const std::array<Dof, 3> dofs = nodes[slave.node].dofs;
    const Dof free =
        *std::max_element(dofs.begin(), dofs.end(),
                          [&](const Dof a, const Dof b)
                          { return std::abs(n * direction(a)) < std::abs(n * direction(b)); });
    const bool has_free = n.norm() > 0.;
    for (const Dof dof : dofs)
    {
      if (has_free && dof == free)
        continue;
      const double share = has_free ? (n * direction(dof)) / (n * direction(free)) : 0.;
      const Tensor<1, 3> projection =
          has_free ? direction(dof) - share * direction(free) : direction(dof);
      constraints.add_line(dof);
      if (std::abs(share) > 1e-14)
        constraints.add_entry(dof, free, share);
      for (const auto &[node, weight] : slave.masters)
        for (const Dof master : nodes[node].dofs)
        {
          const double entry = projection * (weight * direction(master));
          if (std::abs(entry) > 1e-14 * weight.norm())
            constraints.add_entry(dof, master, entry);
        }
    }
  }
} // namespace ringmotor
