// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/no_index.h>
#include <ringmotor/output/ring_grid.h>
#include <ringmotor/pictures/place_key.h>
#include <ringmotor/pictures/turned.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <map>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Lattice indices of a Lagrange hexahedron's nodes in the order of VTK: corners, edges, faces,
     * inside. */
    std::vector<unsigned int> nodes_in_vtk_order(const unsigned int order)
    {
      const auto index = [&](const unsigned int i, const unsigned int j, const unsigned int k)
      { return i + (order + 1) * (j + (order + 1) * k); };
      constexpr unsigned int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      std::vector<unsigned int> nodes;
      for (const unsigned int k : {0u, order})
        for (const auto &[i, j] : around)
          nodes.push_back(index(order * i, order * j, k));
      for (const unsigned int k : {0u, order})
        for (const bool far : {false, true})
        {
          for (unsigned int i = 1; i < order; ++i)
            nodes.push_back(index(i, far ? order : 0, k));
          for (unsigned int j = 1; j < order; ++j)
            nodes.push_back(index(far ? 0 : order, j, k));
        }
      for (const auto &[i, j] : around)
        for (unsigned int k = 1; k < order; ++k)
          nodes.push_back(index(order * i, order * j, k));
      for (unsigned int normal = 0; normal < 3; ++normal)
        for (const unsigned int side : {0u, order})
          for (unsigned int b = 1; b < order; ++b)
            for (unsigned int a = 1; a < order; ++a)
              nodes.push_back(normal == 0   ? index(side, a, b)
                              : normal == 1 ? index(a, side, b)
                                            : index(a, b, side));
      for (unsigned int k = 1; k < order; ++k)
        for (unsigned int j = 1; j < order; ++j)
          for (unsigned int i = 1; i < order; ++i)
            nodes.push_back(index(i, j, k));
      return nodes;
    }

    /** Points of a sector that cells of the same material have in common, numbered. */
    struct SharedPoints
    {
      explicit SharedPoints(const SectorField &field)
      {
        for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
        {
          const SectorField::Cell &of = field.cells[cell];
          of_cell.emplace_back();
          for (unsigned int point = 0; point < of.points.size(); ++point)
          {
            const auto [entry, is_new] =
                numbers.emplace(std::make_pair(of.material, key_of(of.points[point])), n_points);
            n_points += is_new;
            of_cell.back().push_back(entry->second);
          }
        }
      }

      /** The number of a point, or `none`. */
      unsigned int number(const types::material_id material, const Point<3> &place) const
      {
        const auto found = numbers.find({material, key_of(place)});
        return found == numbers.end() ? none : found->second;
      }

      unsigned int n_points = 0;
      std::vector<std::vector<unsigned int>> of_cell; ///< numbers of the lattice's points
    private:
      std::map<std::pair<types::material_id, PlaceKey>, unsigned int> numbers;
    };
  } // namespace

  RingGrid::RingGrid(const SectorField &field) : field(field)
  {
    const SharedPoints shared(field);
    const unsigned int n_sectors = field.n_sectors;
    // By number in the sector: among those of its own, or as a point of the sector before
    std::vector<unsigned int> as_own(shared.n_points, none), before(shared.n_points, none);
    const double angle = angle_of(1);
    for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
      for (unsigned int point = 0; point < shared.of_cell[cell].size(); ++point)
      {
        const unsigned int number = shared.of_cell[cell][point];
        if (as_own[number] != none || before[number] != none)
          continue;
        const SectorField::Cell &of = field.cells[cell];
        const unsigned int there =
            shared.number(of.material, turned(of.points[point], std::cos(angle), std::sin(angle)));
        // Where there are two sectors only, each is before and behind the other.
        if (there != none && there != number && n_sectors > 2)
          before[number] = there;
        else
        {
          as_own[number] = own.size();
          own.push_back({cell, point});
        }
      }

    std::vector<Point<3>> points;
    std::vector<std::int32_t> cells;
    std::vector<float> materials;
    const std::vector<unsigned int> order = nodes_in_vtk_order(field.order);
    for (unsigned int sector = 0; sector < n_sectors; ++sector)
    {
      const double cosine = std::cos(angle_of(sector)), sine = std::sin(angle_of(sector));
      for (const Place &place : own)
      {
        const SectorField::Cell &cell = field.cells[place.cell];
        points.push_back(turned(cell.points[place.point], cosine, sine));
        materials.push_back(cell.material);
      }
      const std::size_t first        = sector * own.size(),
                        first_before = (sector + n_sectors - 1) % n_sectors * own.size();
      for (const std::vector<unsigned int> &lattice : shared.of_cell)
        for (const unsigned int node : order)
        {
          const unsigned int number = lattice[node];
          cells.push_back(before[number] == none ? first + as_own[number]
                                                 : first_before + as_own[before[number]]);
        }
    }
    grid = std::make_unique<VtuGrid>(points, cells, order.size(), VtuCell::lagrange_hexahedron);
    grid->add({"material", "", 1, materials});
  }

  double RingGrid::angle_of(const unsigned int sector) const
  {
    return 2. * numbers::PI * sector / field.n_sectors;
  }

  void RingGrid::write(const std::string &path, const double time_angle, const Warp &warp) const
  {
    PointField displacement{"displacement", "m", 3, {}};
    displacement.values.reserve(3 * own.size() * field.n_sectors);
    for (unsigned int sector = 0; sector < field.n_sectors; ++sector)
    {
      const double angle = angle_of(sector), cosine = std::cos(angle), sine = std::sin(angle);
      const auto phase = std::polar(1., time_angle - field.nodal_diameter * angle);
      for (const Place &place : own)
      {
        const SectorField::Cell &cell = field.cells[place.cell];
        const Point<3> &at            = cell.points[place.point];
        const auto motion             = turned(cell.displacement[place.point], cosine, sine);
        const double lift             = warp.height(angle + std::atan2(at[1], at[0]));
        for (unsigned int d = 0; d < 3; ++d)
          displacement.values.push_back(
              static_cast<float>(std::real(phase * motion[d]) + (d == 2 ? lift : 0.)));
      }
    }
    grid->write(path, {displacement});
  }
} // namespace ringmotor
