// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>

// What costly results depend on. A result that is kept for a later run is found again by all the
// parameters it can depend on. The computation is given these parameters and no others: so an entry
// that is forgotten here cannot lead to the use of a result that does not belong to it.

namespace ringmotor
{
  /** @p parameters with those entries at their defaults that change nothing in a single operating
   * point: the list of points, the output, what the program decides by when it refines, and what
   * only the programs before and after look at. */
  Parameters relevant_for_points(const Parameters &parameters);

  /** The same for the condensation of a motor, see condense_motor(): without load, friction, warp
   * and time. */
  Parameters relevant_for_condensation(const Parameters &parameters);

  /** The same for the modes of the stator and its wave, but for the choice of modes (`Modes`) and
   * their error (`Accuracy`): whichever it was, the wave is that of this motor and knows its error.
   */
  Parameters relevant_for_wave(const Parameters &parameters);

  /** All entries and their values as text, without comments, one on each line. A mesh file is told
   * by its content, wherever it lies. */
  std::string text_of(const Parameters &parameters);

  /** The first entry in which a text of text_of() differs from parameters, as `Section/Entry = 1
   * there, 2 here`; empty if none does. */
  std::string difference(const std::string &text, const Parameters &parameters);
} // namespace ringmotor
