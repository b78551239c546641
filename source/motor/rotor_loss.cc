// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/motor/rotor_loss.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/surface_load.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The materials of a rotor's parts, by part. */
    MaterialTable materials_of_parts(const Parameters &parameters)
    {
      const auto rotor = rotor_shape(parameters);
      MaterialTable parts;
      for (const auto &[part, material] : material_table(parameters.materials, Body::rotor))
        if (rotor->has_part(part))
          parts.emplace(part, material);
      return parts;
    }

    /** An even pressure on the face in contact that travels with k waves: forces on the
     * displacements of its nodes, real field, then imaginary one. */
    CondensationLoad even_pressure(const RotorBody &body, const unsigned int k)
    {
      using Complex       = std::complex<double>;
      const auto traction = [k](const Point<3> &x) {
        return std::array<Complex, 3>{{0., 0., std::polar(1., -1. * k * std::atan2(x[1], x[0]))}};
      };
      const auto forces = body.sector.from_forces(face_load(body.sector, ids::lip, traction));
      CondensationLoad load;
      for (const unsigned int part : {0u, 1u})
        for (const LinearForm &form : displacement_forms(body.lip))
        {
          load.forces.push_back(0.);
          for (const auto &[dof, coefficient] : form)
            load.forces.back() += coefficient * forces[part][dof];
        }
      return load;
    }
  } // namespace

  double rotor_loss_factor(const Parameters &parameters)
  {
    const MaterialTable parts = materials_of_parts(parameters);
    if (parts.size() == 1)
      return parts.begin()->second.loss_factor;
    constexpr unsigned int n_harmonics = 6;
    constexpr double pressed           = 0.25; // of a wavelength
    const RotorBody body(parameters, ContactDiscretisation::level(0));
    const Condensation condensation = body.condensed(true);
    double lost = 0., stored = 0.;
    for (unsigned int m = 1; m <= n_harmonics; ++m)
    {
      const unsigned int k = nodal_diameter_of_harmonic(parameters.motor, m);
      if (k < 2) // it also moves as a whole
        continue;
      const double phase  = numbers::PI * m * pressed,
                   weight = m * std::pow(std::sin(phase) / phase, 2);
      const SectorMotion motion =
          condensation.interior(k, body.held(k), {even_pressure(body, k)}).front();
      for (const auto &[part, energy] : motion_products(body.sector, {&motion}).front().stiffness)
      {
        if (const auto material = parts.find(part); material != parts.end())
        {
          lost += weight * energy * material->second.loss_factor;
          stored += weight * energy;
        }
      }
    }
    return stored > 0. ? lost / stored : largest_rotor_loss_factor(parameters);
  }

  double largest_rotor_loss_factor(const Parameters &parameters)
  {
    double largest = 0.;
    for (const auto &[part, material] : materials_of_parts(parameters))
      largest = std::max(largest, material.loss_factor);
    return largest;
  }
} // namespace ringmotor
