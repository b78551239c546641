// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/quantities/energy.h>

#include <deal.II/base/mpi.h>

namespace ringmotor
{
  using namespace dealii;

  WaveEnergy wave_energy(const CyclicSector &sector, const Mode &mode)
  {
    // The mean of Re(U exp(i omega t))^2 is |U|^2 / 2; a half sector counts twice.
    const SectorMesh &mesh = sector.sector_mesh();
    const double factor    = 0.25 * mesh.n_sectors * (mesh.form == SectorForm::half ? 2. : 1.);

    WaveEnergy energy;
    for (const auto &entry : sector.material_table())
      energy.strain[entry.first] = 0.;
    std::vector<Vector<double>> values(2, Vector<double>(sector.dofs().get_fe().n_dofs_per_cell()));
    sector.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          cell->get_dof_values(mode.displacement.real, values[0]);
          cell->get_dof_values(mode.displacement.imaginary, values[1]);
          for (const double product : element.stiffness_products(values))
            energy.strain[cell->material_id()] += factor * product;
          for (const double product : element.mass_products(values))
            energy.kinetic += factor * mode.eigenvalue * product;
        });
    const MPI_Comm communicator = sector.dofs().get_communicator();
    for (auto &entry : energy.strain)
      energy.total_strain += entry.second = Utilities::MPI::sum(entry.second, communicator);
    energy.kinetic = Utilities::MPI::sum(energy.kinetic, communicator);
    return energy;
  }

  double modal_mass(const WaveEnergy &energy, const Mode &mode, const double amplitude)
  {
    // Kinetic energy of the wave = (1/2) m omega^2 amplitude^2 of each of its two standing modes, a
    // quarter period apart: at any time they add up to that of one at its peak.
    return 2. * energy.kinetic / (mode.eigenvalue * amplitude * amplitude);
  }
} // namespace ringmotor
