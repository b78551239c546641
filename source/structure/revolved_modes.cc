// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/response_modes.h>
#include <ringmotor/structure/revolved_modes.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Pairs of equal frequencies stay as they are. */
    void sort_by_frequency(std::vector<Mode> &modes)
    {
      std::stable_sort(modes.begin(), modes.end(),
                       [](const Mode &a, const Mode &b) { return a.eigenvalue < b.eigenvalue; });
    }

    std::string text_of(const unsigned int k, const int order)
    {
      return "nodal diameter " + std::to_string(k) + ", waves of order " + std::to_string(order);
    }
  } // namespace

  RevolvedModes::RevolvedModes(const CyclicSector &sector) : sector(sector), section(sector) {}

  std::vector<int> RevolvedModes::orders(const unsigned int k) const
  {
    // A quarter of a wave from node to node: polynomials of degree p, from the middle of a sector
    // to its end.
    const int n_sectors = sector.sector_mesh().n_sectors, first = k,
              degree = sector.dofs().has_active_dofs() ? sector.dofs().get_fe().degree
                                                       : sector.shell_dofs().get_fe().degree;
    std::vector<int> orders{first};
    for (int j = 1;; ++j)
    {
      const std::size_t n_before = orders.size();
      for (const int order : {first - j * n_sectors, first + j * n_sectors})
        if (2 * std::abs(order) <= degree * n_sectors && !is_conjugate(k, order))
          orders.push_back(order);
      if (orders.size() == n_before)
        return orders;
    }
  }

  bool RevolvedModes::has_conjugates(const unsigned int k) const
  {
    return 2 * k % sector.sector_mesh().n_sectors == 0;
  }

  bool RevolvedModes::is_conjugate(const unsigned int k, const int order) const
  {
    return order < 0 && has_conjugates(k);
  }

  void RevolvedModes::add(const unsigned int k, const int order, const double eigenvalue,
                          const double *unknowns, std::vector<Mode> &modes) const
  {
    modes.push_back({k, eigenvalue, /*rigid =*/false, section.expand(order, unknowns), 0.});
    if (!has_conjugates(k) || order == 0)
      return;
    modes.push_back(modes.back());
    for (ComplexField *field : modes.back().motion.parts())
      field->imaginary *= -1.;
  }

  std::vector<Mode> RevolvedModes::responses(const unsigned int k,
                                             const std::vector<LinearForm> &loads,
                                             const std::vector<double> &frequencies,
                                             const double highest)
  {
    std::vector<std::vector<double>> on_unknowns;
    for (const LinearForm &load : loads)
      on_unknowns.push_back(section.loads_of(load));
    std::vector<Mode> modes;
    for (const int order : orders(k))
    {
      const RitzVectors ritz =
          response_vectors({section.size(), text_of(k, order),
                            [&](const double shift, std::vector<double> &motions)
                            {
                              section.factorise(order, shift);
                              section.solve(motions);
                            },
                            [&](const std::vector<double> &motions, std::vector<double> &inertia)
                            { section.multiply_mass(motions, inertia); }},
                           on_unknowns, frequencies);
      for (std::size_t r = 0; r < ritz.values.size() && !is_fast(ritz.values[r], highest); ++r)
        add(k, order, ritz.values[r], ritz.vectors.data() + r * section.size(), modes);
    }
    sort_by_frequency(modes);
    return modes;
  }

  std::vector<Mode> RevolvedModes::below(const unsigned int k, const double shift)
  {
    ShiftInvertedPencil pencil;
    pencil.size  = section.size();
    pencil.shift = shift;
    pencil.solve = [&](std::vector<double> &x) { section.solve(x); };
    pencil.mass  = [&](const std::vector<double> &x, std::vector<double> &product)
    { section.multiply_mass(x, product); };
    std::vector<Mode> modes;
    for (const int order : orders(k))
    {
      section.factorise(order, shift);
      const unsigned int count = section.n_negative();
      if (count == 0)
        continue;
      unsigned int found = 0;
      for (const Eigenpair &pair :
           eigenpairs(pencil, EigenvalueChoice::below, count, generic_vector(pencil.size)))
        if (pair.value < shift)
        {
          ++found;
          add(k, order, pair.value, pair.vector.data(), modes);
        }
      if (found != count)
        throw ComputationError(text_of(k, order) + ": the factorisation counts " +
                               std::to_string(count) + " modes below " +
                               std::to_string(std::sqrt(shift) / (2. * numbers::PI)) +
                               " Hz, the eigensolver did not find them all");
    }
    sort_by_frequency(modes);
    return modes;
  }
} // namespace ringmotor
