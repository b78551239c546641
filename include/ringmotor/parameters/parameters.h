// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/parameters/electrodes.h>
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
   * All entries of a parameter file, in SI units. The default values are those of
   * prm/soft_spring.prm. Pass the sub-structs on as const references; no part of the computation
   * needs all of them.
   */
  struct Parameters
  {
    Motor motor;
    StatorGeometry stator;
    RotorGeometry rotor;
    Materials materials;
    Piezoelectricity piezoelectricity;
    Electrodes electrodes;
    Modes modes;
    Wave wave;
    Loading loading;
    Friction friction;
    InitialDeformation initial_deformation;
    Support support;
    Contact contact;
    Time time;
    Accuracy accuracy;
    Uncertainty uncertainty;
    Effects effects;
    Output output;

    /** What the file differs in from the one that it is based on, see base_file.h. */
    struct Variant
    {
      std::string base; ///< path of the file at the end of the chain; empty if none
      struct Difference
      {
        std::string entry, value;
        std::string value_of_base; ///< empty if it has none
      };
      std::vector<Difference> differences; ///< also those of the overrides
    };
    Variant variant;

    /** Required entries that are missing from the file but that only some programs need. Their
     * values above are then the defaults, those of another motor. */
    std::vector<std::string> not_given;

    /** Whether dimensions describe both bodies. */
    bool has_dimensions() const { return stator.has_dimensions() && rotor.has_dimensions(); }

    /** The entries that name files of meshes, with their values. */
    std::vector<std::pair<std::string, std::string *>> mesh_files();

    /** Declares the whole tree, one subsection for each member, in this order. */
    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * Reads a parameter file and then the @p overrides, each `Section/Sub/Entry = value`, which take
   * precedence over the file, as its entries do over those of the file that it is based on (see
   * base_file.h); results of the base are never overwritten: its Output/Directory does not count.
   * A relative path of a mesh file is looked up in the folder of the parameter file that names it
   * first, then in the current directory.
   *
   * @throws UserError for a file that cannot be read, broken syntax, an unknown, duplicate or
   * missing entry, and a value outside the range of its entry; the message names file, line and
   * entry. Conflicts between entries are not checked, see check_for_stator().
   */
  Parameters read_parameters(const std::string &file,
                             const std::vector<std::string> &overrides = {});

  /** The same from a text in memory; @p name stands for the file in messages and in paths. */
  Parameters read_parameters_from_text(const std::string &text, const std::string &name,
                                       const std::vector<std::string> &overrides = {});

  /**
   * Writes @p parameters as a commented parameter file that read_parameters() understands; every
   * number is read back exactly. `Parameters()` gives prm/soft_spring.prm.
   */
  void print_parameters(std::ostream &out, const Parameters &parameters);

  /** The nodal diameters for which modes are requested, in ascending order: those listed, that of
   * the wave, or all from 0 to N/2. */
  std::vector<unsigned int> nodal_diameters_of(const Parameters &parameters);

  /**
   * Looks for entries that contradict each other, and for choices that the program `stator` does
   * not support, before any mesh is built. read_parameters() checks the ranges of single entries.
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
