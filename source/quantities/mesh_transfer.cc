// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/mesh_transfer.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  namespace
  {
    /** The points of another mesh that are nearest to a point: more than one if they are equally
     * far. */
    std::vector<unsigned int> nearest(const CondensedMotor::Node &node,
                                      const std::vector<CondensedMotor::Node> &others)
    {
      constexpr double rounding = 1e-6;
      std::vector<double> distance;
      for (const CondensedMotor::Node &other : others)
        distance.push_back(
            std::hypot(other.radius - node.radius, node.radius * (other.angle - node.angle)));
      const double least = *std::min_element(distance.begin(), distance.end());
      std::vector<unsigned int> nearest;
      for (unsigned int i = 0; i < others.size(); ++i)
        if (distance[i] <= least + rounding * node.radius)
          nearest.push_back(i);
      return nearest;
    }
  } // namespace

  ContactFields transferred(const ContactFields &fields, const CondensedMotor &from,
                            const CondensedMotor &to)
  {
    // Shares of the forces at the points b that points a get; each b gives all of its force.
    const unsigned int n_from = from.nodes.size(), n_to = to.nodes.size();
    std::vector<std::vector<unsigned int>> sources;
    dealii::FullMatrix<double> share(n_to, n_from);
    for (unsigned int a = 0; a < n_to; ++a)
    {
      sources.push_back(nearest(to.nodes[a], from.nodes));
      for (const unsigned int b : sources[a])
        share(a, b) = to.nodes[a].area / sources[a].size();
    }
    for (unsigned int b = 0; b < n_from; ++b)
    {
      double sum = 0.;
      for (unsigned int a = 0; a < n_to; ++a)
        sum += share(a, b);
      if (sum == 0.)
        for (const unsigned int a : nearest(from.nodes[b], to.nodes))
          sum += share(a, b) = to.nodes[a].area;
      for (unsigned int a = 0; a < n_to; ++a)
        share(a, b) /= sum;
    }
    const unsigned int n_blocks = fields.force.size() / n_from; // a moment of a tooth
    ContactFields result        = fields;
    for (auto *field : {&result.force, &result.motion, &result.tooth, &result.rotor})
      field->clear();
    result.status.clear();
    for (unsigned int block = 0; block < n_blocks; ++block)
      for (unsigned int a = 0; a < n_to; ++a)
      {
        PointVector force;
        for (unsigned int b = 0; b < n_from; ++b)
          force += share(a, b) * fields.force[block * n_from + b];
        result.force.push_back(force);
        result.motion.push_back(fields.motion[block * n_from + sources[a].front()]);
        result.status.push_back(fields.status[block * n_from + sources[a].front()]);
      }
    return result;
  }
} // namespace ringmotor
