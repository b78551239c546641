// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/electric_response.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
    using Dofs    = std::vector<SectorNodes::Dof>;

    Vector<double> at(const Dofs &dofs, const Vector<double> &field, const unsigned int first)
    {
      Vector<double> values(dofs.size());
      for (unsigned int i = 0; i < dofs.size(); ++i)
        values[i] = field[dofs[i] - first];
      return values;
    }

    void add_at(const Dofs &dofs, const Vector<double> &values, const unsigned int first,
                Vector<double> &field)
    {
      for (unsigned int i = 0; i < dofs.size(); ++i)
        field[dofs[i] - first] += values[i];
    }
  } // namespace

  ElectricResponse::ElectricResponse(const CyclicSector &sector)
      : sector(sector), electrode(sector.electrode_dofs())
  {
    sector.for_each_owned_cell(
        [&](const auto &cell, SolidElement &element)
        {
          if (!sector.has_potential(cell))
            return;
          Cell mine;
          mine.displacements     = sector.dofs_of(cell);
          mine.potentials        = sector.potential_dofs_of(cell);
          const unsigned int n_u = mine.displacements.size(), n_phi = mine.potentials.size();
          FullMatrix<double> stiffness(n_u, n_u);
          mine.coupling.reinit(n_u, n_phi);
          mine.dielectric.reinit(n_phi, n_phi);
          element.piezoelectric_matrices(stiffness, mine.coupling, mine.dielectric);
          cells.push_back(std::move(mine));
        });
  }

  SectorMotion ElectricResponse::electric_loads(const SectorMotion &motion) const
  {
    SectorMotion loads       = sector.at_rest();
    const unsigned int first = sector.nodes().first_potential_dof();
    for (Vector<double> ComplexField::*const part : {&ComplexField::real, &ComplexField::imaginary})
    {
      for (const Cell &cell : cells)
      {
        const Vector<double> u   = at(cell.displacements, motion.solid.*part, 0),
                             phi = at(cell.potentials, motion.potential.*part, first);
        Vector<double> forces(u.size()), charges(phi.size()), by_motion(phi.size());
        cell.coupling.vmult(forces, phi);
        cell.dielectric.vmult(charges, phi);
        cell.coupling.Tvmult(by_motion, u);
        charges -= by_motion;
        add_at(cell.displacements, forces, 0, loads.solid.*part);
        add_at(cell.potentials, charges, first, loads.potential.*part);
      }
      for (Vector<double> *field : {&(loads.solid.*part), &(loads.potential.*part)})
        Utilities::MPI::sum(*field, sector.communicator(), *field);
    }
    return loads;
  }

  std::complex<double> ElectricResponse::charge(const SectorMotion &motion, const int k) const
  {
    return charge_of_loads(electric_loads(motion), k);
  }

  std::complex<double> ElectricResponse::charge_of_loads(const SectorMotion &loads,
                                                         const int k) const
  {
    const SectorNodes &nodes = sector.nodes();
    Complex sum              = 0.;
    for (const SectorNodes::Dof dof : electrode)
    {
      const Point<3> &x       = nodes.position(nodes.node(dof));
      const unsigned int i    = dof - nodes.first_potential_dof();
      const Complex of_sector = std::polar(1., k * std::atan2(x[1], x[0])) *
                                Complex(loads.potential.real[i], loads.potential.imaginary[i]);
      // The other half of a sector has the conjugate.
      sum += sector.is_complex() ? of_sector : 2. * of_sector.real();
    }
    return static_cast<double>(sector.sector_mesh().n_sectors) * sum;
  }

  SectorMotion ElectricResponse::driven(const int k) const
  {
    SectorMotion motion      = sector.at_rest();
    const SectorNodes &nodes = sector.nodes();
    for (const SectorNodes::Dof dof : electrode)
    {
      const Point<3> &x             = nodes.position(nodes.node(dof));
      const Complex there           = std::polar(1., -k * std::atan2(x[1], x[0]));
      const unsigned int i          = dof - nodes.first_potential_dof();
      motion.potential.real[i]      = there.real();
      motion.potential.imaginary[i] = there.imag();
    }
    return motion;
  }

  FullMatrix<std::complex<double>>
  ElectricResponse::capacitances(CyclicFactors &factors, const unsigned int n, const double shift,
                                 const std::vector<int> &harmonics) const
  {
    factors.factorise(n, shift);
    std::vector<double> sides;
    for (const int k : harmonics)
    {
      // K u + B phi = -B phi_e and B^T u - D phi = D phi_e
      SectorMotion loads = electric_loads(driven(k));
      loads.solid.real *= -1.;
      loads.solid.imaginary *= -1.;
      const std::vector<double> of_unknowns = sector.loads_of(n, loads);
      sides.insert(sides.end(), of_unknowns.begin(), of_unknowns.end());
    }
    factors.solve(sides);
    FullMatrix<Complex> result(harmonics.size(), harmonics.size());
    for (unsigned int column = 0; column < harmonics.size(); ++column)
    {
      const auto begin             = sides.begin() + column * sector.n_unknowns();
      SectorMotion motion          = sector.expand(n, {begin, begin + sector.n_unknowns()});
      const SectorMotion potential = driven(harmonics[column]);
      motion.potential.real += potential.potential.real;
      motion.potential.imaginary += potential.potential.imaginary;
      const SectorMotion loads = electric_loads(motion);
      for (unsigned int row = 0; row < harmonics.size(); ++row)
        result(row, column) = charge_of_loads(loads, harmonics[row]);
    }
    return result;
  }
} // namespace ringmotor
