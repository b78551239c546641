// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  struct Parameters;

  /** Required entries without a value so far, as `Section/Sub/Entry`. */
  std::vector<std::string> required_but_not_set(const dealii::ParameterHandler &prm);

  /**
   * Notes in Parameters::not_given which required entries a file lacks of what only some motors and
   * programs need: rotor, load, friction, losses, target plates, constants of the ceramic. Where
   * none of these constants is given, `Effects/Piezoelectric coupling = auto` becomes `off`.
   * @param name of the file, for messages
   * @throws UserError if an entry is missing that every motor needs
   */
  void note_missing(Parameters &parameters, const dealii::ParameterHandler &prm,
                    const std::string &name);

  /** The required entries that are missing whose paths start with one of @p starts. */
  std::vector<std::string> missing_entries(const Parameters &parameters,
                                           const std::vector<std::string> &starts);

  /** @throws UserError if required entries whose paths start with one of @p starts are missing;
   * @p reason says what needs them */
  void check_given(const Parameters &parameters, const std::string &reason,
                   const std::vector<std::string> &starts);
} // namespace ringmotor
