// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /** Whose modes are computed. */
  enum class Body
  {
    stator,
    rotor,
    tooth
  };

  /** Its name: `stator`, `rotor`, `tooth`. */
  std::string to_string(const Body body);

  /** What is meshed for the modes. */
  enum class Domain
  {
    sector, ///< one sector: one number of waves at a time
    ring    ///< the whole ring, whatever its symmetry
  };

  /** Which modes the program `stator` computes. */
  struct Modes
  {
    Body body     = Body::stator;
    Domain domain = Domain::sector;

    /** Nodal diameters in ascending order, each once; empty for that of the motor's wave, or
     * #all_nodal_diameters alone. See nodal_diameters_of(). */
    std::vector<unsigned int> nodal_diameters;
    static constexpr unsigned int all_nodal_diameters = static_cast<unsigned int>(-1);

    unsigned int n_modes    = 2;  ///< elastic modes for each nodal diameter, or of the whole ring
    double frequency_target = 0.; ///< Hz; modes nearest to it are taken, 0: the lowest ones

    /** Whether the wave of a motor can be among them: not among those of a rotor, a tooth or a
     * whole ring. */
    bool can_have_wave() const { return body == Body::stator && domain == Domain::sector; }

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** What is given of the wave that drives the motor. */
  enum class Drive
  {
    amplitude,
    voltage
  };

  /** The travelling wave that drives the motor. */
  struct Wave
  {
    Drive drive      = Drive::amplitude;
    double amplitude = 2.e-6; ///< m, normal, at the outer edge of the tooth top, zero to peak; if
                              ///< the voltage is given, where the search for the amplitude begins
    std::optional<double> voltage; ///< V, zero to peak, of each phase
    std::optional<double>
        frequency; ///< Hz; without a value the computed frequency of the mode or, if the voltage
                   ///< is given, that of the resonance with the rotor on the stator

    std::vector<double> response_torques; ///< N m; see FrequencyResponse

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
