// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/wave/energy.h>

namespace ringmotor
{
  using namespace dealii;

  WaveEnergy wave_energy(const CyclicSector &sector, const Mode &mode)
  {
    // The mean of Re(U exp(i omega t))^2 is |U|^2 / 2; a half sector counts twice.
    const SectorMesh &mesh = sector.sector_mesh();
    const double factor    = 0.25 * mesh.n_sectors * (mesh.form == SectorForm::half ? 2. : 1.);

    const MotionProducts products = motion_products(sector, {&mode.motion}).front();
    WaveEnergy energy;
    for (const auto &[material, product] : products.stiffness)
      energy.strain[material] = factor * product;
    energy.total_strain = factor * products.total_stiffness();
    energy.electric     = factor * (2. * products.electric.coupling - products.electric.dielectric);
    energy.kinetic      = factor * mode.eigenvalue * products.mass;
    return energy;
  }

  double modal_mass(const WaveEnergy &energy, const Mode &mode, const double amplitude)
  {
    // Kinetic energy of the wave = (1/2) m omega^2 amplitude^2 of each of its two standing modes, a
    // quarter period apart: at any time they add up to that of one at its peak.
    return 2. * energy.kinetic / (mode.eigenvalue * amplitude * amplitude);
  }
} // namespace ringmotor
