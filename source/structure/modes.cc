// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/rigid_motions.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  double Mode::frequency() const
  {
    return std::sqrt(std::max(0., eigenvalue)) / (2. * numbers::PI);
  }

  std::vector<Mode> nearest_elastic(const std::vector<Mode> &modes, const unsigned int n_wanted,
                                    const double target)
  {
    std::vector<Mode> chosen;
    std::copy_if(modes.begin(), modes.end(), std::back_inserter(chosen),
                 [](const Mode &mode) { return !mode.rigid; });
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](const Mode &a, const Mode &b) {
                       return std::abs(a.frequency() - target) < std::abs(b.frequency() - target);
                     });
    if (chosen.size() > n_wanted)
      chosen.erase(chosen.begin() + n_wanted, chosen.end());
    std::sort(chosen.begin(), chosen.end(),
              [](const Mode &a, const Mode &b) { return a.eigenvalue < b.eigenvalue; });
    return chosen;
  }

  void sharpen_eigenvalues(const CyclicSector &sector, std::vector<Mode> &modes)
  {
    std::vector<const SectorMotion *> motions;
    for (const Mode &mode : modes)
      motions.push_back(&mode.motion);
    const std::vector<MotionProducts> products = motion_products(sector, motions);
    for (unsigned int mode = 0; mode < modes.size(); ++mode)
    {
      const double sharp        = products[mode].total_stiffness() / products[mode].mass;
      modes[mode].algebra_error = std::abs(modes[mode].eigenvalue / sharp - 1.);
      modes[mode].eigenvalue    = sharp;
    }
  }

  ModeSolver::ModeSolver(const CyclicSector &sector) : sector(sector), factors(sector) {}

  unsigned int ModeSolver::count_below(const unsigned int k, const double shift)
  {
    factors.factorise(k, shift);
    // A complex Hermitian problem written in real numbers has every eigenvalue twice.
    return (factors.n_negative() - sector.n_potential_unknowns()) / (sector.is_complex() ? 2 : 1);
  }

  std::vector<Mode> ModeSolver::below(const unsigned int k, const double shift)
  {
    const unsigned int count = count_below(k, shift);
    std::vector<Mode> modes  = solve(k, shift, EigenvalueChoice::below, count);
    counted += count;
    found += std::count_if(modes.begin(), modes.end(),
                           [&](const Mode &mode) { return mode.eigenvalue < shift; });
    if (found != counted)
      throw ComputationError("nodal diameter " + std::to_string(k) + ": the factorisation counts " +
                             std::to_string(count) + " modes below " +
                             std::to_string(std::sqrt(shift) / (2. * numbers::PI)) +
                             " Hz, the eigensolver did not find them all");
    return modes;
  }

  std::vector<ShiftWindow>
  ModeSolver::windows_above(const unsigned int k, const unsigned int n_wanted, const double target)
  {
    const unsigned int n_below =
        target > 0. ? count_below(k, std::pow(2. * numbers::PI * target, 2)) : 0;
    const unsigned int n_spare = 2;
    std::vector<Mode> modes    = lowest(k, n_below + n_wanted + n_spare);
    modes.erase(
        std::remove_if(modes.begin(), modes.end(), [](const Mode &mode) { return mode.rigid; }),
        modes.end());
    const double highest_wanted = nearest_elastic(modes, n_wanted, target).back().eigenvalue;

    std::vector<ShiftWindow> windows;
    for (unsigned int i = 0; i + 1 < modes.size(); ++i)
      if (const double gap = modes[i + 1].eigenvalue - modes[i].eigenvalue;
          modes[i].eigenvalue >= highest_wanted)
        windows.push_back({modes[i].eigenvalue + 0.25 * gap, modes[i].eigenvalue + 0.75 * gap});
    return windows;
  }

  double ModeSolver::shift_above(const unsigned int k, const unsigned int n_wanted,
                                 const double target)
  {
    const std::vector<ShiftWindow> windows = windows_above(k, n_wanted, target);
    const ShiftWindow widest               = *std::max_element(windows.begin(), windows.end(),
                                                               [](const ShiftWindow &a, const ShiftWindow &b)
                                                               { return a.high / a.low < b.high / b.low; });
    return 0.5 * (widest.low + widest.high);
  }

  std::map<unsigned int, double>
  common_shifts(const std::map<unsigned int, std::vector<ShiftWindow>> &windows)
  {
    std::map<unsigned int, double> shifts;
    while (shifts.size() < windows.size())
    {
      // The lowest of the window midpoints that serve the most nodal diameters.
      std::vector<unsigned int> best;
      double best_shift = 0.;
      for (const auto &of_candidates : windows)
        if (shifts.count(of_candidates.first) == 0)
          for (const ShiftWindow &candidate : of_candidates.second)
          {
            const double shift = 0.5 * (candidate.low + candidate.high);
            std::vector<unsigned int> served;
            for (const auto &[k, of_k] : windows)
              if (shifts.count(k) == 0 &&
                  std::any_of(of_k.begin(), of_k.end(),
                              [&](const ShiftWindow &window)
                              { return window.low <= shift && shift <= window.high; }))
                served.push_back(k);
            if (served.size() > best.size() || (served.size() == best.size() && shift < best_shift))
            {
              best       = served;
              best_shift = shift;
            }
          }
      for (const unsigned int k : best)
        shifts[k] = best_shift;
    }
    return shifts;
  }

  std::vector<Mode> ModeSolver::lowest(const unsigned int k, const unsigned int n_elastic)
  {
    // A little below zero the shifted stiffness is definite, rigid motions or not: far enough away
    // from their rounding errors, close enough to separate slow elastic modes.
    const double shift = -slow_eigenvalue(sector);
    factors.factorise(k, shift);
    return solve(k, shift, EigenvalueChoice::nearest, n_elastic + (k < 2 ? 2 : 0));
  }

  std::vector<Mode> ModeSolver::solve(const unsigned int k, const double shift,
                                      const EigenvalueChoice choice, const unsigned int count)
  {
    ShiftInvertedPencil pencil;
    pencil.size    = sector.n_unknowns();
    pencil.complex = sector.is_complex();
    pencil.shift   = shift;
    pencil.solve   = [&](std::vector<double> &x) { factors.solve(x); };
    pencil.mass    = [&](const std::vector<double> &x, std::vector<double> &product)
    { sector.multiply_mass(k, x, product); };
    const auto rigid = rigid_motions(sector, k);
    std::vector<Mode> modes;
    for (const Eigenpair &pair : eigenpairs(pencil, choice, count, generic_vector(pencil.size)))
      modes.push_back({k, pair.value, rigid_fraction(sector, k, rigid, pair.vector) > 0.99,
                       sector.expand(k, pair.vector), 0.});
    sharpen_eigenvalues(sector, modes);
    return modes;
  }
} // namespace ringmotor
