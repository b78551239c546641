// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/parameters.h>

#include <functional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** A program: what it checks and does with the parameters of a motor. */
  struct Program
  {
    std::string name, purpose;
    /** What checks the parameters for contradictions, and what does the work. */
    std::function<void(const Parameters &)> check, run;
    /** The option `--study`, alone or with `--resume`. */
    std::function<void(const Parameters &, bool resumes)> study = {};
    /** The options `--resume` and `--clear`. Options that a program does not have are refused. */
    std::function<void(const Parameters &)> resume = {}, clear = {};
    /** What the option `--check` says besides, found by a small computation; a line each. */
    std::function<std::vector<std::string>(const Parameters &)> remarks = {};
    /** The option `--sensitivities`, alone or with `--resume`: the work, and then that. */
    std::function<void(const Parameters &, bool resumes)> sensitivities = {};
  };

  /** Natural modes of the stator and its travelling wave, or the modes of the rotor or a tooth. */
  Program stator_program();

  /** Speed, torque and friction loss of the motor at its operating points, on the wave that
   * `stator` has found. */
  Program contact_program();

  /** Where the power goes at the operating points that `contact` has found. */
  Program losses_program();
} // namespace ringmotor
