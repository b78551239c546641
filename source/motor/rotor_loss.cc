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
#include <map>

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
      const auto forces   = body.sector.from_forces(face_load(body.sector, ids::lip, traction)),
                 of_shell = body.sector.from_forces(
                     lower_face_load(body.sector, ids::lip_shell, traction));
      CondensationLoad load;
      for (const unsigned int part : {0u, 1u})
        for (const LinearForm &form : displacement_forms(body.lip))
        {
          load.forces.push_back(0.);
          for (const auto &[dof, coefficient] : form)
            load.forces.back() += coefficient * (forces[part][dof] + of_shell[part][dof]);
        }
      return load;
    }

    /** The elastic energies of the parts under pressures that travel with the wave, relative to
     * each other. */
    std::map<types::material_id, double> energies_of_parts(const Parameters &parameters)
    {
      constexpr unsigned int n_harmonics = 6;
      constexpr double pressed           = 0.25; // of a wavelength
      const RotorBody body(parameters, ContactDiscretisation::level(0));
      const Condensation condensation = body.condensed(true);
      std::map<types::material_id, double> energies;
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
          energies[part] += weight * energy;
      }
      return energies;
    }

    /** Where the loss of a part belongs. */
    double &place_of(const types::material_id part, RotorLossFactor &loss)
    {
      return part == ids::lining ? loss.lining : part == ids::adhesive ? loss.adhesive : loss.metal;
    }
  } // namespace

  RotorLossFactor rotor_loss_by_part(const Parameters &parameters)
  {
    const MaterialTable parts = materials_of_parts(parameters);
    RotorLossFactor loss;
    loss.has_lining   = parts.count(ids::lining) > 0;
    loss.has_adhesive = parts.count(ids::adhesive) > 0;
    if (!loss.has_lining && !loss.has_adhesive)
    {
      loss.metal = parameters.materials.rotor_metal.loss_factor;
      return loss;
    }
    const auto by_part = loss_factor_by_part(parts, energies_of_parts(parameters));
    for (const auto &[part, loss_factor] : by_part)
      place_of(part, loss) += loss_factor;
    if (!by_part.empty())
      return loss;
    const auto largest             = std::max_element(parts.begin(), parts.end(),
                                                      [](const auto &a, const auto &b)
                                                      { return a.second.loss_factor < b.second.loss_factor; });
    place_of(largest->first, loss) = largest->second.loss_factor;
    return loss;
  }

  double rotor_loss_factor(const Parameters &parameters)
  {
    return rotor_loss_by_part(parameters).sum();
  }

  double largest_rotor_loss_factor(const Parameters &parameters)
  {
    double largest = 0.;
    for (const auto &[part, material] : materials_of_parts(parameters))
      largest = std::max(largest, material.loss_factor);
    return largest;
  }
} // namespace ringmotor
