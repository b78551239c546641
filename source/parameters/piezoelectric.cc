// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/piezoelectric.h>
#include <ringmotor/parameters/short_text.h>

#include <deal.II/base/tensor.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  PiezoelectricLaw Piezoelectricity::law() const
  {
    PiezoelectricLaw law{};
    law.stiffness    = {{{{c11, c12, c13, 0., 0., 0.}},
                         {{c12, c11, c13, 0., 0., 0.}},
                         {{c13, c13, c33, 0., 0., 0.}},
                         {{0., 0., 0., c44, 0., 0.}},
                         {{0., 0., 0., 0., c44, 0.}},
                         {{0., 0., 0., 0., 0., 0.5 * (c11 - c12)}}}};
    const bool is_d  = form == CouplingForm::d;
    const double e31 = is_d ? coupling31 * (c11 + c12) + coupling33 * c13 : coupling31;
    const double e33 = is_d ? 2. * coupling31 * c13 + coupling33 * c33 : coupling33;
    const double e15 = is_d ? coupling15 * c44 : coupling15;
    law.coupling     = {
            {{{0., 0., 0., 0., e15, 0.}}, {{0., 0., 0., e15, 0., 0.}}, {{e31, e31, e33, 0., 0., 0.}}}};
    double eps11 = permittivity11, eps33 = permittivity33;
    if (permittivity_at == PermittivityAt::stress)
    {
      // d c d^T = e c^-1 e^T; along z for equal strains along x and y
      const double determinant = (c11 + c12) * c33 - 2. * c13 * c13;
      eps11 -= e15 * e15 / c44;
      eps33 -=
          (2. * e31 * e31 * c33 - 4. * e31 * e33 * c13 + e33 * e33 * (c11 + c12)) / determinant;
    }
    law.permittivity = {{{{eps11, 0., 0.}}, {{0., eps11, 0.}}, {{0., 0., eps33}}}};
    return law;
  }

  double Piezoelectricity::thickness_coupling() const
  {
    const PiezoelectricLaw of_ceramic = law();
    const double e33 = of_ceramic.coupling[2][2], eps33 = of_ceramic.permittivity[2][2];
    return std::sqrt(e33 * e33 / (c33 * eps33 + e33 * e33));
  }

  namespace
  {
    void require(const bool is_met, const std::string &entry, const double value,
                 const std::string &allowed, const std::string &advice)
    {
      if (!is_met)
        throw UserError("Piezoelectricity/" + entry + " = " + short_text(value) + " " + advice +
                        "; allowed: " + allowed);
    }
  } // namespace

  void Piezoelectricity::check() const
  {
    require(c12 < c11, "Stiffness c12", c12, "less than c11 = " + short_text(c11),
            "makes the ceramic unstable in shear along its faces");
    const double bound = std::sqrt(0.5 * (c11 + c12) * c33);
    require(c11 + c12 > 0. && std::abs(c13) < bound, "Stiffness c13", c13,
            "a magnitude below sqrt((c11 + c12) c33 / 2) = " + short_text(bound),
            "makes the ceramic unstable: its stiffness is not positive definite");
    constexpr double largest_d = 1e-8; // m/V; ceramics have up to 1e-9
    if (form == CouplingForm::d)
      for (const auto &[name, value] :
           {std::make_pair("Coupling 31", coupling31), std::make_pair("Coupling 33", coupling33),
            std::make_pair("Coupling 15", coupling15)})
        require(std::abs(value) <= largest_d, name, value, "up to 1e-8 m/V, or Coupling form = e",
                "is no constant d in m/V");
    if (coupling31 == 0. && coupling33 == 0.)
      throw UserError(
          "Piezoelectricity/Coupling 31 = 0 and Coupling 33 = 0: such a ceramic does not "
          "answer to a voltage; allowed: one of them different from 0, or "
          "Effects/Piezoelectric coupling = off");
    const PiezoelectricLaw of_ceramic = law();
    const std::string advice = "leaves, without the part that comes from strains, no positive "
                               "permittivity of the clamped ceramic: a coupling factor of 1 or "
                               "more; check the units, and Permittivity at";
    const double e15         = of_ceramic.coupling[0][4];
    require(of_ceramic.permittivity[0][0] > 0., "Permittivity 11", permittivity11,
            "more than e15^2/c44 = " + short_text(e15 * e15 / c44), advice);
    require(of_ceramic.permittivity[2][2] > 0., "Permittivity 33", permittivity33,
            "more than " + short_text(permittivity33 - of_ceramic.permittivity[2][2]), advice);
  }

  std::vector<std::string> Piezoelectricity::warnings() const
  {
    std::vector<std::string> lines;
    if (coupling31 * coupling33 > 0.)
      lines.push_back("Piezoelectricity/Coupling 31 and Coupling 33 have the same sign: in a poled "
                      "ceramic they have opposite signs; the values are used as given");
    const double k_t = thickness_coupling();
    if (coupling33 != 0. && (k_t < 0.2 || k_t > 0.75))
      lines.push_back("the section Piezoelectricity gives a thickness coupling factor k_t = " +
                      short_text(k_t) +
                      ", that of poled ceramics is 0.3 to 0.6: check Coupling form, Permittivity "
                      "at and units; the values are used as given");
    return lines;
  }

  void Piezoelectricity::declare(ParameterHandler &prm)
  {
    const Notation<double> stiffness = plausible(positive_number(), 1e9, 1e12);
    add_entry(prm, "Stiffness c11", c11, stiffness,
              "Elastic stiffness at constant electric field, along a face of the ceramic, which is "
              "poled along z; with Effects/Piezoelectric coupling the constants of this section "
              "replace Young modulus and Poisson ratio of Materials/Piezoceramic. Units: Pa.",
              Presence::required);
    add_entry(prm, "Stiffness c12", c12, plausible(any_number(), 1e9, 1e12),
              "The same between two directions along a face; c66 = (c11 - c12)/2. Units: Pa.",
              Presence::required);
    add_entry(prm, "Stiffness c13", c13, plausible(any_number(), 1e9, 1e12),
              "The same between the poling axis and a direction along a face. Units: Pa.",
              Presence::required);
    add_entry(prm, "Stiffness c33", c33, stiffness, "The same along the poling axis. Units: Pa.",
              Presence::required);
    add_entry(prm, "Stiffness c44", c44, stiffness,
              "The same in shear across the faces (yz and xz). Units: Pa.", Presence::required);
    add_entry(prm, "Coupling form", form,
              selection<CouplingForm>({{"e", CouplingForm::e}, {"d", CouplingForm::d}}),
              "Whether the next entries are e, the charge per area and strain (C/m^2), or d, the "
              "charge per force (C/N, the same as m/V), which are converted to e.");
    add_entry(prm, "Coupling 31", coupling31, any_number(),
              "Constant e31 or d31, of charge on the faces and extension along them; negative. "
              "Units: C/m^2 for e and m/V for d.",
              Presence::required);
    add_entry(prm, "Coupling 33", coupling33, any_number(),
              "Constant e33 or d33, of charge on the faces and extension across them; positive. "
              "Units: C/m^2 for e and m/V for d.",
              Presence::required);
    add_entry(prm, "Coupling 15", coupling15, any_number(),
              "Constant e15 or d15, of charge along the faces and shear across them. Units: C/m^2 "
              "for e and m/V for d.",
              Presence::required);
    add_entry(prm, "Permittivity at", permittivity_at,
              selection<PermittivityAt>(
                  {{"strain", PermittivityAt::strain}, {"stress", PermittivityAt::stress}}),
              "Whether the next entries hold at constant strain (clamped) or at constant stress "
              "(free, what data sheets give), from which they are converted.");
    const Notation<double> permittivity = plausible(positive_number(), 1e-10, 1e-6);
    add_entry(prm, "Permittivity 11", permittivity11, permittivity,
              "Permittivity along the faces, 8.854e-12 F/m times the relative one. Units: F/m.",
              Presence::required);
    add_entry(prm, "Permittivity 33", permittivity33, permittivity,
              "Permittivity along the poling axis. Units: F/m.", Presence::required);
    const Notation<double> loss = number_within(0., 1., "a number from 0 to 1");
    add_entry(prm, "Dielectric loss factor", dielectric_loss_factor, loss,
              "Tangent of the loss angle of the permittivity. Units: none.", Presence::required);
    add_entry(prm, "Piezoelectric loss factor", piezoelectric_loss_factor, loss,
              "Tangent of the loss angle of the coupling constants. Units: none.");
  }
} // namespace ringmotor
