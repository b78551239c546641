// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/motor/effect.h>
#include <ringmotor/parameters/parameters.h>
#include <ringmotor/wave/motor_circuits.h>

#include <functional>
#include <optional>

namespace ringmotor
{
  /** A mesh of a body and the degree of its elements. */
  struct BodyDiscretisation
  {
    unsigned int degree, level;                ///< level of the mesh, as Accuracy/Refinement
    std::optional<SectorGrading> grading = {}; ///< of a generated stator, instead of the level
  };

  /** That of the first pass: cheap, it locates the modes and shows how hard they are to resolve. */
  inline const BodyDiscretisation scout{2, 0};

  /** The cheapest one with which modes reach a relative error of @p target immediately, or nearly
   * so, if those of the first pass have the largest relative error bar @p found. */
  BodyDiscretisation discretisation_for(const Body body, const double target, const double found);

  /** The mesh of a sector of the body whose modes are computed (`Modes/Body`), or of its tooth; of
   * a stator with what @p model adds to it. Its cells are divided over @p ranks. */
  SectorMesh mesh_of_body(const Parameters &parameters, const BodyDiscretisation &discretisation,
                          const MotorModel &model, MPI_Comm ranks);

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

  /**
   * The modes of a body of the motor (`Modes/Body`), from a mesh of its sector that is refined
   * until the frequencies meet `Accuracy/Target` and the motor's wave, if it is among the modes,
   * meets AccuracyBudget::wave() (or, with `Accuracy/Mode = fixed`, from the requested mesh). For a
   * stator, only relevant_for_wave() of the parameters, `Modes` and `Accuracy` are used.
   */
  class BodyModes
  {
  public:
    BodyModes(const Parameters &parameters, MPI_Comm ranks);

    /**
     * Computes them; @p after_pass is called after each pass, when search() holds its results.
     * @throws UserError for an unsuitable mesh file
     * @throws ComputationError if a target is out of reach
     */
    void find(const std::function<void(const Pass &)> &after_pass);

    /** Decides on effects, and locates the modes on a coarse mesh. Other discretisations then
     * compute them at once. */
    void locate();

    /** Computes them, once located, on a mesh regardless of the requested accuracy; search() then
     * holds the results. */
    Pass compute(const BodyDiscretisation &discretisation);

    /** Whether the mesh is generated from dimensions, not read from a file. */
    bool is_generated() const;

    const ModeSearch &search() const { return *mode_search; }

    /** The motor's wave, as the last pass found it; null if the body is not the stator or the wave
     * is not among the requested modes. */
    const WaveResult *wave() const { return motor_wave.result(); }

    /** The circuits of the phases after find(); null without a wave or without piezoelectric
     * coupling. */
    const MotorCircuits *circuits() const
    {
      return motor_circuits && wave() ? &*motor_circuits : nullptr;
    }

    /** The accuracy entry that required the last mesh of find(), with its value; empty with
     * `Accuracy/Mode = fixed`. */
    const std::string &last_refined_for() const { return refined_for; }

    /** The decisions on the effects of the stator, judged by the modes of the last pass; none for
     * other bodies. Collective. */
    std::vector<EffectRow> effects() const;

  private:
    std::unique_ptr<ModeSearch> new_search(const MotorModel &model) const;
    /** Decides on effects and prepares the search. */
    void begin();
    /** Finds those of the phases on two coarse meshes. */
    void find_capacitances();
    /** The relative change of the wave's frequency by a ceramic with a potential, on a coarse mesh.
     * Collective. */
    double shift_by_coupling(const MotorModel &coupled) const;
    void make_mesh(const BodyDiscretisation &discretisation);
    /** Decides on effects set to `auto` from the modes of a coarse mesh without them.
     * Collective. */
    void choose_effects();
    /** How much effects change the modes of @p search. */
    std::vector<EffectRow> choices_by(const ModeSearch &search, Parameters &chosen) const;
    /** The modes on the present mesh. */
    Pass compute_pass(const unsigned int degree);
    void aim_at(const bool for_wave);
    [[noreturn]] void give_up() const;

    const Parameters given;
    Parameters parameters;                  ///< those that the modes depend on
    const MPI_Comm share_modes, share_mesh; ///< what the ranks share: one of the two, if any; a
                                            ///< mesh only if it is large
    SectorMesh mesh;
    std::unique_ptr<ModeSearch> mode_search; ///< once effects are chosen
    MotorWave motor_wave;
    std::optional<MotorCircuits> motor_circuits; ///< with piezoelectric coupling
    unsigned int n_passes = 0, level = 0;
    std::string refined_for;
  };
} // namespace ringmotor
