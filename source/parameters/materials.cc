// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/materials.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  void Material::declare(ParameterHandler &prm)
  {
    const Presence presence = Presence::required;
    add_entry(prm, "Young modulus", young_modulus, modulus(), "Modulus of elasticity. Units: Pa.",
              presence);
    add_entry(prm, "Poisson ratio", poisson_ratio,
              number_within(std::nextafter(-1., 0.), std::nextafter(0.5, 0.),
                            "a number above -1 and below 0.5 (at 0.5 a solid is incompressible, "
                            "which these elements cannot represent)"),
              "Transverse contraction over axial extension. Units: none.", presence);
    add_entry(prm, "Density", density, plausible(positive_number(), 100., 25000.),
              "Mass per volume. Units: kg/m^3.", presence);
    add_entry(prm, "Loss factor", loss_factor, number_within(0., 1., "a number from 0 to 1"),
              "Energy lost per radian of vibration over the largest stored energy. Units: none.",
              presence);
  }

  void Materials::declare(ParameterHandler &prm)
  {
    const auto declare_material = [&prm](const std::string &name, Material &material)
    {
      prm.enter_subsection(name);
      material.declare(prm);
      prm.leave_subsection();
    };
    declare_material("Stator metal", stator_metal);
    declare_material("Piezoceramic", piezoceramic);
    declare_material("Rotor metal", rotor_metal);
    declare_material("Target plate", target_plate);
    declare_material("Lining", lining);
    declare_material("Adhesive", adhesive);
  }
} // namespace ringmotor
