// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace ringmotor
{
  /**
   * Constitutive law of a piezoelectric solid in Cartesian axes (IEEE 176-1987, e-form):
   *
   *     T = c S - e^T E,    D = e S + eps E,    E = -grad phi.
   *
   * Strains S and stresses T have the order xx, yy, zz, yz, xz, xy; shear strains are twice the
   * components of the tensor.
   */
  struct PiezoelectricLaw
  {
    std::array<std::array<double, 6>, 6> stiffness;    ///< c at constant field, Pa
    std::array<std::array<double, 6>, 3> coupling;     ///< e, C/m^2
    std::array<std::array<double, 3>, 3> permittivity; ///< eps at constant strain, F/m
  };

  /** The constants of couplings that are given: to stresses (e) or to strains (d). */
  enum class CouplingForm
  {
    e, ///< C/m^2
    d  ///< m/V
  };

  /** The state of a body in which its permittivity was measured. */
  enum class PermittivityAt
  {
    strain, ///< constant strain: clamped
    stress  ///< constant stress: free, as in data sheets
  };

  /**
   * The constants of a ceramic that is poled along z (symmetry 6mm: c66 = (c11 - c12)/2), at
   * constant field, and its losses. The default values are those of a hard lead zirconate titanate,
   * PZT-4.
   */
  struct Piezoelectricity
  {
    double c11 = 139.e9, c12 = 77.84e9, c13 = 74.28e9, c33 = 115.4e9, c44 = 25.64e9; ///< Pa
    CouplingForm form = CouplingForm::e;
    double coupling31 = -5.207, coupling33 = 15.08, coupling15 = 12.71; ///< in this form
    PermittivityAt permittivity_at = PermittivityAt::strain;
    double permittivity11 = 6.752e-9, permittivity33 = 5.872e-9; ///< F/m, in this state
    double dielectric_loss_factor = 0.004, piezoelectric_loss_factor = 0.;

    /** The law in the e-form: where d is given, e = d c; where the permittivity is that of a free
     * body, eps = eps_T - d c d^T. */
    PiezoelectricLaw law() const;

    /** Coupling factor of a plate that vibrates in its thickness and is clamped along its faces:
     * k_t^2 = e33^2 / (c33 eps33 + e33^2). */
    double thickness_coupling() const;

    /** @throws UserError for constants that give negative energies: a stiffness or a permittivity
     * that is not positive definite, in other words a coupling factor of one or more. */
    void check() const;

    /** One line for each constant that is possible, but most likely a mistake. */
    std::vector<std::string> warnings() const;

    /** Declares the entries; reading them changes the members. */
    void declare(dealii::ParameterHandler &prm);
  };
} // namespace ringmotor
