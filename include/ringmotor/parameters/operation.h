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
  /** The quantity that is prescribed at an operating point; the other one is computed. */
  enum class Control
  {
    torque,
    speed
  };

  /** The operating points. */
  struct Loading
  {
    double preload  = 14.; ///< N, total axial force on the top face of the rotor ring
    Control control = Control::torque;

    /** N m (torque) or rad/s (speed); an empty list stands for a whole torque-speed curve. */
    std::vector<double> values;

    unsigned int n_curve_points = 11;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** A law of friction as `Friction/Law` names it. */
  struct FrictionLawEntry
  {
    std::string name;
    std::string description;            ///< in words, without "a law with"
    bool has_static_coefficient = true; ///< else it has only the dynamic one
  };

  /** All of them. Each law declares its own: this function is that of the room that models them,
   * see contact/friction_law.h. */
  const std::vector<FrictionLawEntry> &friction_law_entries();

  /** One of them. */
  class FrictionLaw
  {
  public:
    /** @param name which must exist */
    explicit FrictionLaw(const std::string &name);

    const FrictionLawEntry &entry() const { return friction_law_entries()[number]; }
    unsigned int index() const { return number; }
    bool operator==(const FrictionLaw &other) const { return number == other.number; }
    bool operator!=(const FrictionLaw &other) const { return number != other.number; }
    bool operator<(const FrictionLaw &other) const { return number < other.number; }

  private:
    unsigned int number; ///< in the list
  };

  /** Friction between lip and tooth tops. */
  struct Friction
  {
    FrictionLaw law            = FrictionLaw("static-dynamic");
    double static_coefficient  = 0.48;
    double dynamic_coefficient = 0.40;
    std::optional<double> decay_velocity;              ///< m/s, for the law `velocity`
    std::optional<double> weakening_length;            ///< m, for the law `slip_weakening`
    std::optional<double> lining_normal_stiffness;     ///< N/m^3, of a friction lining
    std::optional<double> lining_tangential_stiffness; ///< N/m^3, of a friction lining

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** The warp amplitude * cos(n_waves * theta) of the stator's tooth tops at rest. */
  struct InitialDeformation
  {
    double amplitude     = 0.; ///< m
    unsigned int n_waves = 2;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  /** The felt ring that carries the stator from below, if there is one. */
  struct Support
  {
    std::optional<double> felt_thickness;    ///< m
    std::optional<double> felt_modulus;      ///< Pa, in compression
    std::optional<double> felt_loss_factor;  ///< energy lost per radian over the stored energy
    std::optional<double> felt_inner_radius; ///< m; without a value that of the stator's base
    std::optional<double> felt_outer_radius; ///< m, likewise

    /** Whether there is one; only then it has a thickness, a modulus and a loss factor. */
    bool has_felt() const { return felt_thickness.has_value(); }
    /** Of the foundation that it is for the stator, N/m^3; 0 without a felt. */
    double stiffness() const { return has_felt() ? *felt_modulus / *felt_thickness : 0.; }
    /** @throws UserError for a felt of which only a part is given */
    void check() const;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  enum class ContactFormulation
  {
    mortar,
    penalty
  };

  /** The shape of the faces in contact at rest. */
  enum class ContactFaces
  {
    drawn, ///< as in the section, level without one
    lapped ///< parallel to each other under the preload, spread evenly
  };

  /** How contact is enforced. */
  struct Contact
  {
    ContactFormulation formulation = ContactFormulation::mortar;
    ContactFaces faces             = ContactFaces::drawn;
    std::optional<double> normal_penalty;     ///< N/m at each node, for the penalty formulation
    std::optional<double> tangential_penalty; ///< N/m at each node, for the penalty formulation

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };

  enum class TimeScheme
  {
    automatic, ///< steady where the ring is uniform, else marching
    steady,
    marching
  };

  /** How an operating point is resolved in time. */
  struct Time
  {
    TimeScheme scheme = TimeScheme::automatic;
    double time_step  = 5.e-7; ///< s, of the marching scheme, which may take shorter ones

    /** The steps of the marching scheme to average over. Give all three, or none to average over
     * whole periods of the settled solution. */
    std::optional<unsigned int> n_steps;
    std::optional<unsigned int> average_from_step; ///< first step of the averages, counted from 1
    std::optional<unsigned int> average_to_step;   ///< last step of the averages

    /** Interleaved time samples (steady scheme), or substeps of each step (marching scheme). */
    unsigned int n_snapshots = 1;

    /** For a rotor with inertia, see InertiaScheme::second_order(). */
    double spectral_radius = 0.5;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
