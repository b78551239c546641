// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/nested_dissection.h>
#include <ringmotor/parameters/errors.h>

#include <metis.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  namespace
  {
    using Lists = std::vector<std::vector<unsigned int>>;

    /** The elements of each variable, ascending. */
    Lists elements_of_variables(const SymmetricElements &elements, const unsigned int size)
    {
      Lists of_variable(size);
      for (std::size_t e = 0; e + 1 < elements.begin.size(); ++e)
        for (int i = elements.begin[e] - 1; i < elements.begin[e + 1] - 1; ++i)
          of_variable[elements.variables[i] - 1].push_back(e);
      return of_variable;
    }

    /** The graph of groups of variables in METIS's form. */
    struct Graph
    {
      std::vector<idx_t> begin{0}, neighbours, weights;
    };

    /** @param group by variable; @param n_groups all of them */
    Graph graph_of(const SymmetricElements &elements, const std::vector<unsigned int> &group,
                   const Lists &of_variable, const unsigned int n_groups)
    {
      Graph graph;
      graph.weights.assign(n_groups, 0);
      std::vector<unsigned int> member(n_groups);
      for (unsigned int i = 0; i < group.size(); ++i)
      {
        ++graph.weights[group[i]];
        member[group[i]] = i;
      }
      std::vector<unsigned int> seen_for(n_groups, n_groups);
      for (unsigned int g = 0; g < n_groups; ++g)
      {
        seen_for[g] = g;
        for (const unsigned int e : of_variable[member[g]])
          for (int i = elements.begin[e] - 1; i < elements.begin[e + 1] - 1; ++i)
            if (const unsigned int other = group[elements.variables[i] - 1]; seen_for[other] != g)
            {
              seen_for[other] = g;
              graph.neighbours.push_back(static_cast<idx_t>(other));
            }
        graph.begin.push_back(static_cast<idx_t>(graph.neighbours.size()));
      }
      return graph;
    }
  } // namespace

  std::vector<int> nested_dissection(const SymmetricElements &elements, const unsigned int size)
  {
    const Lists of_variable = elements_of_variables(elements, size);
    std::map<std::vector<unsigned int>, unsigned int> groups;
    std::vector<unsigned int> group;
    for (const std::vector<unsigned int> &its_elements : of_variable)
      group.push_back(groups.emplace(its_elements, groups.size()).first->second);
    const unsigned int n_groups = groups.size();
    groups.clear();

    Graph graph = graph_of(elements, group, of_variable, n_groups);
    idx_t n     = static_cast<idx_t>(n_groups);
    std::vector<idx_t> permutation(n_groups), place(n_groups);
    if (METIS_NodeND(&n, graph.begin.data(), graph.neighbours.data(), graph.weights.data(), nullptr,
                     permutation.data(), place.data()) != METIS_OK)
      throw ComputationError("METIS did not find an order for the sparse direct solver, with " +
                             std::to_string(size) + " unknowns");

    std::vector<unsigned int> sorted(size);
    for (unsigned int i = 0; i < size; ++i)
      sorted[i] = i;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return place[group[a]] < place[group[b]]; });
    std::vector<int> places(size);
    for (unsigned int i = 0; i < size; ++i)
      places[sorted[i]] = static_cast<int>(i) + 1;
    return places;
  }
} // namespace ringmotor
