// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/quantities/motor_wave.h>

#include <functional>

namespace ringmotor
{
  /** What the parts of a body are made of. */
  MaterialTable material_table(const Materials &materials, const Body body);

  /** One computation on the way to the wanted accuracy. */
  struct Pass
  {
    unsigned int number = 0; ///< from 1
    unsigned int degree = 0; ///< of the finite elements
    unsigned int level  = 0; ///< of the mesh, as Accuracy/Refinement, before sheets were cut
    std::size_t n_cells = 0;
    unsigned int n_dofs = 0;
    double seconds      = 0.; ///< wall clock
  };

  /** The largest WaveResult::relative_error() of the stator's wave that leaves the contact room for
   * its own errors: a fifth of `Accuracy/Contact target`. */
  double wave_target(const Accuracy &accuracy);

  /**
   * The modes of a body of the motor (`Modes/Body`), from a mesh of its sector that is refined
   * until the frequencies are as accurate as `Accuracy/Target` asks for and the motor's wave, if it
   * is among the modes, as wave_target() (or, `Accuracy/Mode = fixed`, from the mesh asked for).
   * Looks at relevant_for_wave() of the parameters of a stator only, apart from `Modes` and
   * `Accuracy`.
   */
  class BodyModes
  {
  public:
    BodyModes(const Parameters &parameters, MPI_Comm communicator);

    /**
     * Computes them; @p after_pass is called after each pass, when search() holds its results.
     * @throws UserError for a mesh file that is not fit
     * @throws ComputationError if a target is out of reach
     */
    void find(const std::function<void(const Pass &)> &after_pass);

    /**
     * Computes them on a ladder of meshes and degrees, whatever the accuracy asked for; for
     * find()'s @p after_pass.
     */
    void climb(const std::function<void(const Pass &)> &after_pass);

    const ModeSearch &search() const { return mode_search; }

    /** The motor's wave, as the last pass found it; null without a stator, or if it is not among
     * the modes asked for. */
    const WaveResult *wave() const { return motor_wave.result(); }

    /** The entry for whose sake find() made the last mesh, with its value; empty with
     * `Accuracy/Mode = fixed`. */
    const std::string &last_refined_for() const { return refined_for; }

    /** What became of the effects that belong to the stator, by the modes of the last pass; none
     * for other bodies. Collective. */
    std::vector<EffectRow> effects() const;

  private:
    bool is_generated() const;
    void make_mesh(const unsigned int new_level);
    /** The stator on a level of refinement with what @p model puts on it. */
    SectorMesh stator_mesh(const unsigned int of_level, const MotorModel &model) const;
    /** Chooses effects that are `auto` by the modes of a coarse mesh without them. Collective. */
    void choose_effects();
    /** How much effects matter in the modes of @p search. */
    std::vector<EffectRow> choices_by(const ModeSearch &search, Parameters &chosen) const;
    void compute_pass(const unsigned int degree,
                      const std::function<void(const Pass &)> &after_pass);
    void aim_at(const bool for_wave);
    [[noreturn]] void give_up() const;

    const Parameters given;
    Parameters parameters; ///< that the modes depend on
    const MPI_Comm communicator;
    SectorMesh mesh;
    ModeSearch mode_search;
    MotorWave motor_wave;
    unsigned int n_passes = 0, level = 0;
    std::string refined_for;
  };
} // namespace ringmotor
