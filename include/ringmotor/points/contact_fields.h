// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>

#include <boost/serialization/complex.hpp>
#include <boost/serialization/vector.hpp>

#include <complex>
#include <vector>

namespace ringmotor
{
  /** All fields at the contact nodes at some time samples; by time sample, tooth, node. */
  struct ContactFields
  {
    std::vector<double> times;             ///< s
    unsigned int n_repeating_teeth = 0;    ///< all in a marched motor
    double time_step               = 0.;   ///< s
    std::vector<PointVector> force;        ///< N, on the rotor
    std::vector<PointVector> motion;       ///< m, gap and slip in the step
    std::vector<PointVector> tooth, rotor; ///< m, displacements; the rotor's without its rotation
    std::vector<PointVector> modal;        ///< m, of the rotor, by its modes, if it has inertia
    /** Amplitudes of the modes of rotor and teeth beyond their static motions, by time sample,
     * nodal diameter and mode, see SteadyInertia::vibration(); empty without modes. */
    std::vector<std::complex<double>> vibration;
    std::vector<double> rigid;         ///< rigid motions by time sample, see RingContact
    std::vector<unsigned char> status; ///< see PointStatus
    double turn = 0.; ///< rad, of the rotor in the last step, if the torque was given

    /** Reserves memory for @p n_samples time samples in total, each of the present size. */
    void reserve(const std::size_t n_samples);
    /** Appends later time samples. */
    void append(const ContactFields &later);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &times &n_repeating_teeth &time_step &force &motion &tooth &rotor &modal &vibration
          &rigid &turn &status;
    }
  };

  /** The fields of a state whose first time sample is at @p first_time (s). */
  ContactFields fields_of(const OperatingState &state, const double first_time);
} // namespace ringmotor
