// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_problem.h>
#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/motor/inertia_scheme.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/complex.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <complex>
#include <memory>
#include <vector>

namespace ringmotor
{
  /** A mode of a ring of equal sectors as its contact nodes see it. */
  struct RingMode
  {
    double angular_frequency; ///< rad/s
    /** Of each node of sector 0, times exp(-i k j alpha) for sector j, 1/sqrt(kg): the static
     * motions by forces of such waves are the sum of motion motion^H / omega^2 over all modes. */
    std::vector<std::array<std::complex<double>, 3>> motion;
    bool of_tooth = false; ///< of a tooth and not of the rotor; not damped

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &angular_frequency &motion &of_tooth;
    }
  };

  /** Those with nodal diameter 0 .. N / 2. */
  using RingModes = std::vector<std::vector<RingMode>>;

  /** How a vibrating ring is damped and stepped through time. */
  struct RingDynamics
  {
    /** eta of the rotor: a mode is damped by eta omega times its velocity. Without inertia damping
     * is hysteretic: the stiffness of a mode is (1 + i eta) omega^2 in all harmonics of a steady
     * state. Single steps in time have no such law. */
    double loss_factor = 0.;
    InertiaScheme scheme;
    bool is_hysteretic = false; ///< rotor without inertia

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &loss_factor &scheme.alpha &scheme.gamma &scheme.beta &is_hysteretic;
    }
  };

  /** What the modes of a ring take from the forces on it, W. */
  struct ModalPower
  {
    double taken = 0.; ///< beyond what their static motions store: kinetic energy and losses
    double damped_by_factor = 0.; ///< lost by damping, by the loss factor; the rest of what a
                                  ///< steady state takes is lost by the scheme
  };

  class ModesByShapes;

  /** A wave of a steady state's history around the ring. */
  struct HistoryWave
  {
    unsigned int k;         ///< nodal diameter
    bool conjugate;         ///< travels the other way
    std::complex<double> z; ///< of it, or of its conjugate, which the modes know, in a step
    double direction;       ///< of z in time: 1, -1 or, of a wave without one, 0
  };

  /**
   * What inertia and damping of modes add to the static compliance of a ring that carries n waves,
   * in a steady state: all sectors have the same history, one after the other, and wave m of the
   * history has n m waves around the ring. The instants of the history, one step after the other,
   * form a ring of their own, in which a force moves all later instants.
   */
  class SteadyInertia
  {
  public:
    /** @param period s, of the wave; @param n_instants of it; @param dt s, length of a step, one or
     * several of the times between instants */
    SteadyInertia(const RingModes &modes, const unsigned int n_waves, const unsigned int n_sectors,
                  const double period, const unsigned int n_instants, const double dt,
                  const RingDynamics &dynamics);

    /** Motions of the instants by forces at the instants. */
    RingCompliance compliance() const;

    /** Motions in the rotor's modes, and what inertia adds to those of the teeth, by instant and
     * node, under @p forces, likewise. */
    std::vector<PointVector> motion(const std::vector<PointVector> &forces) const;

    /** The modes at the first instant, by nodal diameter, under @p forces, by instant and node. */
    std::vector<std::vector<ModalState>> states(const std::vector<PointVector> &forces) const;

    /** Of the whole ring under @p forces, by instant and node. */
    ModalPower power(const std::vector<PointVector> &forces) const;

  private:
    HistoryWave wave(const unsigned int m) const;
    /** The forces of a wave, or of its conjugate, on the shapes of modes. */
    std::vector<std::complex<double>> on_shapes(const std::vector<PointVector> &forces,
                                                const unsigned int m) const;

    const std::shared_ptr<const ModesByShapes> modes;
    const unsigned int n_waves, n_sectors, n_instants;
    const double angle; ///< rad, phase of the wave in a step
    const double dt;
    const RingDynamics dynamics;
  };

  /** The modes of a ring marched through time, a step at a time. */
  class MarchedModes
  {
  public:
    MarchedModes(const RingModes &modes, const unsigned int n_sectors,
                 const RingDynamics &dynamics);

    /** At rest under @p forces, by sector and node. */
    void rest(const std::vector<PointVector> &forces);
    /** In the midst of a motion. */
    void set(std::vector<std::vector<ModalState>> states, const std::vector<PointVector> &forces);

    /** What they add to the static compliance within a step @p dt (s). */
    RingCompliance compliance(const double dt) const;
    /** Motions of all nodes now, see SteadyInertia::motion(). */
    std::vector<PointVector> motion() const;
    /** The same at the end of a step @p dt without forces there. */
    std::vector<PointVector> free_motion(const double dt) const;
    /** From now on with this loss factor of the rotor. */
    void damp(const double loss_factor) { dynamics.loss_factor = loss_factor; }
    /** Goes on by a step @p dt, with @p forces at its end. @return the mean over the step */
    ModalPower step(const std::vector<PointVector> &forces, const double dt);

  private:
    /** By nodal diameter and mode. */
    using ByMode = std::vector<std::vector<std::complex<double>>>;
    ByMode modal_forces(const std::vector<PointVector> &forces) const;
    std::vector<PointVector> motion_of(const ByMode &displacements) const;

    const std::shared_ptr<const ModesByShapes> modes;
    const unsigned int n_sectors;
    RingDynamics dynamics;
    std::vector<std::vector<ModalState>> states;
    ByMode earlier; ///< modal forces at the end of the last step
  };
} // namespace ringmotor
