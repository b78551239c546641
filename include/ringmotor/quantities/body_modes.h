// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/quantities/motor_wave.h>

#include <functional>

namespace ringmotor
{
  /** The materials of the parts of a body. */
  MaterialTable material_table(const Materials &materials, const Body body);

  /** One computation on the way to the requested accuracy. */
  struct Pass
  {
    unsigned int number = 0; ///< from 1
    unsigned int degree = 0; ///< of the finite elements
    unsigned int level  = 0; ///< of the mesh, as Accuracy/Refinement, before sheets are cut
    std::size_t n_cells = 0;
    unsigned int n_dofs = 0;
    double seconds      = 0.; ///< wall clock
  };

  /** The largest admissible WaveResult::relative_error() of the stator's wave, which leaves room
   * for the errors of the contact: a fifth of `Accuracy/Contact target`. */
  double wave_target(const Accuracy &accuracy);

  /**
   * The modes of a body of the motor (`Modes/Body`), from a mesh of its sector that is refined
   * until the frequencies meet `Accuracy/Target` and the motor's wave, if it is among the modes,
   * meets wave_target() (or, with `Accuracy/Mode = fixed`, from the requested mesh). For a stator,
   * only relevant_for_wave() of the parameters, `Modes` and `Accuracy` are used.
   */
  class BodyModes
  {
  public:
    BodyModes(const Parameters &parameters, MPI_Comm communicator);

    /**
     * Computes them; @p after_pass is called after each pass, when search() holds its results.
     * @throws UserError for an unsuitable mesh file
     * @throws ComputationError if a target is out of reach
     */
    void find(const std::function<void(const Pass &)> &after_pass);

    /**
     * Computes them on a ladder of meshes and degrees, regardless of the requested accuracy;
     * @p after_pass as in find().
     */
    void climb(const std::function<void(const Pass &)> &after_pass);

    const ModeSearch &search() const { return mode_search; }

    /** The motor's wave, as the last pass found it; null if the body is not the stator or the wave
     * is not among the requested modes. */
    const WaveResult *wave() const { return motor_wave.result(); }

    /** The accuracy entry that required the last mesh of find(), with its value; empty with
     * `Accuracy/Mode = fixed`. */
    const std::string &last_refined_for() const { return refined_for; }

    /** The decisions on the effects of the stator, judged by the modes of the last pass; none for
     * other bodies. Collective. */
    std::vector<EffectRow> effects() const;

  private:
    bool is_generated() const;
    void make_mesh(const unsigned int new_level);
    /** The stator on a refinement level with what @p model adds to it. */
    SectorMesh stator_mesh(const unsigned int of_level, const MotorModel &model) const;
    /** Decides on effects set to `auto` from the modes of a coarse mesh without them.
     * Collective. */
    void choose_effects();
    /** How much effects change the modes of @p search. */
    std::vector<EffectRow> choices_by(const ModeSearch &search, Parameters &chosen) const;
    void compute_pass(const unsigned int degree,
                      const std::function<void(const Pass &)> &after_pass);
    void aim_at(const bool for_wave);
    [[noreturn]] void give_up() const;

    const Parameters given;
    Parameters parameters; ///< those that the modes depend on
    const MPI_Comm communicator;
    SectorMesh mesh;
    ModeSearch mode_search;
    MotorWave motor_wave;
    unsigned int n_passes = 0, level = 0;
    std::string refined_for;
  };
} // namespace ringmotor
