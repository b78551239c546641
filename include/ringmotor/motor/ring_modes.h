// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/contact/ring_compliance.h>
#include <ringmotor/contact/solve/contact_problem.h>
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
  /** What a mode belongs to. The static compliance of rotor and teeth contains that of their modes;
   * the stator below the teeth has none but that of its modes. */
  enum class ModePart
  {
    rotor,
    tooth,
    stator
  };

  /** How a mode responds to forces. */
  enum class ModeResponse
  {
    vibrates,   ///< with its inertia; that of the rotor may be switched off
    as_at_rest, ///< far below its frequency
    none        ///< the static compliance is reduced by its own
  };

  /** A mode of a ring of equal sectors at its contact nodes. */
  struct RingMode
  {
    double angular_frequency; ///< rad/s
    /** Of each node of sector 0, times exp(-i k j alpha) for sector j, 1/sqrt(kg): the static
     * compliance for such waves of forces is the sum of motion motion^H / omega^2 of all modes. */
    std::vector<std::array<std::complex<double>, 3>> motion;
    ModePart part         = ModePart::rotor;
    ModeResponse response = ModeResponse::vibrates;
    /** Of its own, beside that of RingDynamics: of the stator that of its materials, weighted by
     * the energies of the mode. */
    double loss_factor = 0.;

    /** Of modes of the rotor, #motion of the body alone, before contain_modes(); empty if it is
     * the same. */
    std::vector<std::array<std::complex<double>, 3>> of_body = {};

    bool of_rotor() const { return part == ModePart::rotor; }
    const std::vector<std::array<std::complex<double>, 3>> &motion_of_body() const
    {
      return of_body.empty() ? motion : of_body;
    }
    /** The share of its static motion that the static compliance of the motor contains. */
    double at_once() const { return part == ModePart::stator ? 0. : 1.; }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &angular_frequency &motion &part &response &loss_factor &of_body;
    }
  };

  /** The same mode at other points, by interpolation between its nodes. @param weights of each
   * point
   */
  RingMode interpolated(const RingMode &mode, const std::vector<SurfaceWeights> &weights);

  /** The modes by nodal diameter 0 .. N / 2. */
  using RingModes = std::vector<std::vector<RingMode>>;

  /** Damping and time integration of a vibrating ring. */
  struct RingDynamics
  {
    /** eta of the rotor: a mode is damped by eta omega times its velocity. Without inertia damping
     * is hysteretic: the stiffness of a mode is (1 + i eta) omega^2 in all harmonics of a steady
     * state. Single steps in time cannot represent this law. */
    double loss_factor = 0.;
    InertiaScheme scheme;
    bool is_hysteretic = false; ///< rotor without inertia
    /** Added to the loss factor of every mode in states on the way to another one. */
    double added_loss_factor = 0.;
    /** Of all that modes add to the static compliance; less than one only in states on the way to
     * another one. */
    double share = 1.;

    /** Whether a mode moves with its inertia. */
    bool gives_inertia_to(const ModePart part, const ModeResponse response) const
    {
      return response == ModeResponse::vibrates && (part != ModePart::rotor || !is_hysteretic);
    }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &loss_factor &added_loss_factor &scheme.alpha &scheme.gamma &scheme
          .beta &is_hysteretic &share;
    }
  };

  /** The power that the modes of a ring take from the forces on it, W. */
  struct ModalPower
  {
    double taken = 0.; ///< beyond that stored by their static motions: kinetic energy and losses
    double damped_by_factor = 0.; ///< lost by damping of the rotor, divided by its loss factor; in
                                  ///< a steady state the rest of the power is lost by the scheme
    double lost_in_stator = 0.;   ///< by damping of the stator's modes
  };

  class ModesByShapes;
  /** The modes as SteadyInertia reads them. */
  std::shared_ptr<const ModesByShapes> by_shapes(const RingModes &modes);

  /** A wave around the ring in the history of a steady state. */
  struct HistoryWave
  {
    unsigned int k;         ///< nodal diameter
    bool conjugate;         ///< travels the other way: modes are those of its conjugate
    std::complex<double> z; ///< factor in a step, of it or, if #conjugate, of its conjugate
    double direction;       ///< of z in time: 1, -1, or 0 for a wave without direction
  };

  /**
   * The contribution of inertia and damping of modes to the static compliance of a ring that
   * carries n waves, in a steady state: all sectors have the same history, one after the other, and
   * wave m of the history has n m waves around the ring. The instants of the history, one step
   * after the other, form a ring themselves, in which a force moves all later instants.
   */
  class SteadyInertia
  {
  public:
    /** @param period s, of the wave; @param n_instants of it; @param dt s, length of a step, one or
     * several intervals between instants */
    SteadyInertia(std::shared_ptr<const ModesByShapes> modes, const unsigned int n_waves,
                  const unsigned int n_sectors, const double period, const unsigned int n_instants,
                  const double dt, const RingDynamics &dynamics);

    /** Motions at the instants due to forces at the instants. */
    RingCompliance compliance() const;

    /** Motions in the modes of rotor and stator, and the contribution of inertia to those of the
     * teeth, under @p forces, both by instant and node. */
    std::vector<PointVector> motion(const std::vector<PointVector> &forces) const;

    /** The modes at the first instant, by nodal diameter, under @p forces, by instant and node. */
    std::vector<std::vector<ModalState>> states(const std::vector<PointVector> &forces) const;

    /** The amplitudes of the modes beyond those of their static motions (sqrt(kg) m) at the first
     * @p n_samples instants, by instant, nodal diameter and mode, under @p forces, by instant and
     * node: amplitude q adds the real part of q motion exp(-i k j alpha) to sector j, twice unless
     * k is 0 or N / 2. */
    std::vector<std::complex<double>> vibration(const std::vector<PointVector> &forces,
                                                const unsigned int n_samples) const;

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
    /** At given states of the modes in motion. */
    void set(std::vector<std::vector<ModalState>> states, const std::vector<PointVector> &forces);
    /** By nodal diameter and mode. */
    const std::vector<std::vector<ModalState>> &current() const { return states; }

    /** Their contribution to the static compliance within a step @p dt (s). */
    RingCompliance compliance(const double dt) const;
    /** Current motions of all nodes, see SteadyInertia::motion(). */
    std::vector<PointVector> motion() const;
    /** Current amplitudes beyond the static motions, see SteadyInertia::vibration(). */
    std::vector<std::complex<double>> vibration() const;
    /** The same motions at the end of a step @p dt without forces there. */
    std::vector<PointVector> free_motion(const double dt) const;
    /** Adds a damping (1/s) to that of every mode in the following steps. */
    void damp(const double rate) { added_damping = rate; }
    /** Advances by a step @p dt, with @p forces at its end. @return the mean over the step */
    ModalPower step(const std::vector<PointVector> &forces, const double dt);

  private:
    /** By nodal diameter and mode. */
    using ByMode = std::vector<std::vector<std::complex<double>>>;
    ByMode modal_forces(const std::vector<PointVector> &forces) const;
    std::vector<PointVector> motion_of(const ByMode &displacements) const;

    const std::shared_ptr<const ModesByShapes> modes;
    const unsigned int n_sectors;
    const RingDynamics dynamics;
    double added_damping = 0.; ///< 1/s
    std::vector<std::vector<ModalState>> states;
    ByMode earlier; ///< modal forces at the end of the last step
  };
} // namespace ringmotor
