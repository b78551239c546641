// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/results/work_precision.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ringmotor
{
  namespace
  {
    double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
      return largest;
    }
  } // namespace

  WorkPrecision::WorkPrecision(std::vector<StudyRow> rows, std::vector<Measure> all_measures,
                               const unsigned int best)
      : all(std::move(rows)), best(best), distances(all.size())
  {
    const std::vector<std::vector<double>> &reference = all[best].results;
    Assert(reference.size() == all_measures.size(), dealii::ExcInternalError());
    for (unsigned int i = 0; i < all_measures.size(); ++i)
    {
      if (reference[i].empty())
        continue;
      for (unsigned int row = 0; row < all.size(); ++row)
      {
        const auto &results = all[row].results;
        distances[row].push_back(results.empty() || results[i].size() != reference[i].size()
                                     ? std::optional<double>()
                                     : largest_difference(results[i], reference[i]) /
                                           all_measures[i].scale);
      }
      measures.push_back(std::move(all_measures[i]));
    }
  }

  std::optional<unsigned int> WorkPrecision::cheapest(const unsigned int quantity,
                                                      const double tolerance) const
  {
    std::optional<unsigned int> found;
    for (unsigned int row = 0; row < all.size(); ++row)
      if (const auto distance = distances[row][quantity];
          row != best && distance && *distance <= tolerance &&
          (!found || all[row].seconds < all[*found].seconds))
        found = row;
    return found;
  }

  std::vector<unsigned int> WorkPrecision::front(const unsigned int quantity) const
  {
    std::vector<unsigned int> order(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return all[a].seconds < all[b].seconds; });
    std::vector<unsigned int> front;
    double closest = std::numeric_limits<double>::infinity();
    for (const unsigned int row : order)
      if (const auto distance = distances[row][quantity];
          row != best && distance && *distance < closest)
      {
        closest = *distance;
        front.push_back(row);
      }
    return front;
  }

  std::optional<double> WorkPrecision::price(const unsigned int quantity, const double from,
                                             const double to) const
  {
    const auto cheap = cheapest(quantity, from), dear = cheapest(quantity, to);
    if (!cheap || !dear)
      return {};
    return all[*dear].seconds / all[*cheap].seconds;
  }
} // namespace ringmotor
