// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/rigid_motions.h>
#include <ringmotor/structure/ring_solver.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_rigid = 6;
    /** Of a ring; a few more vectors cost little. */
    constexpr unsigned int block_size = 4;

    /** Where a gap is looked for first: another mesh moves the modes to its sides by less. */
    constexpr double wide_gap = 0.01;
    /** Modes beyond the wanted ones among which a gap is looked for. */
    constexpr unsigned int n_spare = 4;

    /** The middle of the first gap that is wide or, without one, of the widest; @p values begin
     * with the wanted mode that is farthest out. */
    double shift_beyond(const std::vector<double> &values)
    {
      double shift = 0., widest = 0.;
      for (std::size_t i = 0; i + 1 < values.size(); ++i)
        if (const double gap = std::abs(values[i + 1] - values[i]) /
                               std::max(std::abs(values[i]), std::abs(values[i + 1]));
            gap > widest)
        {
          shift  = 0.5 * (values[i] + values[i + 1]);
          widest = gap;
          if (gap > wide_gap)
            break;
        }
      return shift;
    }
  } // namespace

  RingSolver::RingSolver(const CyclicSector &ring)
      : ring(ring), slow(slow_eigenvalue(ring)), factors(ring)
  {
    Assert(ring.sector_mesh().form == SectorForm::ring, ExcInternalError());
  }

  unsigned int RingSolver::count_below(const double shift)
  {
    factors.factorise(0, shift);
    return factors.n_negative() - ring.n_potential_unknowns();
  }

  std::vector<Eigenpair> RingSolver::pairs(const double shift, const EigenvalueChoice choice,
                                           const unsigned int count, const double residual)
  {
    ShiftInvertedPencil pencil;
    pencil.size  = ring.n_unknowns();
    pencil.shift = shift;
    pencil.solve = [&](std::vector<double> &x) { factors.solve(x); };
    pencil.mass  = [&](const std::vector<double> &x, std::vector<double> &product)
    { ring.multiply_mass(0, x, product); };
    return multiple_eigenpairs(pencil, choice, count, block_size, residual, ring.communicator());
  }

  ShiftWindow RingSolver::window_around(const unsigned int n_wanted, const double target)
  {
    const double shift = target > 0. ? std::pow(2. * numbers::PI * target, 2) : -slow;
    count_below(shift);
    std::vector<double> values; // elastic ones
    for (const Eigenpair &pair : pairs(shift, EigenvalueChoice::nearest,
                                       n_wanted + 2 * n_spare + (target > 0. ? 0 : n_rigid), 1e-4))
      if (pair.value > slow)
        values.push_back(pair.value);
    const auto nearer = [&](const double a, const double b)
    {
      return std::abs(std::sqrt(a) - std::sqrt(std::max(0., shift))) <
             std::abs(std::sqrt(b) - std::sqrt(std::max(0., shift)));
    };
    std::vector<double> wanted = values;
    std::sort(wanted.begin(), wanted.end(), nearer);
    wanted.resize(std::min<std::size_t>(n_wanted, wanted.size()));
    const auto [lowest, highest] = std::minmax_element(wanted.begin(), wanted.end());
    std::vector<double> down, up;
    for (const double value : values)
    {
      if (value <= *lowest)
        down.insert(down.begin(), value);
      if (value >= *highest)
        up.push_back(value);
    }
    return {down.size() > 1 ? shift_beyond(down) : slow, shift_beyond(up)};
  }

  std::vector<Mode> RingSolver::between(const ShiftWindow &shifts)
  {
    const unsigned int n_below = shifts.low > slow ? count_below(shifts.low) : 0;
    counted                    = count_below(shifts.high) - n_below;
    std::vector<Mode> modes;
    for (const Eigenpair &pair : pairs(shifts.high, EigenvalueChoice::below, counted, 1e-10))
      modes.push_back({0, pair.value, false, ring.expand(0, pair.vector), 0.});
    sharpen_eigenvalues(ring, modes);
    const auto is_between = [&](const Mode &mode)
    { return mode.eigenvalue < shifts.high && (n_below == 0 || mode.eigenvalue > shifts.low); };
    found = std::count_if(modes.begin(), modes.end(), is_between);
    if (found != counted)
      throw ComputationError(
          "whole ring: the factorisations count " + std::to_string(counted) + " modes from " +
          std::to_string(std::sqrt(std::max(0., shifts.low)) / (2. * numbers::PI)) + " to " +
          std::to_string(std::sqrt(shifts.high) / (2. * numbers::PI)) +
          " Hz, the eigensolver found " + std::to_string(found) + " of them");
    modes.erase(std::remove_if(modes.begin(), modes.end(),
                               [&](const Mode &mode) { return mode.eigenvalue < slow; }),
                modes.end());
    return modes;
  }
} // namespace ringmotor
