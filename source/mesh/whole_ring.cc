// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/sector_cuts.h>
#include <ringmotor/mesh/whole_ring.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The shape of a sector, repeated around the z axis. */
    template <int dim>
    class RepeatedManifold : public Manifold<dim, 3>
    {
    public:
      RepeatedManifold(const Manifold<dim, 3> &of_sector, const unsigned int n_sectors)
          : of_sector(of_sector.clone()), n_sectors(n_sectors)
      {
      }

      std::unique_ptr<Manifold<dim, 3>> clone() const override
      {
        return std::make_unique<RepeatedManifold<dim>>(*of_sector, n_sectors);
      }

      Point<3> get_new_point(const ArrayView<const Point<3>> &points,
                             const ArrayView<const double> &weights) const override
      {
        Point<3> mean;
        for (std::size_t i = 0; i < points.size(); ++i)
          mean += weights[i] * points[i];
        const double pitch = 2. * numbers::PI / n_sectors;
        const double angle = pitch * std::round(cylindrical(mean)[1] / pitch);
        std::vector<Point<3>> of_first;
        for (const Point<3> &point : points)
          of_first.push_back(turned(point, -angle));
        return turned(of_sector->get_new_point(make_array_view(of_first), weights), angle);
      }

    private:
      static Point<3> turned(const Point<3> &x, const double angle)
      {
        const double cosine = std::cos(angle), sine = std::sin(angle);
        return Point<3>(cosine * x[0] - sine * x[1], sine * x[0] + cosine * x[1], x[2]);
      }

      const std::unique_ptr<const Manifold<dim, 3>> of_sector;
      const unsigned int n_sectors;
    };

    /** The copies of the cells of solids (dim = 3) or of a shell (dim = 2). */
    template <int dim>
    class Copies
    {
    public:
      using Cells = Triangulation<dim, 3>;

      Copies(const SectorMesh &part, const Cells &cells);

      std::unique_ptr<parallel::shared::Triangulation<dim, 3>>
      triangulation(MPI_Comm communicator) const;

    private:
      using Vertices = std::vector<unsigned int>;

      /** A copy: the sector that it lies in, and whether it is mirrored. */
      struct Copy
      {
        unsigned int sector;
        bool is_mirrored;
      };

      void find_planes();
      void match_cuts();
      void add(const Copy &copy);
      unsigned int vertex(const unsigned int original, Copy copy);
      /** Ascending. */
      template <typename Object>
      Vertices vertices_of(const Object &object, const Copy &copy);

      const SectorMesh &part;
      const Cells &cells;
      std::map<types::boundary_id, std::set<unsigned int>> on_plane; ///< vertices
      std::map<unsigned int, unsigned int> low_of_high;              ///< of a whole sector
      std::map<std::array<unsigned int, 3>, unsigned int> number;
      std::vector<Point<3>> points;
      std::vector<CellData<dim>> data;
      std::map<Vertices, types::boundary_id> faces, lines;
    };

    template <int dim>
    Copies<dim>::Copies(const SectorMesh &part, const Cells &cells) : part(part), cells(cells)
    {
      find_planes();
      match_cuts();
      for (unsigned int sector = 0; sector < part.n_sectors; ++sector)
      {
        add({sector, false});
        if (part.form == SectorForm::half)
          add({sector, true});
      }
    }

    template <int dim>
    void Copies<dim>::find_planes()
    {
      for (const auto &cell : cells.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && ids::is_plane(face->boundary_id()))
            for (const unsigned int i : face->vertex_indices())
              on_plane[face->boundary_id()].insert(face->vertex_index(i));
    }

    template <int dim>
    void Copies<dim>::match_cuts()
    {
      const std::vector<Point<3>> &vertices = cells.get_vertices();
      for (const unsigned int high : on_plane[ids::cut_high])
      {
        const Point<3> place = cylindrical(vertices[high]);
        for (const unsigned int low : on_plane[ids::cut_low])
          if (const Point<3> other = cylindrical(vertices[low]);
              is_same_place(place[0], other[0], place[0]) &&
              is_same_place(place[2], other[2], place[0]))
            low_of_high[high] = low;
        Assert(low_of_high.count(high) > 0, ExcMessage("The cuts do not match."));
      }
    }

    template <int dim>
    unsigned int Copies<dim>::vertex(unsigned int original, Copy copy)
    {
      const unsigned int n = part.n_sectors;
      const auto is_on     = [&](const types::boundary_id plane)
      {
        const auto found = on_plane.find(plane);
        return found != on_plane.end() && found->second.count(original) > 0;
      };
      if (is_on(ids::mirror))
        copy.is_mirrored = false;
      else if (is_on(ids::cut) && copy.is_mirrored) // that of the sector before
        copy = {(copy.sector + n - 1) % n, false};
      else if (is_on(ids::cut_high))
      {
        original = low_of_high.at(original);
        copy     = {(copy.sector + 1) % n, false};
      }
      const auto [entry, is_new] = number.emplace(
          std::array<unsigned int, 3>{{original, copy.sector, copy.is_mirrored}}, points.size());
      if (is_new)
      {
        Point<3> place = cylindrical(cells.get_vertices()[original]);
        place[1] = (copy.is_mirrored ? -place[1] : place[1]) + 2. * numbers::PI * copy.sector / n;
        points.push_back(cartesian(place));
      }
      return entry->second;
    }

    template <int dim>
    template <typename Object>
    typename Copies<dim>::Vertices Copies<dim>::vertices_of(const Object &object, const Copy &copy)
    {
      Vertices vertices;
      for (const unsigned int i : object->vertex_indices())
        vertices.push_back(vertex(object->vertex_index(i), copy));
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }

    template <int dim>
    void Copies<dim>::add(const Copy &copy)
    {
      for (const auto &cell : cells.active_cell_iterators())
      {
        CellData<dim> copied;
        copied.material_id = cell->material_id();
        for (const unsigned int i : cell->vertex_indices()) // a mirror turns the first direction
          copied.vertices[i] = vertex(cell->vertex_index(copy.is_mirrored ? i ^ 1u : i), copy);
        data.push_back(copied);
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && !ids::is_plane(face->boundary_id()))
            faces[vertices_of(face, copy)] = face->boundary_id();
        if constexpr (dim == 3)
          for (const unsigned int line : cell->line_indices())
            if (part.bars.count(cell->line(line)->boundary_id()) > 0)
              lines[vertices_of(cell->line(line), copy)] = cell->line(line)->boundary_id();
      }
    }

    template <typename Object>
    std::vector<unsigned int> sorted_vertices(const Object &object)
    {
      std::vector<unsigned int> vertices;
      for (const unsigned int i : object->vertex_indices())
        vertices.push_back(object->vertex_index(i));
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }

    template <int dim>
    std::unique_ptr<parallel::shared::Triangulation<dim, 3>>
    Copies<dim>::triangulation(const MPI_Comm communicator) const
    {
      auto ring                         = empty_triangulation<dim>(communicator);
      std::vector<CellData<dim>> copied = data;
      GridTools::consistently_order_cells(copied);
      ring->create_triangulation(points, copied, SubCellData());
      for (const auto &cell : ring->active_cell_iterators())
      {
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(faces.at(sorted_vertices(face)));
        if constexpr (dim == 3)
          for (const unsigned int line : cell->line_indices())
            if (const auto bar = lines.find(sorted_vertices(cell->line(line))); bar != lines.end())
              cell->line(line)->set_boundary_id(bar->second);
      }
      ring->set_all_manifold_ids(0);
      ring->set_manifold(0, RepeatedManifold<dim>(cells.get_manifold(0), part.n_sectors));
      return ring;
    }
  } // namespace

  SectorMesh whole_ring(const SectorMesh &part, const MPI_Comm communicator)
  {
    if (part.form == SectorForm::ring)
      return copy_of(part, communicator);
    SectorMesh ring{Copies<3>(part, *part.triangulation).triangulation(communicator),
                    SectorForm::ring, 1};
    ring.has_cuts    = false;
    ring.sections    = part.sections;
    ring.bars        = part.bars;
    ring.foundations = part.foundations;
    if (part.shell)
      ring.shell = Copies<2>(part, *part.shell).triangulation(communicator);
    return ring;
  }
} // namespace ringmotor
