// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/results/work_precision.h>
#include <ringmotor/wave/body_modes.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ringmotor
{
  /** A discretisation of a body for its modes. */
  struct BodySetting
  {
    std::string knob, value; ///< see StudyRow
    BodyDiscretisation discretisation;
    ElementKind piezoceramic;
    bool is_other_model = false; ///< its ceramic ring is modelled otherwise
  };

  /**
   * The settings of a study of accuracy against time: degrees on the sequence of meshes and, for a
   * stator that is not read from a file, numbers of layers at the slot root, of cells from the
   * inner to the outer side, even cells, and the other kind of ceramic ring; it is also computed as
   * in the paper, with linear elements on even cells, and with each of these two alone. With
   * `Accuracy/Mode = fixed` no degree and no mesh is finer than the given ones. The last setting is
   * the best, one degree higher than the others.
   */
  std::vector<BodySetting> body_settings(const Parameters &parameters);

  /**
   * What accuracy costs the modes: the frequency of the motor's wave, its A_t/A_n and phi_edge or,
   * without the wave, the frequency of the first mode, for each of body_settings().
   */
  class BodyStudy
  {
  public:
    BodyStudy(const Parameters &parameters, MPI_Comm communicator);

    const std::vector<BodySetting> &settings() const { return all; }

    /** All that the row of a setting depends on. */
    std::string key(const BodySetting &setting) const;

    /** Collective. */
    StudyRow compute(const BodySetting &setting);

    /** @param rows of all settings */
    WorkPrecision compare(const std::vector<StudyRow> &rows) const;

  private:
    /** The body with one kind of ceramic ring, its modes located. */
    BodyModes &body_with(const ElementKind piezoceramic);

    const Parameters &parameters;
    const MPI_Comm communicator;
    std::map<ElementKind, std::unique_ptr<BodyModes>> bodies;
    const std::vector<BodySetting> all;
  };
} // namespace ringmotor
