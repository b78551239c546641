// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/points/discretisation.h>

#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** A discretisation of the contact in space and time, with all entries that it changes. */
  struct ContactSetting
  {
    std::string knob, value;     ///< see StudyRow
    bool is_other_model = false; ///< its bodies are modelled otherwise
    Parameters parameters;
    ContactDiscretisation discretisation;
    double n_steps; ///< at least, in a period of the wave
    unsigned int modes_level;

    /** All that its results depend on besides the wave and the loads. */
    std::string text() const;
  };

  /** What the settings of a study must suit. */
  struct StudiedMotor
  {
    double period;         ///< s, of the wave
    double node_stiffness; ///< N/m, the inverse of the normal compliance of a typical contact node
  };

  /** The setting that all others of a study are compared with in a single knob: interface mesh 1
   * (with `Accuracy/Mode = fixed`, none finer than requested) with moderate steps. */
  ContactSetting common_setting(const Parameters &parameters, const double period);

  /**
   * The settings of a study of accuracy against time: the common one, the sequence of interface
   * meshes with two lengths of the step, and settings that differ from the common one in a single
   * knob. Only knobs that exist in this motor are turned: modes of the rotor and dissipation of the
   * scheme with inertia, averaging windows when marching. With `Accuracy/Mode = fixed` no
   * discretisation is finer than that of `Accuracy/Interface refinement` and `Rotor modes`.
   *
   * A motor without inertia is also computed as in the paper, with linear elements on coarse
   * meshes, springs at the nodes, and averages over steps 6 to 15 of 5e-7 s from rest; and with
   * each of these four alone, on the second finest interface mesh with short steps.
   *
   * The last one is the best: the finest interface mesh with short steps.
   */
  std::vector<ContactSetting> contact_settings(const Parameters &parameters,
                                               const StudiedMotor &motor);
} // namespace ringmotor
