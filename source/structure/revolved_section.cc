// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/structure/independent_dofs.h>
#include <ringmotor/structure/revolved_section.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The face of a cell (of a shell: its edge) on the mirror plane; none if there is none. */
    template <typename Cell>
    unsigned int face_on_mirror(const Cell &cell)
    {
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == ids::mirror)
          return face;
      return none;
    }

    /** Whether all corners of a cell are on its mirror plane or turned from there by @p angle. */
    template <typename Cell>
    bool is_revolved(const Cell &cell, const double angle)
    {
      const unsigned int face = face_on_mirror(cell);
      if (face == none)
        return false;
      std::vector<Point<3>> here, there;
      for (const unsigned int vertex : cell->vertex_indices())
      {
        const Point<3> place = cylindrical(cell->vertex(vertex));
        if (is_same_place(place[1], 0., angle))
          here.push_back(place);
        else if (is_same_place(place[1], angle, angle))
          there.push_back(place);
      }
      return here.size() == there.size() && 2 * here.size() == cell->n_vertices() &&
             std::all_of(here.begin(), here.end(),
                         [&](const Point<3> &a)
                         {
                           return std::any_of(there.begin(), there.end(),
                                              [&](const Point<3> &b) {
                                                return is_same_place(a[0], b[0], a[0]) &&
                                                       is_same_place(a[2], b[2], a[0]);
                                              });
                         });
    }

    double meshed_angle_of(const SectorElements &sector)
    {
      return numbers::PI / sector.sector_mesh().n_sectors;
    }

    /** For each node of a scalar element the one on a face at the same place along it. */
    template <int dim>
    std::vector<unsigned int> nodes_on_face(const FiniteElement<dim, 3> &scalar,
                                            const unsigned int face)
    {
      std::vector<unsigned int> of_face;
      const std::vector<Point<dim>> &places = scalar.get_unit_support_points();
      for (Point<dim> place : places)
      {
        place[face / 2] = face % 2;
        of_face.push_back(std::min_element(places.begin(), places.end(),
                                           [&](const Point<dim> &a, const Point<dim> &b)
                                           { return a.distance(place) < b.distance(place); }) -
                          places.begin());
      }
      return of_face;
    }

    /** Unknowns are the degrees of freedom on the mirror plane that depend on no others. */
    std::vector<unsigned int> number_rows(const SectorElements &sector)
    {
      std::vector<unsigned int> row(sector.n_dofs(), none);
      unsigned int n_rows = 0;
      for (SectorNodes::Dof dof = 0; dof < row.size(); ++dof)
        if (sector.nodes().on(dof, ids::mirror) && !sector.dependent().is_constrained(dof))
          row[dof] = n_rows++;
      return row;
    }

    std::array<FullMatrix<double> *, 4> all_of(WaveMatrices &matrices)
    {
      return {{&matrices.constant, &matrices.linear, &matrices.quadratic, &matrices.mass}};
    }

    std::vector<SectorNodes::Dof> at(const std::vector<unsigned int> &places,
                                     const std::vector<SectorNodes::Dof> &dofs)
    {
      std::vector<SectorNodes::Dof> chosen;
      for (const unsigned int place : places)
        chosen.push_back(dofs[place]);
      return chosen;
    }
  } // namespace

  bool RevolvedSection::describes(const SectorElements &sector)
  {
    const SectorMesh &mesh = sector.sector_mesh();
    if (mesh.form != SectorForm::half || !mesh.has_cuts || !mesh.bars.empty() ||
        Utilities::MPI::n_mpi_processes(sector.communicator()) > 1)
      return false;
    const double angle = meshed_angle_of(sector);
    if (sector.dofs().has_active_dofs())
      for (const auto &cell : sector.dofs().active_cell_iterators())
        if (!is_revolved(cell, angle) || sector.material_table().at(cell->material_id()).law)
          return false;
    if (sector.shell_dofs().has_active_dofs())
    {
      if (sector.shell_dofs().get_fe().degree < 2)
        return false; // has shear strains of its own
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
        if (!is_revolved(cell, angle))
          return false;
    }
    return true;
  }

  RevolvedSection::RevolvedSection(const SectorElements &sector)
      : sector(sector), meshed_angle(meshed_angle_of(sector)), row(number_rows(sector)),
        n_unknowns(row.size() - std::count(row.begin(), row.end(), none)),
        factors(n_unknowns, MPI_COMM_SELF)
  {
    Assert(describes(sector), ExcMessage("Not one layer of cells of a body of revolution."));
    find_sources();
    find_copies();
    if (sector.dofs().has_active_dofs())
    {
      add_solids();
      add_foundations();
    }
    if (sector.shell_dofs().has_active_dofs())
      add_shells();
  }

  template <int dim>
  void RevolvedSection::find_sources(const FiniteElement<dim, 3> &fe, const unsigned int face,
                                     const std::vector<Dof> &dofs)
  {
    const std::vector<unsigned int> of_face = nodes_on_face(fe.base_element(0), face);
    for (unsigned int i = 0; i < of_face.size(); ++i)
      for (unsigned int component = 0; component < fe.n_components(); component += 3)
        source[sector.nodes().node(dofs[fe.component_to_system_index(component, i)])] =
            sector.nodes().node(dofs[fe.component_to_system_index(component, of_face[i])]);
  }

  void RevolvedSection::find_sources()
  {
    source.assign(sector.nodes().size(), none);
    if (sector.dofs().has_active_dofs())
      for (const auto &cell : sector.dofs().active_cell_iterators())
        find_sources(sector.dofs().get_fe(), face_on_mirror(cell), sector.dofs_of(cell));
    if (sector.shell_dofs().has_active_dofs())
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
        find_sources(sector.shell_dofs().get_fe(), face_on_mirror(cell), sector.dofs_of(cell));
  }

  void RevolvedSection::find_copies()
  {
    const SectorNodes &nodes = sector.nodes();
    for (unsigned int node = 0; node < source.size(); ++node)
    {
      const Point<3> &x        = nodes.position(node);
      const double angle       = std::atan2(x[1], x[0]);
      const auto known         = std::find_if(angles.begin(), angles.end(),
                                              [&](const double other)
                                              { return is_same_place(angle, other, meshed_angle); });
      const unsigned int place = known - angles.begin();
      if (known == angles.end())
        angles.push_back(angle);
      const std::array<Tensor<1, 3>, 3> axes{{Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}),
                                              Tensor<1, 3>({-std::sin(angle), std::cos(angle), 0.}),
                                              Tensor<1, 3>({0., 0., 1.})}};
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
        {
          const Dof to = nodes.dof(node, d), from = nodes.dof(source[node], c);
          if (const double weight = nodes.direction(to) * axes[c]; weight != 0.)
            copies.push_back({to, from, place, nodes.turned_by_mirror(from), weight});
        }
    }
  }

  void RevolvedSection::add_solids()
  {
    SemiAnalyticSolid solid(sector.geometry(), sector.dofs().get_fe());
    for (const auto &cell : sector.dofs().active_cell_iterators())
    {
      const unsigned int face = face_on_mirror(cell);
      add(at(solid.local_dofs(face), sector.dofs_of(cell)),
          solid.matrices(cell, face, sector.material_table().at(cell->material_id())));
    }
  }

  void RevolvedSection::add_shells()
  {
    SemiAnalyticShell shell(sector.shell_geometry(), sector.shell_dofs().get_fe());
    for (const auto &cell : sector.shell_dofs().active_cell_iterators())
    {
      const unsigned int edge = face_on_mirror(cell);
      add(at(shell.local_dofs(edge), sector.dofs_of(cell)),
          shell.matrices(cell, edge, sector.material_table().at(cell->material_id()),
                         sector.sector_mesh().sections.at(cell->material_id()), meshed_angle));
    }
  }

  void RevolvedSection::add_foundations()
  {
    // Springs along a normal that turns with the body store the same energy for waves of any
    // order. It is taken from the motion with n = 0, which is the same all around.
    const FiniteElement<3> &fe = sector.dofs().get_fe();
    const SectorNodes &nodes   = sector.nodes();
    const SemiAnalyticSolid solid(sector.geometry(), fe);
    sector.for_each_owned_foundation(
        [&](const auto &cell, const types::boundary_id, FoundationElement &element)
        {
          const std::vector<Dof> dofs    = sector.dofs_of(cell),
                                 on_face = at(solid.local_dofs(face_on_mirror(cell)), dofs);
          std::map<Dof, unsigned int> place;
          for (const Dof dof : on_face)
            place.emplace(dof, place.size());
          FullMatrix<double> stiffness(dofs.size(), dofs.size()),
              follows(dofs.size(), on_face.size());
          element.matrix(stiffness);
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int node = nodes.node(dofs[i]),
                               c    = fe.system_to_component_index(i).first;
            const Point<3> &x       = nodes.position(node);
            if (c == 2)
              follows(i, place.at(nodes.dof(source[node], 2))) = 1.;
            else
              follows(i, place.at(nodes.dof(source[node], 0))) = x[c] / std::hypot(x[0], x[1]);
          }
          WaveMatrices matrices;
          for (FullMatrix<double> *matrix : all_of(matrices))
            matrix->reinit(on_face.size(), on_face.size());
          matrices.constant.add(1. / meshed_angle, transformed(stiffness, follows));
          add(on_face, std::move(matrices));
        });
  }

  unsigned int RevolvedSection::row_of(const Dof dof) const
  {
    AssertThrow(row[dof] != none, ExcMessage("A node follows one at another angle."));
    return row[dof];
  }

  void RevolvedSection::add(const std::vector<Dof> &dofs, WaveMatrices matrices)
  {
    const IndependentDofs independent(dofs, sector.dependent());
    if (independent.dofs().empty())
      return;
    for (FullMatrix<double> *matrix : all_of(matrices))
    {
      independent.condense(*matrix);
      *matrix *= meshed_angle;
    }
    Element element{{}, std::move(matrices)};
    for (const Dof dof : independent.dofs())
      element.rows.push_back(row_of(dof));
    elements.push_back(std::move(element));
  }

  void RevolvedSection::factorise(const int order, const double shift)
  {
    SymmetricElements shifted;
    const double n = order;
    for (const auto &[rows, matrices] : elements)
    {
      std::vector<double> lower;
      lower.reserve(rows.size() * (rows.size() + 1) / 2);
      for (unsigned int column = 0; column < rows.size(); ++column)
        for (unsigned int i = column; i < rows.size(); ++i) // symmetric: rows are stored
          lower.push_back(matrices.constant(column, i) +
                          n * (matrices.linear(column, i) + n * matrices.quadratic(column, i)) -
                          shift * matrices.mass(column, i));
      shifted.add(rows, lower);
    }
    factors.factorise(std::move(shifted));
  }

  void RevolvedSection::multiply_mass(const std::vector<double> &unknowns,
                                      std::vector<double> &product) const
  {
    product.assign(unknowns.size(), 0.);
    std::vector<double> moves, inertia;
    for (const auto &[rows, matrices] : elements)
    {
      const unsigned int n = rows.size(), n_vectors = unknowns.size() / n_unknowns;
      moves.clear();
      for (std::size_t begin = 0; begin < unknowns.size(); begin += n_unknowns)
        for (const unsigned int r : rows)
          moves.push_back(unknowns[begin + r]);
      inertia.assign(moves.size(), 0.);
      const std::vector<double> mass(&matrices.mass(0, 0), &matrices.mass(0, 0) + n * n);
      add_product(1., Transposed::no, mass, n, moves, inertia);
      for (unsigned int vector = 0; vector < n_vectors; ++vector)
        for (unsigned int i = 0; i < n; ++i)
          product[vector * n_unknowns + rows[i]] += inertia[vector * n + i];
    }
  }

  std::vector<double> RevolvedSection::loads_of(const LinearForm &load) const
  {
    std::vector<double> loads(n_unknowns, 0.);
    for (const auto &[dof, force] : load)
    {
      const auto *const masters = sector.dependent().get_constraint_entries(dof);
      if (!masters)
        loads[row_of(dof)] += force;
      else
        for (const auto &[master, weight] : *masters)
          loads[row_of(master)] += weight * force;
    }
    return loads;
  }

  SectorMotion RevolvedSection::expand(const int order, const double *const unknowns) const
  {
    Vector<double> in_section(sector.n_dofs());
    for (Dof dof = 0; dof < row.size(); ++dof)
      if (row[dof] != none)
        in_section[dof] = unknowns[row[dof]];
    sector.dependent().distribute(in_section);
    std::vector<std::array<double, 2>> turns; // cosine and sine
    for (const double angle : angles)
      turns.push_back({{std::cos(order * angle), std::sin(order * angle)}});
    std::array<Vector<double>, 2> fields{
        {Vector<double>(sector.n_dofs()), Vector<double>(sector.n_dofs())}};
    for (const Copy &copy : copies)
    {
      const auto &[cosine, sine] = turns[copy.angle];
      const double moved         = copy.weight * in_section[copy.from];
      // i^is_turned exp(-i n theta)
      fields[0][copy.to] += moved * (copy.is_turned ? sine : cosine);
      fields[1][copy.to] += moved * (copy.is_turned ? cosine : -sine);
    }
    return sector.to_motion(std::move(fields));
  }
} // namespace ringmotor
