// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/steady.h>

#include <boost/serialization/complex.hpp>
#include <boost/serialization/vector.hpp>

#include <complex>
#include <vector>

namespace ringmotor
{
  /** The contact at some time samples: its states, one after the other, by time sample, tooth and
   * node, without the rotation of the rotor among the rigid motions and without the memory, which
   * follow from speed and status; and the displacements that the states mean. */
  struct ContactFields : StepState
  {
    std::vector<double> times;             ///< s
    unsigned int n_repeating_teeth = 0;    ///< all in a marched motor
    double time_step               = 0.;   ///< s, in which the relative motion happens
    std::vector<PointVector> tooth, rotor; ///< m, displacements; the rotor's without its rotation
    /** m, of the rotor against the base of the teeth, by the modes of both; empty without. */
    std::vector<PointVector> modal;
    /** Amplitudes of the modes of all bodies beyond their static motions, by time sample,
     * nodal diameter and mode, see SteadyInertia::vibration(); empty without modes. */
    std::vector<std::complex<double>> vibration;

    /** The place of a tooth's node among the values by time sample, tooth and node. Of a motor in
     * which the motion of some teeth repeats, every tooth has one. */
    std::size_t point(const std::size_t sample, const unsigned int tooth,
                      const unsigned int node) const
    {
      const std::size_t n_nodes = state.force.size() / (times.size() * n_repeating_teeth);
      return (sample * n_repeating_teeth + tooth % n_repeating_teeth) * n_nodes + node;
    }

    /** The largest share of the normal force that one node has at one time. */
    double largest_share() const;
    /** The memory of all values. */
    std::size_t n_bytes() const;
    /** Leaves nothing but the time step. */
    void drop_values();

    /** Reserves memory for @p n_samples time samples in total, each of the present size. */
    void reserve(const std::size_t n_samples);
    /** Appends later time samples. */
    void append(const ContactFields &later);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &state.force &state.rigid &motion &status &speed &times &n_repeating_teeth &time_step
          &tooth &rotor &modal &vibration;
    }

  private:
    /** Calls @p function with each of the arrays of values by time sample, of all @p fields. */
    template <class Function, class... Fields>
    static void for_each_array(const Function &function, Fields &...fields)
    {
      function(fields.times...);
      function(fields.state.force...);
      function(fields.state.rigid...);
      function(fields.motion...);
      function(fields.status...);
      function(fields.tooth...);
      function(fields.rotor...);
      function(fields.modal...);
      function(fields.vibration...);
    }
  };

  /** The fields of the state whose first time sample is at @p first_time (s). */
  ContactFields fields_of(const OperatingState &state, const double first_time);
} // namespace ringmotor
