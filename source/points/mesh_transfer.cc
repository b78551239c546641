// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/points/mesh_transfer.h>

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
      // Generous, for it only decides whether one of two meshes' nodes is shared by several.
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

    /** The contact points of a tooth as a surface. */
    ContactSurface surface_of(const CondensedMotor &motor)
    {
      ContactSurface surface;
      surface.degree = motor.degree;
      for (const CondensedMotor::Node &node : motor.nodes)
        surface.nodes.push_back({{node.radius, node.angle}, {}});
      surface.faces = motor.faces;
      for (const std::vector<unsigned int> &face : motor.faces)
      {
        surface.corners.emplace_back();
        for (unsigned int i = 0; i < 4; ++i)
          surface.corners.back()[i] = surface.nodes[face[i]].place;
      }
      return surface;
    }
  } // namespace

  MeshTransfer::MeshTransfer(const CondensedMotor &from, const CondensedMotor &to)
      : around(from.nodes.size())
  {
    const ContactSurface surface = surface_of(from);
    for (unsigned int a = 0; a < to.nodes.size(); ++a)
    {
      const CondensedMotor::Node &node        = to.nodes[a];
      const std::vector<unsigned int> sources = nearest(node, from.nodes);
      source.push_back(sources.front());
      for (const unsigned int b : sources)
        around[b].emplace_back(a, node.area / sources.size());
      weights.push_back(interpolation(surface, {node.radius, node.angle}));
    }
    for (const CondensedMotor::Node &node : from.nodes)
      target.push_back(nearest(node, to.nodes).front());
  }

  ContactFields MeshTransfer::fields(const ContactFields &known) const
  {
    ContactFields result = known;
    result.tooth.clear();
    result.rotor.clear();
    result.modal.clear();
    result.vibration.clear();
    transfer(known, result);
    return result;
  }

  MarchedState MeshTransfer::marched(const MarchedState &known) const
  {
    const auto nearest_of = [&](const auto &values)
    {
      std::decay_t<decltype(values)> result;
      for (std::size_t first = 0; first < values.size(); first += target.size())
        for (const unsigned int node : source)
          result.push_back(values[first + node]);
      return result;
    };
    MarchedState result = known;
    transfer(known.end, result.end);
    result.positions = nearest_of(known.positions);
    result.memory    = nearest_of(known.memory);
    return result;
  }

  void MeshTransfer::transfer(const StepState &known, StepState &result) const
  {
    constexpr double closed   = 1e-12; // m
    const unsigned int n_from = target.size(), n_to = source.size(),
                       n_blocks = known.state.force.size() / n_from; // a tooth at a time sample
    result.state.force.assign(n_blocks * n_to, PointVector());
    result.motion.clear();
    result.status.clear();
    for (unsigned int block = 0; block < n_blocks; ++block)
    {
      PointVector *force        = &result.state.force[block * n_to];
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
          force[a] += share / sum * known.state.force[block * n_from + b];
      }
    }
  }
} // namespace ringmotor
