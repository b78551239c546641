// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/cures.h>

namespace ringmotor
{
  namespace
  {
    /** Which part of the square of an error is expected to remain. */
    double remaining_part(const Cure cure)
    {
      const double of_error = cure == Cure::meshes ? 0.35 : 0.5;
      return of_error * of_error;
    }
  } // namespace

  std::set<Cure> cheapest_cures(const std::map<Cure, double> &curable, const double incurable,
                                const double target)
  {
    std::set<Cure> all, once, again;
    for (const auto &[cure, square] : curable)
      if (square > 0.)
        all.insert(cure);
    if (incurable > target)
      return {};
    // Numbers whose bits are the cures: those of a larger number are dearer.
    const unsigned int n_sets = 1u << (static_cast<unsigned int>(Cure::meshes) + 1);
    for (unsigned int number = n_sets - 1; number > 0; --number)
    {
      std::set<Cure> cures;
      double expected = incurable, remaining = incurable;
      for (const Cure cure : all)
      {
        const double square = curable.at(cure);
        const bool is_taken = (number >> static_cast<unsigned int>(cure)) % 2 == 1;
        if (is_taken)
          cures.insert(cure);
        expected += is_taken ? remaining_part(cure) * square : square;
        remaining += is_taken ? 0. : square;
      }
      if (expected <= target)
        once = cures;
      if (remaining <= target)
        again = cures;
    }
    return once.empty() ? again : once;
  }
} // namespace ringmotor
