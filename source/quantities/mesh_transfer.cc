// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/mesh_transfer.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The nodes nearest to a node: more than one if they are equally far. */
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

    using Weights = MeshTransfer::Weights;

    /** The weights by which a field is interpolated to a node, in the face that contains it. */
    Weights interpolation(const CondensedMotor::Node &node, const CondensedMotor &from)
    {
      double least = std::numeric_limits<double>::infinity();
      Point<2> unit;
      const std::vector<unsigned int> *face = nullptr;
      for (const std::vector<unsigned int> &candidate : from.faces)
      {
        std::array<Point<2>, 4> corners;
        for (unsigned int i = 0; i < 4; ++i)
          corners[i] = {from.nodes[candidate[i]].radius, from.nodes[candidate[i]].angle};
        const Point<2> found = unit_point(corners, {node.radius, node.angle});
        const double outside = GeometryInfo<2>::distance_to_unit_cell(found);
        if (outside < least)
        {
          least = outside;
          unit  = GeometryInfo<2>::project_to_unit_cell(found);
          face  = &candidate;
        }
      }
      const FE_Q<2> element(from.degree);
      Weights weights;
      for (unsigned int i = 0; i < face->size(); ++i)
        weights.emplace_back((*face)[i], element.shape_value(i, unit));
      return weights;
    }
  } // namespace

  MeshTransfer::MeshTransfer(const CondensedMotor &from, const CondensedMotor &to)
      : around(from.nodes.size())
  {
    for (unsigned int a = 0; a < to.nodes.size(); ++a)
    {
      const CondensedMotor::Node &node        = to.nodes[a];
      const std::vector<unsigned int> sources = nearest(node, from.nodes);
      source.push_back(sources.front());
      for (const unsigned int b : sources)
        around[b].emplace_back(a, node.area / sources.size());
      weights.push_back(interpolation(node, from));
    }
    for (const CondensedMotor::Node &node : from.nodes)
      target.push_back(nearest(node, to.nodes).front());
  }

  ContactFields MeshTransfer::fields(const ContactFields &known) const
  {
    constexpr double closed   = 1e-12; // m
    const unsigned int n_from = target.size(), n_to = source.size(),
                       n_blocks = known.force.size() / n_from; // a tooth at a time sample
    ContactFields result        = known;
    result.tooth.clear();
    result.rotor.clear();
    result.modal.clear();
    result.force.assign(n_blocks * n_to, PointVector());
    result.motion.clear();
    result.status.clear();
    for (unsigned int block = 0; block < n_blocks; ++block)
    {
      PointVector *force        = &result.force[block * n_to];
      const PointVector *motion = &known.motion[block * n_from];
      for (unsigned int a = 0; a < n_to; ++a)
      {
        result.motion.push_back(motion[source[a]]);
        result.motion.back()[0] = 0.;
        for (const auto &[b, weight] : weights[a])
          result.motion.back()[0] += weight * motion[b][0];
        result.status.push_back(known.status[block * n_from + source[a]]);
      }
      // The force of each node goes to the closed nodes around it, or else to the nearest one.
      for (unsigned int b = 0; b < n_from; ++b)
      {
        Weights shares;
        double sum = 0.;
        for (const auto &[a, area] : around[b])
          if (result.motion[block * n_to + a][0] < closed)
          {
            shares.emplace_back(a, area);
            sum += area;
          }
        if (shares.empty())
        {
          shares.emplace_back(target[b], 1.);
          sum = 1.;
        }
        for (const auto &[a, share] : shares)
          force[a] += share / sum * known.force[block * n_from + b];
      }
    }
    return result;
  }
} // namespace ringmotor
