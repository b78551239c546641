// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/parameters/parameters.h>

#include <string>

namespace ringmotor
{
  /** How long the steps in time are. */
  struct Steps
  {
    /** Into how many parts a step is divided: the time samples of the steady state, or the parts of
     * Time/Time step. */
    unsigned int n_parts = 1;
    /** How many steps are joined into one, see SteadyStep for those of the steady state: such long
     * steps give the error of a step without more unknowns, or with half the work. */
    unsigned int n_joined = 1;

    /** Steps in the time of an undivided one: that after which a tooth is in the state of another
     * one, or `Time/Time step`. */
    double number() const { return n_parts / static_cast<double>(n_joined); }

    /** Those of half the length. */
    Steps halved() const;
    /** Those of twice the length; time samples must be even in number, or a single one. */
    Steps doubled() const;

    /** Whether those that show the influence of these are twice as long, which is cheap, not half
     * as long: where a step is undivided, longer ones may miss the contact of a tooth. */
    bool are_compared_with_longer() const { return n_parts % 2 == 0; }
    /** Those. */
    Steps to_compare_with() const { return are_compared_with_longer() ? doubled() : halved(); }

    bool operator==(const Steps &other) const
    {
      return n_parts == other.n_parts && n_joined == other.n_joined;
    }
  };

  /** A change of the motor whose effect on the results tells an error of them; each is defined
   * where it is needed. */
  struct Variation
  {
    std::string name; ///< of this one alone
    void (*change_parameters)(Parameters &) = nullptr;
    /** @param wave_error relative, of the speed of the stator's surface */
    void (*change_motor)(MotorInUse &, double wave_error) = nullptr;
    /** Whether a driven wave is the largest that the errors of its drive allow. */
    bool has_drive_errors = false;
    /** Whether states are searched from those of their neighbours, not from the same point of the
     * requested motor: to show how far states are apart where there are several. */
    bool starts_from_neighbours = false;
  };

  /** How finely bodies and time are divided, and which motor is meant. */
  struct Discretisation
  {
    unsigned int level       = 0; ///< of the meshes, see ContactDiscretisation::level()
    unsigned int modes_level = 0; ///< of the vibrations, see RotorVibration
    Steps steps;
    const Variation *variation = nullptr; ///< none: the requested motor

    bool operator<(const Discretisation &other) const;
    bool operator==(const Discretisation &other) const
    {
      return !(*this < other) && !(other < *this);
    }

    /** The same with other steps, of the requested motor. */
    Discretisation with(const Steps &other) const { return {level, modes_level, other}; }
    /** The same of another motor. */
    Discretisation with(const Variation &of_motor) const
    {
      return {level, modes_level, steps, &of_motor};
    }

    /** What #variation changes: nothing, if there is none. */
    Variation changes() const { return variation ? *variation : Variation(); }

    /** Its mesh, steps and motor in words: "interface mesh 1, step 1/2". */
    std::string text() const;
  };

  /** The choice of steps for one motor. */
  class StepChoice
  {
  public:
    /** @param period s, of the wave */
    StepChoice(const Parameters &parameters, const double period);

    /** The longest ones that give a period at least @p n_steps steps; a percent fewer will do, as
     * given step lengths are rounded. */
    Steps at_least(const double n_steps) const;

    /** Those with which waves and averaging windows are compared: no more than necessary. */
    Steps plain() const;

    /** Those with which meshes are compared, the same on all of them: plain() or, of a marched
     * motor, the first own ones, with which its points are needed anyway. */
    Steps of_meshes() const;

    /** Those with which the search for points begins on a mesh, from the points of another mesh:
     * plain() or a multiple of their length. A search is short from a state with longer steps. */
    Steps longest() const;

    /** The initial number of parts of a step: `Time/Snapshots` of the steady state, or more if
     * steps must not be too long, and then those of plain() or shorter ones. */
    unsigned int first_parts() const;

    /** The largest number of parts that is tried. */
    unsigned int most_parts() const;

  private:
    const bool is_marched, is_fixed;
    const unsigned int n_snapshots;
    const unsigned int few_steps; ///< in a period
    const double n_undivided;     ///< steps in a period, neither divided nor joined
  };

  /** The parameters with shorter steps: with @p n_parts time samples in the steady state, with each
   * step divided into @p n_parts when marching. */
  Parameters with_parts_of_a_step(Parameters parameters, const unsigned int n_parts);
} // namespace ringmotor
