// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/pictures/lattice.h>
#include <ringmotor/pictures/ring_body.h>
#include <ringmotor/structure/foot.h>
#include <ringmotor/structure/mirror.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    Tensor<1, 3> unit_vector(const unsigned int direction)
    {
      Tensor<1, 3> vector;
      vector[direction] = 1.;
      return vector;
    }

    /** The displacement by a shape function of a shell, @p arm away from its reference surface. */
    Tensor<1, 3> of_shell(const double shape, const unsigned int component, const Tensor<1, 3> &arm)
    {
      return component < 3 ? shape * unit_vector(component)
                           : shape * cross_product_3d(unit_vector(component - 3), arm);
    }

    /** How far from the reference surfaces of its shells a body reaches, m. */
    double reach_of_shells(const SectorMesh &mesh)
    {
      double reach = 0.;
      for (const auto &[material, section] : mesh.sections)
        reach = std::max({reach, -section.lower_face(), section.upper_face()});
      return reach;
    }
  } // namespace

  RingBody::RingBody(const SectorElements &sector, const unsigned int n_subdivisions,
                     const double height, const double turn)
      : n_sectors(sector.sector_mesh().n_sectors)
  {
    AssertThrow(sector.sector_mesh().form == SectorForm::half, ExcMessage("for half sectors"));
    if (sector.dofs().has_active_dofs())
      sample_solids(sector, n_subdivisions);
    if (sector.shell_dofs().has_active_dofs())
      sample_shells(sector, n_subdivisions);
    number_ring(height, turn);
  }

  std::optional<unsigned int> RingBody::point_at(const Point<3> &place) const
  {
    const auto found = known.find(key_of(place));
    return found == known.end() ? std::nullopt : std::optional<unsigned int>(found->second);
  }

  void RingBody::sample_solids(const SectorElements &sector, const unsigned int n_subdivisions)
  {
    const Quadrature<3> unit_points = lattice<3>(n_subdivisions);
    const FiniteElement<3> &element = sector.dofs().get_fe();
    FEValues<3> values(sector.geometry(), element, unit_points,
                       update_values | update_quadrature_points);
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : sector.dofs().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      Samples at_points(unit_points.size(), {false, {}});
      for (unsigned int q = 0; q < unit_points.size(); ++q)
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (const double shape = values.shape_value(i, q); std::abs(shape) > 1e-12)
            at_points[q].terms.emplace_back(
                dofs[i], shape * unit_vector(element.system_to_component_index(i).first));
      add_lattice(values.get_quadrature_points(), at_points, n_subdivisions);
    }
  }

  void RingBody::sample_shells(const SectorElements &sector, const unsigned int n_subdivisions)
  {
    const Quadrature<2> unit_points    = lattice<2>(n_subdivisions);
    const FiniteElement<2, 3> &element = sector.shell_dofs().get_fe();
    FEValues<2, 3> values(sector.shell_geometry(), element, unit_points,
                          update_values | update_quadrature_points | update_normal_vectors);
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : sector.shell_dofs().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      const ShellSection &section = sector.sector_mesh().sections.at(cell->material_id());
      std::vector<Point<3>> places;
      Samples at_points;
      for (unsigned int layer = 0; layer <= n_subdivisions; ++layer)
        for (unsigned int q = 0; q < unit_points.size(); ++q)
        {
          const Tensor<1, 3> arm =
              (section.lower_face() + section.thickness * layer / n_subdivisions) *
              values.normal_vector(q);
          places.push_back(values.quadrature_point(q) + arm);
          at_points.push_back({true, {}});
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int component = element.system_to_component_index(i).first;
            if (const double shape = values.shape_value(i, q); std::abs(shape) > 1e-12)
              at_points.back().terms.emplace_back(dofs[i], of_shell(shape, component, arm));
          }
        }
      add_lattice(places, at_points, n_subdivisions);
    }
  }

  RingBody::Samples RingBody::samples_in(const SectorElements &sector) const
  {
    std::vector<SectorElements::Cell> solids;
    std::vector<SectorElements::ShellCell> shells;
    if (sector.dofs().has_active_dofs())
      for (const auto &cell : sector.dofs().active_cell_iterators())
        solids.push_back(cell);
    if (sector.shell_dofs().has_active_dofs())
      for (const auto &cell : sector.shell_dofs().active_cell_iterators())
        shells.push_back(cell);
    constexpr double rounding = 1e-4; // and the shape of curved cells, of the distance to the axis
    const double reach        = (1. + rounding) * reach_of_shells(sector.sector_mesh());
    Samples found;
    const auto add = [&](const auto &foot, const bool is_of_shell, const Tensor<1, 3> &arm)
    {
      found.push_back({is_of_shell, {}});
      const auto &element = foot.cell->get_fe();
      std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
      foot.cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (const double shape = element.shape_value(i, foot.unit); std::abs(shape) > 1e-12)
          found.back().terms.emplace_back(
              dofs[i], of_shell(shape, element.system_to_component_index(i).first, arm));
    };
    for (unsigned int p = 0; p < half_points.size(); ++p)
    {
      const Point<3> &x = half_points[p];
      if (samples[p].of_shell)
      {
        const auto foot = foot_of<2>(x, shells, sector.shell_geometry(), reach);
        AssertThrow(foot, ExcMessage("a point of another shell"));
        add(*foot, true,
            x - sector.shell_geometry().transform_unit_to_real_cell(foot->cell, foot->unit));
      }
      else
      {
        const auto foot = foot_of<3>(x, solids, sector.geometry(), rounding * x.norm());
        AssertThrow(foot, ExcMessage("a point of another body"));
        add(*foot, false, {});
      }
    }
    return found;
  }

  void RingBody::add_lattice(const std::vector<Point<3>> &lattice, const Samples &at_points,
                             const unsigned int n_subdivisions)
  {
    std::vector<unsigned int> numbers;
    for (unsigned int q = 0; q < lattice.size(); ++q)
    {
      const auto [entry, is_new] = known.emplace(key_of(lattice[q]), half_points.size());
      if (is_new)
      {
        half_points.push_back(lattice[q]);
        samples.push_back(at_points[q]);
      }
      numbers.push_back(entry->second);
    }
    const unsigned int n = n_subdivisions, width = n + 1;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
        {
          std::array<unsigned int, 8> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell[v] = numbers[i + (v & 1) + width * (j + ((v >> 1) & 1) + width * (k + (v >> 2)))];
          half_cells.push_back(cell);
        }
  }

  void RingBody::number_ring(const double height, const double turn)
  {
    known.clear();
    const unsigned int n_half = half_points.size();
    for (unsigned int sector = 0; sector < n_sectors; ++sector)
    {
      const double angle = turn + 2. * numbers::PI * sector / n_sectors;
      turns.push_back({{std::cos(angle), std::sin(angle)}});
      std::vector<unsigned int> number;
      for (unsigned int p = 0; p < 2 * n_half; ++p)
      {
        const Point<3> &x = p < n_half ? half_points[p] : mirrored(half_points[p - n_half]);
        const auto [c, s] = turns.back();
        const Point<3> place(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2] + height);
        const auto [entry, is_new] = known.emplace(key_of(place), ring_points.size());
        owned.push_back(is_new ? entry->second : none);
        number.push_back(entry->second);
        if (is_new)
          ring_points.push_back(place);
      }
      for (const bool image : {false, true})
        for (const auto &half_cell : half_cells)
        {
          std::array<unsigned int, 8> cell;
          for (unsigned int v = 0; v < 8; ++v) // mirrored, then reordered: right-handed
            cell[v] = number[image ? n_half + half_cell[v ^ 1] : half_cell[v]];
          ring_cells.push_back(cell);
        }
    }
  }

  std::array<std::complex<double>, 3> RingBody::value(const Sample &sample,
                                                      const SectorMotion &motion) const
  {
    const ComplexField &field = sample.of_shell ? motion.shell : motion.solid;
    std::array<std::complex<double>, 3> sum{};
    for (const auto &[dof, vector] : sample.terms)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += vector[d] * std::complex<double>(field.real[dof], field.imaginary[dof]);
    return sum;
  }

  RingBody::Amplitude RingBody::amplitude(const SectorMotion &one, const SectorMotion &two,
                                          const Samples &at) const
  {
    const std::complex<double> i(0., 1.);
    const unsigned int n_half = half_points.size();
    Amplitude amplitude(2 * n_half);
    for (unsigned int p = 0; p < n_half; ++p)
    {
      const auto first = value(at[p], one), second = value(at[p], two);
      const auto image_of_first = mirrored(first), image_of_second = mirrored(second);
      for (unsigned int d = 0; d < 3; ++d)
      {
        amplitude[p][d]          = first[d] + i * second[d];
        amplitude[n_half + p][d] = image_of_first[d] + i * image_of_second[d];
      }
    }
    return amplitude;
  }

  RingBody::Amplitude
  RingBody::lift(const std::function<std::complex<double>(const double theta)> &height_at) const
  {
    const unsigned int n_half = half_points.size();
    Amplitude amplitude(2 * n_half, {{0., 0., 0.}});
    for (unsigned int p = 0; p < n_half; ++p)
    {
      const double theta       = std::atan2(half_points[p][1], half_points[p][0]);
      amplitude[p][2]          = height_at(theta);
      amplitude[n_half + p][2] = height_at(-theta);
    }
    return amplitude;
  }

  void RingBody::add(const unsigned int sector, const std::complex<double> factor,
                     const Amplitude &amplitude, Displacement &displacement) const
  {
    const auto [c, s]         = turns[sector];
    const unsigned int *owner = owned.data() + sector * amplitude.size();
    for (unsigned int p = 0; p < amplitude.size(); ++p)
      if (owner[p] != none)
      {
        std::array<double, 3> u;
        for (unsigned int d = 0; d < 3; ++d)
          u[d] = factor.real() * amplitude[p][d].real() - factor.imag() * amplitude[p][d].imag();
        Tensor<1, 3> &sum = displacement[owner[p]];
        sum[0] += c * u[0] - s * u[1];
        sum[1] += s * u[0] + c * u[1];
        sum[2] += u[2];
      }
  }
} // namespace ringmotor
