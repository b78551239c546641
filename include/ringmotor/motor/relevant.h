// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <string>
#include <vector>

// The parameters on which costly results depend. A cached result is identified by all parameters it
// can depend on. The computation is given these parameters and no others: thus an entry that is
// forgotten here cannot lead to the use of a result that does not belong to it.

namespace ringmotor
{
  /** @p parameters with all entries at their defaults that do not affect a single operating point:
   * the list of operating points, the output, the criteria for refinement, and the entries that
   * only earlier and later programs read. */
  Parameters relevant_for_points(Parameters parameters);

  /** The same for the condensation of a motor, see condense_motor(): without load, friction, warp
   * and time. */
  Parameters relevant_for_condensation(const Parameters &parameters);

  /** The same for the modes of the stator and its wave, without the choice of modes (`Modes`) and
   * their error (`Accuracy`): with any of these the wave is that of this motor, and its error is
   * stored with it. */
  Parameters relevant_for_wave(const Parameters &parameters);

  /** The same for all results of the program stator, as numbers in its files: error bars, circuits
   * and estimates of effects too. */
  Parameters relevant_for_stator(const Parameters &parameters);

  /** The same for the results of all programs. */
  Parameters relevant_for_motor(const Parameters &parameters);

  /** The mesh files that the parameters name. */
  std::vector<std::string> files_named_by(const Parameters &parameters);

  /** All entries and their values as text, without comments, one per line. A mesh file is
   * identified by its content, not by its path. */
  std::string text_of(const Parameters &parameters);

  /** 36 characters each that identify results, by all that they depend on: those of the program
   * stator, and those of all programs. */
  struct Identity
  {
    std::string wave, motor;
  };

  /** @param programs their version */
  Identity identity_of(const Parameters &parameters, const std::string &programs);

  /** The first entry in which a text from text_of() differs from @p parameters, as
   * `Section/Entry = 1 there, 2 here`; empty if none does. */
  std::string difference(const std::string &text, const Parameters &parameters);
} // namespace ringmotor
