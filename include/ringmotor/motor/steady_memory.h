// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/friction.h>
#include <ringmotor/contact/solve/contact_solver.h>
#include <ringmotor/motor/ring_contact.h>

#include <vector>

namespace ringmotor
{
  /** The memory of contact points in the steady state: the state one step earlier. */
  std::vector<FrictionMemory> travelled(const RingContact &contact, const StepState &solution);

  /**
   * Makes the memory that the points of a steady state are assumed to have agree with what happens
   * to them one step earlier, according to the law. From solution to solution, whole paths change:
   * whoever loses the static limit takes it from all that have stuck by it since, and whoever gets
   * it passes it on, to twice as many points each time, of which those that slip lose it again.
   */
  class SteadyMemory
  {
  public:
    /** After so many solutions without agreement the search ends. */
    static constexpr unsigned int most_solutions = 60;

    /** @param start the memory assumed first */
    SteadyMemory(const RingContact &contact, const Friction &friction,
                 std::vector<FrictionMemory> start);

    /** What is assumed for the next solution. */
    const FrictionMemory &operator[](const unsigned int point) const { return memory[point]; }

    /** All of it, to be kept with the state. */
    const std::vector<FrictionMemory> &assumed() const { return memory; }

    /** Changes the memory where it disagrees with a @p solution in which it was assumed. Returns
     * whether all agreed. */
    bool settled(const StepState &solution);

    /** Those that settled() has seen. */
    unsigned int n_solutions_so_far() const { return n_solutions; }

    /** How many solutions in a row show what it does that does not settle: those since it was last
     * assumed as it is now; where it wanders for long without coming back, the last ones. Zero
     * while it may still settle. See FrictionLawBase::may_wander(). */
    unsigned int n_alternating() const;

  private:
    /** After so many solutions a memory that may wander is taken to do so: those that settle do it
     * in half of them, apart from a few. */
    static constexpr unsigned int enough_to_wander = 32;
    static constexpr unsigned int longest_period   = 12; ///< that is recognised

    /** Points in the order of time: each after its earlier one, if that one touches; then the open
     * ones. */
    std::vector<unsigned int> along_paths(const StepState &solution) const;

    const RingContact &contact;
    const Friction &friction;
    std::vector<FrictionMemory> memory;
    std::vector<unsigned int> later;    ///< the inverse of RingContact::earlier()
    std::vector<unsigned char> n_gains; ///< how often a point got the static limit
    unsigned int reach = 1;             ///< how many points in a row may get it on trust
    std::vector<std::vector<FrictionMemory>> earlier; ///< assumed in the last solutions
    unsigned int n_solutions = 0;
  };
} // namespace ringmotor
