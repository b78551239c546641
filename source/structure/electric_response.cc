// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_ldlt.h>
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/structure/electric_response.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
    using Dofs    = std::vector<SectorNodes::Dof>;

    double angle(const Point<3> &position)
    {
      return std::atan2(position[1], position[0]);
    }

    Vector<double> at(const Dofs &dofs, const Vector<double> &field, const unsigned int first)
    {
      Vector<double> values(dofs.size());
      for (unsigned int i = 0; i < dofs.size(); ++i)
        values[i] = field[dofs[i] - first];
      return values;
    }

    /** The charges D phi - B^T u of a motion, by degree of freedom of the potential, on all ranks.
     */
    ComplexField charges_of(const CyclicSector &sector, const SectorMotion &motion)
    {
      const unsigned int first = sector.nodes().first_potential_dof();
      ComplexField charges     = sector.at_rest().potential;
      FullMatrix<double> stiffness, coupling, dielectric;
      sector.for_each_owned_cell(
          [&](const auto &cell, SolidElement &element)
          {
            if (!sector.has_potential(cell))
              return;
            const Dofs displacements = sector.dofs_of(cell),
                       potentials    = sector.potential_dofs_of(cell);
            stiffness.reinit(displacements.size(), displacements.size());
            coupling.reinit(displacements.size(), potentials.size());
            dielectric.reinit(potentials.size(), potentials.size());
            element.piezoelectric_matrices(stiffness, coupling, dielectric);
            Vector<double> by_potential(potentials.size()), by_motion(potentials.size());
            for (Vector<double> ComplexField::*const part :
                 {&ComplexField::real, &ComplexField::imaginary})
            {
              dielectric.vmult(by_potential, at(potentials, motion.potential.*part, first));
              coupling.Tvmult(by_motion, at(displacements, motion.solid.*part, 0));
              for (unsigned int i = 0; i < potentials.size(); ++i)
                (charges.*part)[potentials[i] - first] += by_potential[i] - by_motion[i];
            }
          });
      for (Vector<double> *field : {&charges.real, &charges.imaginary})
        Utilities::MPI::sum(*field, sector.communicator(), *field);
      return charges;
    }
  } // namespace

  std::vector<std::complex<double>> electrode_charges(const CyclicSector &sector,
                                                      const SectorMotion &motion,
                                                      const std::vector<int> &harmonics)
  {
    const ComplexField charges = charges_of(sector, motion);
    const SectorNodes &nodes   = sector.nodes();
    std::vector<Complex> sums(harmonics.size(), 0.);
    for (const SectorNodes::Dof dof : sector.electrode_dofs())
    {
      const unsigned int i = dof - nodes.first_potential_dof();
      const Complex there(charges.real[i], charges.imaginary[i]);
      const double theta = angle(nodes.position(nodes.node(dof)));
      for (unsigned int h = 0; h < harmonics.size(); ++h)
      {
        const Complex of_sector = std::polar(1., harmonics[h] * theta) * there;
        // The other half of a sector has the conjugate.
        sums[h] += static_cast<double>(sector.sector_mesh().n_sectors) *
                   (sector.is_complex() ? of_sector : 2. * of_sector.real());
      }
    }
    return sums;
  }

  ElectricResponse::ElectricResponse(const SectorMesh &mesh, const MaterialTable &materials,
                                     const unsigned int degree)
      : sector(mesh, materials, degree, LowerElectrode::driven), kept{{kept_in(sector, 0),
                                                                       kept_in(sector, 1)}},
        factors(sector, all_kept())
  {
  }

  ElectricResponse::Kept ElectricResponse::kept_in(const CyclicSector &sector,
                                                   const unsigned int part)
  {
    const CyclicSector::RealField &field = sector.field(part);
    Kept kept;
    std::vector<bool> is_electrode(field.size, false);
    for (const SectorNodes::Dof dof : sector.electrode_dofs())
      if (const unsigned int number = field.number[dof]; number != none)
      {
        is_electrode[number] = true;
        kept.electrode.push_back(number);
        kept.positions.push_back(sector.nodes().position(sector.nodes().node(dof)));
      }
    for (const unsigned int number : field.cut)
    {
      kept.place.push_back(is_electrode[number] ? none : kept.cut.size());
      if (!is_electrode[number])
        kept.cut.push_back(number);
    }
    return kept;
  }

  ElectricResponse::PerField<std::vector<unsigned int>> ElectricResponse::all_kept() const
  {
    PerField<std::vector<unsigned int>> all;
    for (const unsigned int part : {0u, 1u})
    {
      all[part] = kept[part].cut;
      all[part].insert(all[part].end(), kept[part].electrode.begin(), kept[part].electrode.end());
    }
    return all;
  }

  void ElectricResponse::condense(const double shift)
  {
    factors.factorise(shift);
    for (const unsigned int part : {0u, 1u})
    {
      const std::vector<double> &whole = factors.matrix(part);
      const std::size_t n_cut = kept[part].cut.size(), size = n_cut + kept[part].electrode.size();
      const auto block = [&](const std::size_t first_row, const std::size_t end_row,
                             const std::size_t first_column, const std::size_t end_column)
      {
        std::vector<double> entries;
        for (std::size_t column = first_column; column < end_column; ++column)
          entries.insert(entries.end(), whole.begin() + column * size + first_row,
                         whole.begin() + column * size + end_row);
        return entries;
      };
      fields[part] = {block(0, n_cut, 0, n_cut), block(n_cut, size, 0, n_cut),
                      block(n_cut, size, n_cut, size)};
    }
  }

  std::vector<double> ElectricResponse::potentials(const unsigned int part,
                                                   const std::vector<int> &harmonics) const
  {
    std::vector<double> values;
    for (const int k : harmonics)
      for (const Point<3> &position : kept[part].positions)
        values.push_back(part == 0 ? std::cos(k * angle(position))
                                   : -std::sin(k * angle(position)));
    return values;
  }

  ElectricResponse::PerField<std::vector<double>>
  ElectricResponse::motions_of_cuts(const unsigned int n,
                                    const PerField<std::vector<double>> &potentials) const
  {
    // The cuts of both fields are combinations of the same unknowns.
    struct Tie
    {
      std::size_t place, unknown;
      double factor;
    };
    PerField<std::vector<Tie>> ties;
    std::map<unsigned int, std::size_t> unknowns;
    for (const unsigned int part : {0u, 1u})
      for (const CyclicSector::Tie &tie : sector.ties(part, n))
        if (const unsigned int place = kept[part].place[tie.position]; place != none)
          ties[part].push_back(
              {place, unknowns.emplace(tie.unknown, unknowns.size()).first->second, tie.factor});

    const std::size_t n_unknowns = unknowns.size();
    std::vector<double> matrix(n_unknowns * n_unknowns, 0.), sides;
    for (const unsigned int part : {0u, 1u})
    {
      const Field &field      = fields[part];
      const std::size_t n_cut = kept[part].cut.size(), n_e = kept[part].electrode.size(),
                        n_sides = potentials[part].size() / std::max<std::size_t>(n_e, 1);
      for (const Tie &b : ties[part])
        for (const Tie &a : ties[part])
          matrix[b.unknown * n_unknowns + a.unknown] +=
              a.factor * b.factor * field.cc[b.place * n_cut + a.place];
      std::vector<double> loads(n_cut * n_sides, 0.);
      add_product(-1., Transposed::yes, field.ec, n_e, potentials[part], loads);
      sides.resize(n_unknowns * n_sides, 0.);
      for (std::size_t side = 0; side < n_sides; ++side)
        for (const Tie &tie : ties[part])
          sides[side * n_unknowns + tie.unknown] += tie.factor * loads[side * n_cut + tie.place];
    }
    DenseLDLT cut;
    cut.factorise(n_unknowns, std::move(matrix));
    cut.solve(sides);
    PerField<std::vector<double>> motions;
    for (const unsigned int part : {0u, 1u})
    {
      const std::size_t n_cut = kept[part].cut.size(), n_sides = sides.size() / n_unknowns;
      motions[part].assign(n_cut * n_sides, 0.);
      for (std::size_t side = 0; side < n_sides; ++side)
        for (const Tie &tie : ties[part])
          motions[part][side * n_cut + tie.place] +=
              tie.factor * sides[side * n_unknowns + tie.unknown];
    }
    return motions;
  }

  FullMatrix<std::complex<double>>
  ElectricResponse::capacitances(const unsigned int n, const std::vector<int> &harmonics) const
  {
    const PerField<std::vector<double>> given{{potentials(0, harmonics), potentials(1, harmonics)}},
        motions = motions_of_cuts(n, given);
    FullMatrix<Complex> result(harmonics.size(), harmonics.size());
    for (const unsigned int part : {0u, 1u})
    {
      // The rows of the potential in the matrix give minus the charges.
      const std::size_t n_e = kept[part].electrode.size();
      std::vector<double> charges(n_e * harmonics.size(), 0.);
      add_product(-1., Transposed::no, fields[part].ee, n_e, given[part], charges);
      add_product(-1., Transposed::no, fields[part].ec, kept[part].cut.size(), motions[part],
                  charges);
      for (unsigned int l = 0; l < harmonics.size(); ++l)
        for (unsigned int k = 0; k < harmonics.size(); ++k)
          for (std::size_t i = 0; i < n_e; ++i)
          {
            const Complex of_sector =
                std::polar(1., harmonics[l] * angle(kept[part].positions[i])) *
                (part == 0 ? Complex(1., 0.) : Complex(0., 1.)) * charges[k * n_e + i];
            // The other half of a sector has the conjugate.
            result(l, k) += static_cast<double>(sector.sector_mesh().n_sectors) *
                            (sector.is_complex() ? of_sector : 2. * of_sector.real());
          }
    }
    return result;
  }
} // namespace ringmotor
