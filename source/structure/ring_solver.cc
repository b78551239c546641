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

  std::optional<ShiftWindow> RingSolver::window_in(const std::vector<Eigenpair> &pairs,
                                                   const unsigned int n_wanted, const double target,
                                                   const bool has_lowest) const
  {
    const auto frequency = [](const double eigenvalue)
    { return std::sqrt(eigenvalue) / (2. * numbers::PI); };
    std::vector<double> values; // elastic ones, ascending
    for (const Eigenpair &pair : pairs)
      if (pair.value > slow)
        values.push_back(pair.value);
    std::vector<double> wanted = values;
    std::sort(wanted.begin(), wanted.end(),
              [&](const double a, const double b)
              { return std::abs(frequency(a) - target) < std::abs(frequency(b) - target); });
    if (wanted.size() < n_wanted)
      return {};
    wanted.resize(n_wanted);
    const auto [lowest, highest] = std::minmax_element(wanted.begin(), wanted.end());
    const std::vector<double> up(std::find(values.begin(), values.end(), *highest), values.end());
    const std::vector<double> down(std::find(values.rbegin(), values.rend(), *lowest),
                                   values.rend());
    if (up.size() < 2 || (down.size() < 2 && !has_lowest))
      return {};
    return ShiftWindow{down.size() < 2 ? slow : shift_beyond(down), shift_beyond(up)};
  }

  ShiftWindow RingSolver::window_around(const unsigned int n_wanted, const double target)
  {
    // A target may be a frequency that was computed before, where the matrix is singular.
    constexpr double beside = 1.0003;
    const double shift      = target > 0. ? std::pow(2. * numbers::PI * beside * target, 2) : -slow;
    const unsigned int n_below = count_below(shift);
    // Near in the eigenvalue is not near in the frequency: it may take more.
    for (unsigned int count = n_wanted + 2 * n_spare + (target > 0. ? 0 : n_rigid);
         2 * count < ring.n_unknowns(); count *= 2)
    {
      const std::vector<Eigenpair> found = pairs(shift, EigenvalueChoice::nearest, count, 1e-4);
      const unsigned int n_found_below   = std::count_if(
            found.begin(), found.end(), [&](const Eigenpair &pair) { return pair.value < shift; });
      if (const auto window = window_in(found, n_wanted, target, n_found_below == n_below))
        return *window;
    }
    throw ComputationError("the whole ring, with " + std::to_string(ring.n_unknowns()) +
                           " unknowns, has no gap in its spectrum around Modes/Number of modes = " +
                           std::to_string(n_wanted) + " modes; choose fewer");
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
