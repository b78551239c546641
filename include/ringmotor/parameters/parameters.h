// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/materials.h>
#include <ringmotor/parameters/modes.h>
#include <ringmotor/parameters/motor.h>
#include <ringmotor/parameters/operation.h>
#include <ringmotor/parameters/run_control.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace ringmotor
{
  /**
   * Everything a parameter file can say, in SI. The values written in the class are the reference
   * motor. Hand the sub-structs on as const references; no computing part needs all of it.
   */
  struct Parameters
  {
    Motor motor;
    StatorGeometry stator;
    RotorGeometry rotor;
    Materials materials;
    Modes modes;
    Wave wave;
    Loading loading;
    Friction friction;
    InitialDeformation initial_deformation;
    Support support;
    Contact contact;
    Time time;
    Accuracy accuracy;
    Effects effects;
    Output output;

    /** Required entries that the file does not give, but that only some programs need. The values
     * above are then those of another motor. */
    std::vector<std::string> not_given;

    /** Declares the whole tree, one subsection for each member, in this order. */
    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * Reads a parameter file and then the @p overrides, each `Section/Sub/Entry = value`, which win
   * over the file. A relative path of a mesh file is searched in the folder of the parameter file
   * first, then in the current directory.
   *
   * @throws UserError for a file that cannot be read, broken syntax, an unknown, duplicate or
   * missing entry, and a value outside the range of its entry; the message names file, line and
   * entry. Clashes between entries are not looked for, see check_for_stator().
   */
  Parameters read_parameters(const std::string &file,
                             const std::vector<std::string> &overrides = {});

  /** The same from a text in memory; @p name stands for the file in messages and in paths. */
  Parameters read_parameters_from_text(const std::string &text, const std::string &name,
                                       const std::vector<std::string> &overrides = {});

  /**
   * Writes @p parameters as a commented parameter file that read_parameters() understands; every
   * number is read back exactly as it is. `Parameters()` gives the reference motor.
   */
  void print_parameters(std::ostream &out, const Parameters &parameters);

  /** The nodal diameters for which modes are asked, in ascending order: as listed, that of the
   * wave, or all from 0 to N/2. */
  std::vector<unsigned int> nodal_diameters_of(const Parameters &parameters);

  /** Whether the ring is warped at rest, and the warp takes part. */
  bool is_warped(const Parameters &parameters);

  /** Whether a motor has to be marched through time: it says so, or its ring is not uniform. */
  bool is_marched(const Parameters &parameters);

  /**
   * Looks for entries that contradict each other, and for choices the program `stator` does not
   * offer, before any mesh is built. Ranges of single entries are the business of
   * read_parameters().
   *
   * @throws UserError naming the entries that clash and the way out.
   */
  void check_for_stator(const Parameters &parameters);

  /**
   * The same for the program `contact`.
   * @returns warnings, one line each: choices that are allowed but easily misread
   * @throws UserError naming the entries that clash and the way out.
   */
  std::vector<std::string> check_for_contact(const Parameters &parameters);

  /** The same for the program `losses`. */
  std::vector<std::string> check_for_losses(const Parameters &parameters);
} // namespace ringmotor
